#include "practice/loop/practice_loop.hpp"

#include <cmath>
#include <ctime>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "practice/loop/simulated_world.hpp"
#include "search/thread_time.hpp"

namespace praxis::practice {

namespace {

constexpr std::uint64_t kTestTasks = 4, kTests = 5;

void check(const PracticeOptions& options) {
    if (options.cycles < 0 || options.cycle_steps < 0 || options.learn_every < 0 || options.score_every < 1 ||
        options.test_tasks < 0 || options.test_every < 0 || options.situations < 1 || options.replans < 0 ||
        !(options.bonus >= 0) || std::isinf(options.bonus))
        throw std::invalid_argument(
            "cycles, steps, tasks and the bonus must be finite and not negative, and there must be one "
            "situation at least");
    if (options.candidates != "tried" && options.candidates != "all")
        throw std::invalid_argument("candidates are 'tried' or 'all', not '" + options.candidates + "'");
}

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

PracticeLoop::PracticeLoop(const Environment& environment, World& world, const PracticeOptions& options)
    : world_(&world), learner_((check(options), environment), options) {
    if (cycle_steps() < 1)
        throw std::invalid_argument(
            "the environment does not say how many skills a cycle takes; give cycle_steps");
    method_ = make_method(options.method, learner_);
}

int PracticeLoop::cycle_steps() const {
    const int steps = learner_.options().cycle_steps;
    return steps > 0 ? steps : learner_.skills().environment().description().cycle_steps;
}

void PracticeLoop::step(const Decision& decision, const std::function<void()>& on_learned) {
    world_->execute(learner_.skills().skill(decision.skill), decision.parameters);
    Moment after = learner_.moment(world_->observe());
    const bool success = learner_.observe(now_, decision, after);
    method_->observe(now_, decision, after, success, false);
    now_ = std::move(after);
    const int interval = learner_.options().learn_every;
    if (interval > 0 && learner_.transitions() - learned_ >= interval) learn(on_learned);
}

void PracticeLoop::learn(const std::function<void()>& on_learned) {
    learned_ = learner_.transitions();
    learner_.learn();
    method_->learned();
    if (on_learned) on_learned();
}

bool PracticeLoop::run_cycle(std::stop_token stop, const std::function<void()>& on_learned) {
    const SkillTask& skills = learner_.skills();
    const std::vector<Fact> goal = skills.goal(world_->next_task());
    now_ = learner_.moment(world_->observe());
    method_->begin_task({now_.values, goal}, false);
    const std::int64_t begin = learner_.transitions();
    const std::int64_t end = begin + cycle_steps();
    const auto more = [&] { return learner_.transitions() < end && !stop.stop_requested(); };
    for (int i = 0; i < skills.environment().description().horizon && more(); ++i) {
        if (all_hold(goal, now_.values.data())) break;
        const std::optional<Decision> decision = method_->pursue(now_, goal, learner_.random(), false);
        if (!decision) break;
        step(*decision, on_learned);
    }
    method_->begin_practice();
    while (more()) {
        const std::optional<Decision> decision = method_->practise(now_);
        if (!decision) break;
        step(*decision, on_learned);
    }
    if (stop.stop_requested() || learner_.transitions() == begin) return false;
    if (learned_ < learner_.transitions()) learn(on_learned);
    method_->end_cycle();
    return true;
}

bool PracticeLoop::solves(const SimulatedEnvironment& environment, const PracticeTask& task, Random& random) {
    const SkillTask& skills = learner_.skills();
    const std::vector<Fact> goal = skills.goal(task.goal);
    Moment now = learner_.moment(task.initial);
    method_->begin_task({now.values, goal}, true);
    for (int i = 0; i < environment.description().horizon; ++i) {
        if (all_hold(goal, now.values.data())) return true;
        const std::optional<Decision> decision = method_->pursue(now, goal, random, true);
        if (!decision) return false;
        Moment after{now.state, {}};
        environment.execute(after.state, skills.skill(decision->skill), decision->parameters, random);
        skills.read(after.state, after.values);
        const bool success = skills.succeeded(decision->skill, now.values, after.values);
        method_->observe(now, *decision, after, success, true);
        now = std::move(after);
    }
    return all_hold(goal, now.values.data());
}

RunResult run_practice(const SimulatedEnvironment& environment, const PracticeOptions& options,
                       const PracticeHooks& hooks, const std::string& journal_path) {
    SimulatedWorld simulated(environment, options.seed, options.reset);
    std::optional<Journal> journal;
    std::optional<JournaledWorld> journaled;
    if (!journal_path.empty()) {
        journal.emplace(journal_path, settings_text(environment, options));
        journaled.emplace(simulated, *journal);
    }
    World& world = journaled ? static_cast<World&>(*journaled) : simulated;

    RunResult result;
    result.environment = environment.description().name;
    result.method = options.method;
    result.seed = options.seed;
    double start = thread_seconds();
    PracticeLoop loop(environment, world, options);
    std::vector<PracticeTask> tests;
    for (int i = 0; i < options.test_tasks; ++i) {
        Random random = random_stream(options.seed, kTestTasks, static_cast<std::uint64_t>(i));
        tests.push_back(environment.sample_task(random));
    }
    int cycle = 0;
    const auto test = [&] {
        const double practised = thread_seconds();
        result.processor_seconds += practised - start;
        const std::int64_t transitions = loop.learner().transitions();
        int solved = 0;
        for (std::size_t i = 0; i < tests.size(); ++i) {
            Random random = random_stream(random_stream(options.seed, kTests, i).next(), kTests,
                                          static_cast<std::uint64_t>(transitions));
            solved += loop.solves(environment, tests[i], random);
        }
        result.curve.push_back(
            {cycle, transitions,
             tests.empty() ? 0 : static_cast<double>(solved) / static_cast<double>(tests.size())});
        start = thread_seconds();
        result.evaluation_seconds += start - practised;
        if (hooks.on_test) hooks.on_test(result);
    };
    const auto test_if_due = [&] {
        if (loop.learner().transitions() - result.curve.back().transitions >= options.test_every) test();
    };
    test();
    for (cycle = 1; cycle <= options.cycles; ++cycle) {
        if (!loop.run_cycle(hooks.stop,
                            options.test_every > 0 ? std::function<void()>(test_if_due) : nullptr))
            break;
        for (PracticeChoice& choice : loop.method().take_choices())
            result.choices.push_back(std::move(choice));
        if (journal) journal->sync();
        if (result.curve.back().transitions < loop.learner().transitions()) test();
    }
    return result;
}

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
