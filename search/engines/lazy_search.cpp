#include <algorithm>

#include "search/engines/random.hpp"
#include "search/engines/search_context.hpp"
#include "search/state/record_pool.hpp"

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
          is_preferred_(evaluator_.has_preferred() ? space_.task().operator_count() : 0, false),
          filed_(1),
          by_cost_(uses_g(context.plan.open) && !space_.uniform_costs()) {}

    Status run() {
        const StateId initial = space_.insert_initial();
        space_.read(initial, values_);
        evaluator_.start(initial, values_);
        if (!visit(initial)) return finished();
        while (!open_->empty()) {
            if (context_.must_stop()) return context_.monitor.status();
            const DeferredEntry entry = open_->pop();
            const StateId parent = entry.parent;
            const OperatorId op(*filed_[entry.first_operator]);
            const std::int64_t real_cost = space_.real_cost(parent);
            if (space_.exceeds_bound(real_cost, op)) continue;
            if (space_.needs_values(op) && parent_ != parent) {
                space_.read(parent, parent_values_);
                parent_ = parent;
            }
            const auto [state, is_new] = space_.successor(parent, op, parent_values_.data());
            const std::int64_t g = space_.g(parent) + space_.cost(op);
            if (is_new || evaluator_.path_dependent()) {
                space_.read(state, values_);
                evaluator_.follow(parent, op, state, values_);
            }
            const std::int64_t cost = real_cost + space_.task().costs[op.index()];
            if (is_new) {
                space_.layout().initialize(space_.node(state), parent, g, cost);
            } else if (context_.plan.reopen_closed && g < space_.g(state) &&
                       space_.status(state) != NodeStatus::dead_end) {
                ++statistics_.reopened;
                space_.layout().improve(space_.node(state), parent, g, cost);
                if (!evaluator_.path_dependent()) space_.read(state, values_);
            } else {
                continue;
            }
            if (!visit(state)) return finished();
        }
        return context_.exhausted();
    }

  private:
    Status finished() const { return context_.best ? Status::solved : context_.monitor.status(); }

    /// Evaluates a state, of which `values_` are the values, and files its successors. False: the search is
    /// over.
    bool visit(StateId state) {
        if (space_.goal_holds(values_)) {
            space_.set_status(state, NodeStatus::closed);
            return context_.found(state);
        }
        ++statistics_.evaluated;
        const std::int64_t g = space_.g(state);
        const bool alive = evaluator_.evaluate(state, values_, g);
        if (!alive || open_->dead_end({evaluator_.estimates(), g})) {
            ++statistics_.dead_ends;
            if (alive) context_.complete = false;
            space_.set_status(state, NodeStatus::dead_end);
            return true;
        }
        space_.set_status(state, NodeStatus::closed);
        if (evaluator_.progress()) open_->boost();
        expand(state, g);
        return true;
    }

    void expand(StateId state, std::int64_t g) {
        ++statistics_.expanded;
        space_.generator().applicable(values_.data(), operators_);
        const std::int64_t real_cost = space_.real_cost(state);
        if (space_.bounded()) {
            std::erase_if(operators_, [&](OperatorId op) { return space_.exceeds_bound(real_cost, op); });
        }
        statistics_.generated += operators_.size();
        const std::vector<OperatorId>& preferred = evaluator_.preferred();
        for (OperatorId op : preferred) is_preferred_[op.index()] = true;
        const auto is_preferred = [&](OperatorId op) { return is_preferred_[op.index()]; };
        if (context_.plan.randomize_successors) random_.shuffle(operators_);
        if (context_.plan.preferred_successors_first && !preferred.empty()) {
            std::stable_partition(operators_.begin(), operators_.end(), is_preferred);
        }
        if (by_cost_) {
            std::stable_sort(operators_.begin(), operators_.end(),
                             [&](OperatorId a, OperatorId b) { return space_.cost(a) < space_.cost(b); });
        }
        if (!file(state, g, Audience::lists_of_all)) context_.complete = false;
        if (preferred.empty()) return;
        std::erase_if(operators_, [&](OperatorId op) { return !is_preferred(op); });
        file(state, g, Audience::lists_of_preferred);
        for (OperatorId op : preferred) is_preferred_[op.index()] = false;
    }

    /// Files the successors by `operators_`, those of one g together. False: no list wanted some of them.
    bool file(StateId state, std::int64_t g, Audience audience) {
        bool wanted = true;
        for (auto begin = operators_.begin(); begin != operators_.end();) {
            const std::int64_t cost = space_.cost(*begin);
            auto end = operators_.end();
            if (by_cost_) {
                end = std::find_if(begin, end, [&](OperatorId op) { return space_.cost(op) != cost; });
            }
            const DeferredEntry entry{state, filed_.size(), static_cast<std::uint32_t>(end - begin)};
            if (open_->push({evaluator_.estimates(), g + cost, audience}, entry)) {
                for (; begin != end; ++begin) {
                    *filed_.next() = begin->index();
                    filed_.commit();
                }
            } else {
                wanted = false;
                begin = end;
            }
        }
        return wanted;
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
    RecordPool filed_;                // the operators of the entries in the open list
    bool by_cost_;                    // operators of different costs lead to different places in it
};

}  // namespace

Status lazy_search(SearchContext& context) {
    return LazySearch(context).run();
}

}  // namespace praxis
