#include <stdexcept>

#include "practice/methods/ees_method.hpp"
#include "practice/methods/maple_q_method.hpp"
#include "practice/methods/other_methods.hpp"
#include "practice/methods/simple_scores.hpp"

namespace praxis::practice {

namespace {

struct Entry {
    MethodInfo info;
    std::unique_ptr<Method> (*make)(Learner&);
};

template <class Made>
std::unique_ptr<Method> make(Learner& learner) {
    return std::make_unique<Made>(learner);
}

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        {{"ees",
          "estimate, extrapolate, situate: the skill whose improvement makes the tasks' plans most likely to "
          "succeed"},
         make<EesMethod>},
        {{"ees-published", "the same, as it was published"}, make<PublishedEesMethod>},
        {{"fail-focus", "the skill that fails most often"}, make<FailFocusMethod>},
        {{"competence-gradient", "the skill whose competence is expected to grow most"},
         make<CompetenceGradientMethod>},
        {{"skill-diversity", "the skill tried least"}, make<SkillDiversityMethod>},
        {{"task-relevant", "a random one of the skills that tasks have used"}, make<TaskRelevantMethod>},
        {{"random-skills", "random skills, without planning to where one can be executed"},
         make<RandomSkillsMethod>},
        {{"task-repeat", "the task again and again, there and back"}, make<TaskRepeatMethod>},
        {{"maple-q", "a learned value function chooses skills and parameters, without plans"},
         make<MapleQMethod>},
    };
    return all;
}

}  // namespace

const std::vector<MethodInfo>& methods() {
    static const std::vector<MethodInfo> infos = [] {
        std::vector<MethodInfo> result;
        for (const Entry& entry : entries()) result.push_back(entry.info);
        return result;
    }();
    return infos;
}

std::unique_ptr<Method> make_method(const std::string& name, Learner& learner) {
    std::string names;
    for (const Entry& entry : entries()) {
        if (entry.info.name == name) return entry.make(learner);
        names += (names.empty() ? "" : ", ") + entry.info.name;
    }
    throw std::invalid_argument("there is no method '" + name + "'; there are " + names);
}

}  // namespace praxis::practice
