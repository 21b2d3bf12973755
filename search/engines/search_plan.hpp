// A search as data: what an engine's component makes of its options, and what the engines run.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "search/engines/call.hpp"
#include "search/engines/key.hpp"
#include "search/engines/open_list.hpp"
#include "search/engines/search_run.hpp"
#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// How a search finds its states' places in the open list.
enum class Expansion {
    eager,  ///< successors are evaluated when they are generated
    lazy,   ///< successors are evaluated when their turn comes
};

struct SearchPlan {
    Expansion expansion = Expansion::eager;
    OpenListPlan open;
    std::vector<std::size_t> preferred;  ///< heuristics whose preferred operators count
    bool reopen_closed = false;
    bool randomize_successors = false;
    bool preferred_successors_first = false;
    CostType cost_type = CostType::normal;      ///< of g
    std::int64_t bound = kInfinity;             ///< plans cost less than this, by the task's costs
    const SharedBound* shared_bound = nullptr;  ///< and less than this; may be null
    double max_time = std::numeric_limits<double>::infinity();
    double max_work = std::numeric_limits<double>::infinity();  ///< in counted seconds (see SearchMonitor)
    bool go_on = false;    ///< after a plan, for cheaper ones; lazy search only
    bool optimal = false;  ///< the first plan found is a cheapest one
    std::uint64_t seed = 0;
};

/// A heuristic of a search, used by any number of keys and for preferred operators.
struct Heuristic {
    std::unique_ptr<Evaluator> evaluator;
    CostType cost_type = CostType::normal;
    bool cheap = false;  ///< evaluating again costs less than remembering
    std::string canonical;
    std::vector<Key> given = {};  ///< what the evaluator is told of each state before it evaluates it
};

/// Turns a checked expression into a plan and its heuristics; equal calls share one heuristic.
class Workshop {
  public:
    explicit Workshop(const SearchRun& run)
        : task_(&run.prepared.task()),
          query_(&run.query),
          shared_(&run.shared),
          seed_(run.seed),
          budget_(run.budget) {}

    SearchPlan search_plan(const Call& call);
    Key key(const Call& call);
    std::vector<Key> keys(const Argument& argument);
    OpenListPlan open_list(const Call& call);
    std::vector<OpenListPlan> open_lists(const Argument& argument);
    /// The numbers of the heuristics that calls of evaluators need.
    std::vector<std::size_t> heuristics_in(const Argument& argument);

    /// The number of the heuristic that `call` stands for, made by `make` if it is new.
    template <class Make>
    std::size_t heuristic(const Call& call, CostType cost_type, bool cheap, const Make& make,
                          std::vector<Key> given = {}) {
        for (std::size_t i = 0; i < heuristics_.size(); ++i) {
            if (heuristics_[i].canonical == call.canonical) return i;
        }
        heuristics_.push_back({make(), cost_type, cheap, call.canonical, std::move(given)});
        return heuristics_.size() - 1;
    }

    const FiniteDomainTask& task() const { return *task_; }
    const std::vector<Fact>& goal() const { return query_->goal; }
    const std::vector<std::int32_t>& initial_values() const { return query_->initial_values; }
    const Budget& budget() const { return budget_; }
    SharedParts& shared() const { return *shared_; }
    std::uint64_t seed() const { return seed_; }
    /// The key never exceeds the real cost of a way to the goal.
    bool admissible(const Key& key) const;
    std::vector<Heuristic> take_heuristics() { return std::move(heuristics_); }

  private:
    const FiniteDomainTask* task_;
    const Query* query_;
    SharedParts* shared_;
    std::uint64_t seed_;
    Budget budget_;
    std::vector<Heuristic> heuristics_;
};

/// A component: its description and the one function that its kind needs.
struct Component {
    ComponentDescription description;
    Key (*key)(const Call& call, Workshop& workshop) = nullptr;
    OpenListPlan (*open_list)(const Call& call, Workshop& workshop) = nullptr;
    SearchPlan (*search_plan)(const Call& call, Workshop& workshop) = nullptr;
    /// For engines that are made of others, instead of `search_plan`.
    Outcome (*composite)(const SearchRun& run, const Call& call) = nullptr;
};

std::vector<Component> evaluator_components();
std::vector<Component> open_list_components();
std::vector<Component> engine_components();
/// All of the above; made once.
const std::vector<Component>& components();

/// A cost type as evaluators' and engines' options name it.
OptionDescription cost_type_option(std::string default_value, std::string help);
CostType cost_type_of(const Call& call);

}  // namespace praxis
