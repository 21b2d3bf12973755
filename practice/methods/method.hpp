// What to do in free time: the methods that are compared, all on one learner.
//
// In *task time* the robot pursues the goal it was given; in *free time* it practises. A method decides what
// is executed next in both, and in tests. Tests may come at any time, and must leave no trace in what is
// practised.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "practice/experiment/results.hpp"
#include "practice/loop/learner.hpp"

namespace praxis::practice {

class Method {
  public:
    virtual ~Method() = default;

    /// A task begins, in task time or in a test.
    virtual void begin_task(const Situation& situation, bool test) = 0;
    /// The next skill towards the goal; none: there is nothing to be done.
    virtual std::optional<Decision> pursue(const Moment& now, const std::vector<Fact>& goal, Random& random,
                                           bool test) = 0;
    /// Free time begins.
    virtual void begin_practice() = 0;
    /// The next skill in free time; none: nothing can be executed at all.
    virtual std::optional<Decision> practise(const Moment& now) = 0;
    /// What came of the last decision. In tests nothing may be learned from it.
    virtual void observe(const Moment& before, const Decision& decision, const Moment& after, bool success,
                         bool test) = 0;
    /// The learner has learned.
    virtual void learned() {}
    /// A cycle ends.
    virtual void end_cycle() {}
    /// The moments of choice since the last call.
    virtual std::vector<PracticeChoice> take_choices() { return {}; }
};

struct MethodInfo {
    std::string name;
    std::string description;  ///< one sentence
};
/// All methods, EES first.
const std::vector<MethodInfo>& methods();
/// Throws std::invalid_argument with the names there are. The learner must outlive the method.
std::unique_ptr<Method> make_method(const std::string& name, Learner& learner);

}  // namespace praxis::practice
