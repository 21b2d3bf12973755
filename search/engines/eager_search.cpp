#include <algorithm>

#include "search/engines/search_context.hpp"

namespace praxis {

namespace {

class EagerSearch {
  public:
    explicit EagerSearch(SearchContext& context)
        : context_(context),
          space_(context.space),
          evaluator_(context.evaluator),
          statistics_(context.monitor.statistics),
          open_(make_open_list<StateId>(context.plan.open)),
          repush_open_(uses_g(context.plan.open)),
          values_(space_.buffer()),
          child_values_(space_.buffer()),
          preferred_(evaluator_.has_preferred() ? space_.task().operator_count() : 0, false) {}

    Status run() {
        const StateId initial = space_.insert_initial();
        space_.read(initial, child_values_);
        evaluator_.start(initial, child_values_);
        open_new(initial, false);
        while (!open_->empty()) {
            if (context_.must_stop()) return context_.monitor.status();
            const StateId state = open_->pop();
            if (space_.status(state) != NodeStatus::open) continue;
            space_.set_status(state, NodeStatus::closed);
            space_.read(state, values_);
            if (space_.goal_holds(values_)) {
                context_.found(state);
                return Status::solved;
            }
            if (!expand(state)) return context_.monitor.status();
        }
        return context_.exhausted();
    }

  private:
    bool expand(StateId state) {
        ++statistics_.expanded;
        const std::int64_t real_cost = space_.real_cost(state);
        space_.generator().applicable(values_.data(), operators_);
        if (space_.bounded()) {
            std::erase_if(operators_, [&](OperatorId op) { return space_.exceeds_bound(real_cost, op); });
        }
        const std::int64_t g = space_.g(state);
        if (evaluator_.has_preferred()) {
            evaluator_.evaluate_preferred(state, values_, g);
            preferred_operators_ = evaluator_.preferred();
            mark_preferred(true);
        }
        const std::span<const OperatorId> all = operators_;
        for (std::size_t begin = 0; begin < all.size(); begin += SearchSpace::kBatch) {
            const auto batch = all.subspan(begin, std::min(SearchSpace::kBatch, all.size() - begin));
            space_.prepare_successors(state, batch, values_.data());
            for (std::size_t i = 0; i < batch.size(); ++i) {
                if (context_.must_stop()) return false;
                ++statistics_.generated;
                reach(state, batch[i], space_.successor(i), g + space_.cost(batch[i]),
                      real_cost + space_.task().costs[batch[i].index()]);
            }
        }
        if (evaluator_.has_preferred()) mark_preferred(false);
        return true;
    }

    void reach(StateId parent, OperatorId op, std::pair<StateId, bool> found, std::int64_t g,
               std::int64_t real_cost) {
        const auto [state, is_new] = found;
        const bool preferred = evaluator_.has_preferred() && preferred_[op.index()];
        if (is_new) {
            space_.layout().initialize(space_.node(state), parent, g, real_cost);
            space_.read_successor(values_, op, child_values_);
            evaluator_.follow(parent, op, state, child_values_);
            open_new(state, preferred);
            return;
        }
        const bool cheaper = g < space_.g(state) && space_.status(state) != NodeStatus::dead_end;
        if (evaluator_.path_dependent() || (cheaper && evaluator_.restores_from_values())) {
            space_.read_successor(values_, op, child_values_);
            evaluator_.follow(parent, op, state, child_values_);
        }
        if (cheaper) {
            space_.layout().improve(space_.node(state), parent, g, real_cost);
            open_again(state, preferred);
        }
    }

    // `child_values_` are those of the state.
    void open_new(StateId state, bool preferred) {
        ++statistics_.evaluated;
        const bool alive = evaluator_.evaluate(state, child_values_, space_.g(state));
        const Evaluated evaluated{evaluator_.estimates(), space_.g(state), audience(preferred)};
        if (!alive || open_->dead_end(evaluated)) {
            ++statistics_.dead_ends;
            if (alive) context_.complete = false;
            space_.set_status(state, NodeStatus::dead_end);
            return;
        }
        evaluator_.remember(space_.layout(), space_.node(state));
        if (evaluator_.progress()) open_->boost();
        if (!open_->push(evaluated, state)) context_.complete = false;
    }

    // A cheaper way to a known state.
    void open_again(StateId state, bool preferred) {
        if (space_.status(state) == NodeStatus::closed) {
            if (!context_.plan.reopen_closed) return;
            ++statistics_.reopened;
            space_.set_status(state, NodeStatus::open);
        } else if (!repush_open_) {
            return;
        }
        evaluator_.restore(space_.layout(), space_.node(state), child_values_);
        open_->push({evaluator_.estimates(), space_.g(state), audience(preferred)}, state);
    }

    static Audience audience(bool preferred) {
        return preferred ? Audience::all_lists : Audience::lists_of_all;
    }

    void mark_preferred(bool mark) {
        for (OperatorId op : preferred_operators_) preferred_[op.index()] = mark;
    }

    SearchContext& context_;
    SearchSpace& space_;
    StateEvaluator& evaluator_;
    SearchStatistics& statistics_;
    std::unique_ptr<OpenList<StateId>> open_;
    bool repush_open_;  // an open state's place depends on g
    std::vector<std::int32_t> values_;
    std::vector<std::int32_t> child_values_;
    std::vector<OperatorId> operators_;
    std::vector<OperatorId> preferred_operators_;
    std::vector<bool> preferred_;  // by operator
};

}  // namespace

Status eager_search(SearchContext& context) {
    return EagerSearch(context).run();
}

}  // namespace praxis
