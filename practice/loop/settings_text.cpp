#include "practice/loop/settings_text.hpp"

#include <cstdint>
#include <sstream>
#include <vector>

namespace praxis::practice {

namespace {

/// Of all that a description says (64-bit FNV-1a).
class Digest {
  public:
    Digest& operator<<(const std::string& text) {
        for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        value_ = (value_ ^ 0xff) * 0x100000001b3u;
        return *this;
    }
    Digest& operator<<(const std::vector<std::string>& texts) {
        for (const std::string& text : texts) *this << text;
        return *this << std::to_string(texts.size());
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::uint64_t digest(const Description& description) {
    Digest digest;
    digest << description.domain << description.problem << description.predicates << description.objects
           << std::to_string(description.horizon) << std::to_string(description.cycle_steps);
    for (const SkillSchema& schema : description.schemas) {
        digest << schema.name << schema.parameters << schema.features;
        for (const std::size_t feature : schema.relevant_features) digest << std::to_string(feature);
    }
    return digest.value();
}

std::string classifier_text(const ClassifierOptions& o) {
    std::ostringstream text;
    text.precision(17);
    text << o.kind << ":" << o.differences << ":";
    for (const std::size_t units : o.hidden) text << units << ";";
    text << ":" << o.steps << ":" << o.learning_rate << ":" << o.weight_decay << ":" << o.neighbours << ":"
         << o.members;
    return text.str();
}

}  // namespace

std::string settings_text(const Environment& environment, const PracticeOptions& o) {
    std::ostringstream text;
    text.precision(17);
    text << environment.description().name << "(" << std::hex << digest(environment.description()) << std::dec
         << ") method=" << o.method << " seed=" << o.seed << " cycle_steps=" << o.cycle_steps
         << " learn_every=" << o.learn_every << " test_tasks=" << o.test_tasks
         << " test_every=" << o.test_every << " reset=" << o.reset << " candidates=" << o.candidates
         << " score_every=" << o.score_every << " bonus=" << o.bonus << " situations=" << o.situations
         << " replans=" << o.replans << " sharing=" << o.sharing << " competence=" << o.competence.model
         << "(" << o.competence.prior.successes << "," << o.competence.prior.failures << ","
         << o.competence.window << "," << o.competence.recency << "," << o.competence.bonus
         << ") policy=" << classifier_text(o.policy.classifier) << "(" << o.policy.candidates << ","
         << o.policy.exploration << "," << o.policy.epsilon << "," << o.policy.features
         << ") planner=" << o.planner.most_states << "," << o.planner.search << ","
         << o.planner.search_seconds;
    return text.str();
}

}  // namespace praxis::practice
