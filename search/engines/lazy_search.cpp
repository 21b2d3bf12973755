#include <algorithm>

#include "search/engines/random.hpp"
#include "search/engines/search_context.hpp"

namespace praxis {

namespace {

class LazySearch {
  public:
    explicit LazySearch(SearchContext& context)
        : context_(context),
          space_(context.space),
          evaluator_(context.evaluator),
          statistics_(context.monitor.statistics),
          open_(make_open_list<DeferredEntry>(context.plan.open)),
          random_(context.plan.seed),
          values_(space_.buffer()),
          parent_values_(space_.buffer()),
          is_preferred_(evaluator_.has_preferred() ? space_.task().operator_count() : 0, false) {}

    Status run() {
        const StateId initial = space_.insert_initial();
        space_.read(initial, values_);
        evaluator_.start(initial, values_);
        if (!visit(initial)) return finished();
        while (!open_->empty()) {
            if (context_.must_stop()) return context_.monitor.status();
            const DeferredEntry entry = open_->pop();
            const std::int64_t real_cost = space_.real_cost(entry.parent);
            if (space_.exceeds_bound(real_cost, entry.op)) continue;
            if (space_.needs_values(entry.op) && parent_ != entry.parent) {
                space_.read(entry.parent, parent_values_);
                parent_ = entry.parent;
            }
            const auto [state, is_new] = space_.successor(entry.parent, entry.op, parent_values_.data());
            const std::int64_t g = space_.g(entry.parent) + space_.cost(entry.op);
            if (is_new || evaluator_.path_dependent()) {
                space_.read(state, values_);
                evaluator_.follow(entry.parent, entry.op, state, values_);
            }
            const std::int64_t cost = real_cost + space_.task().costs[entry.op.index()];
            if (is_new) {
                space_.layout().initialize(space_.node(state), entry.parent, g, cost);
            } else if (context_.plan.reopen_closed && g < space_.g(state) &&
                       space_.status(state) != NodeStatus::dead_end) {
                ++statistics_.reopened;
                space_.layout().improve(space_.node(state), entry.parent, g, cost);
                if (!evaluator_.path_dependent()) space_.read(state, values_);
            } else {
                continue;
            }
            if (!visit(state)) return finished();
        }
        return context_.exhausted();
    }

  private:
    Status finished() const { return context_.goal ? Status::solved : context_.monitor.status(); }

    /// Evaluates a state, of which `values_` are the values, and files its successors. False: the search is
    /// over.
    bool visit(StateId state) {
        if (space_.goal_holds(values_)) {
            context_.goal = state;
            return false;
        }
        ++statistics_.evaluated;
        const std::int64_t g = space_.g(state);
        const bool alive = evaluator_.evaluate(state, values_, g);
        if (!alive || open_->dead_end({evaluator_.estimates(), g, false})) {
            ++statistics_.dead_ends;
            if (alive) context_.complete = false;
            space_.set_status(state, NodeStatus::dead_end);
            return true;
        }
        space_.set_status(state, NodeStatus::closed);
        if (evaluator_.progress()) open_->boost();
        return expand(state, g);
    }

    bool expand(StateId state, std::int64_t g) {
        ++statistics_.expanded;
        space_.generator().applicable(values_.data(), operators_);
        const std::vector<OperatorId>& preferred = evaluator_.preferred();
        for (OperatorId op : preferred) is_preferred_[op.index()] = true;
        if (context_.plan.randomize_successors) random_.shuffle(operators_);
        if (context_.plan.preferred_successors_first && evaluator_.has_preferred()) {
            std::stable_partition(operators_.begin(), operators_.end(),
                                  [&](OperatorId op) { return is_preferred_[op.index()]; });
        }
        const std::int64_t real_cost = space_.real_cost(state);
        bool going = true;
        for (OperatorId op : operators_) {
            if (context_.must_stop()) {
                going = false;
                break;
            }
            if (space_.exceeds_bound(real_cost, op)) continue;
            ++statistics_.generated;
            const bool is_preferred = evaluator_.has_preferred() && is_preferred_[op.index()];
            const Evaluated evaluated{evaluator_.estimates(), g + space_.cost(op), is_preferred};
            if (!open_->push(evaluated, {state, op})) context_.complete = false;
        }
        for (OperatorId op : preferred) is_preferred_[op.index()] = false;
        return going;
    }

    SearchContext& context_;
    SearchSpace& space_;
    StateEvaluator& evaluator_;
    SearchStatistics& statistics_;
    std::unique_ptr<OpenList<DeferredEntry>> open_;
    Random random_;
    std::vector<std::int32_t> values_;
    std::vector<std::int32_t> parent_values_;
    StateId parent_;  // whose values `parent_values_` are
    std::vector<OperatorId> operators_;
    std::vector<bool> is_preferred_;  // by operator
};

}  // namespace

Status lazy_search(SearchContext& context) {
    return LazySearch(context).run();
}

}  // namespace praxis
