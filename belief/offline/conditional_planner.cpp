#include "belief/offline/conditional_planner.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "belief/offline/situation.hpp"
#include "belief/offline/working_nodes.hpp"

namespace praxis::belief {
namespace {

constexpr std::size_t kMostBranches = 2'000;  // readings one after the other; bounds the recursion

using Key = std::vector<std::uint32_t>;
using Steps = std::shared_ptr<const std::vector<OperatorId>>;
using Result = ConditionalPlanResult;
using Reuse = ConditionalPlannerOptions::Reuse;

class Builder {
  public:
    Builder(const KnowledgePlanner& planner, const std::optional<std::vector<WorldState>>& worlds,
            const ConditionalPlannerOptions& options, const Budget& budget)
        : planner_(planner),
          task_(planner.compilation().belief()),
          options_(options),
          budget_(budget),
          worlds_(worlds) {
        if (worlds_) table_.emplace(planner.compilation().shared_belief());
        situations_.emplace(task_, table_ ? &*table_ : nullptr, options.most_outcomes);
        if (table_) working_.emplace(*table_, draft_);
    }

    Result operator()() {
        if (const std::optional<std::uint32_t> first = start()) {
            result_.plan = draft_.finish(*first);
            result_.status = Result::Status::found;
        }
        return std::move(result_);
    }

  private:
    struct Link {
        Key key;
        std::uint32_t action;
    };
    /// A stretch of actions without a choice.
    struct Chain {
        std::vector<Link> links;
        std::map<Key, std::size_t> places;
    };

    std::nullopt_t fail(Result::Status status, std::string message) {
        result_.status = status;
        result_.message = std::move(message);
        return std::nullopt;
    }

    std::optional<std::uint32_t> start() {
        Situation first{Belief(planner_.shared_compilation()), {}};
        if (!first.belief.consistent() || (worlds_ && worlds_->empty()))
            return fail(Result::Status::none, "no first state satisfies the initial description");
        if (worlds_) {
            for (const WorldState& world : *worlds_) first.states.push_back(table_->add(world));
            std::sort(first.states.begin(), first.states.end());
            first.states.erase(std::unique(first.states.begin(), first.states.end()), first.states.end());
        }
        std::optional<std::vector<SituationOutcome>> outcomes =
            situations_->outcomes(first, Environment::kStart);
        if (!outcomes) return too_many_outcomes();
        const bool choice = outcomes->size() > 1;
        const std::optional<std::vector<PlanDraft::Edge>> edges =
            branch(std::move(*outcomes), std::make_shared<const std::vector<OperatorId>>(), 0);
        if (!edges) return std::nullopt;
        return choice ? draft_.add(Environment::kStart, *edges) : edges->front().target;
    }

    std::nullopt_t too_many_outcomes() {
        return fail(Result::Status::limit, "too much may be read at once, or it contradicts what is known");
    }

    bool exhausted() {
        if (budget_.exhausted() == Stop::none && draft_.size() < options_.most_nodes &&
            result_.plans < options_.most_plans && branches_ < kMostBranches)
            return false;
        fail(Result::Status::limit, "the plan grew too large, or no time or memory is left");
        return true;
    }

    /// Plans for each outcome; those with many states first, since their plans may serve others.
    std::optional<std::vector<PlanDraft::Edge>> branch(std::vector<SituationOutcome> outcomes,
                                                       const Steps& steps, std::size_t next) {
        std::stable_sort(outcomes.begin(), outcomes.end(), [](const auto& a, const auto& b) {
            return a.situation.states.size() > b.situation.states.size();
        });
        std::vector<PlanDraft::Edge> edges;
        ++branches_;
        for (SituationOutcome& outcome : outcomes) {
            const std::optional<std::uint32_t> node = walk(std::move(outcome.situation), steps, next);
            if (!node) return std::nullopt;
            edges.push_back({std::move(outcome.observation), *node});
        }
        --branches_;
        return edges;
    }

    /// The node for a situation, in which the steps from `next` on may still be good.
    std::optional<std::uint32_t> walk(Situation situation, Steps steps, std::size_t next) {
        Chain chain;
        bool check = true;
        std::optional<std::uint32_t> tail = reusable(situation);
        while (!tail) {
            if (exhausted()) return std::nullopt;
            const Key key = situation.key();
            if (situations_->goal(situation)) {
                tail = draft_.goal();
            } else if (const auto known = nodes_.find(key); known != nodes_.end()) {
                tail = known->second;
            } else if (options_.reuse == Reuse::everywhere && (tail = reusable(situation))) {
                break;
            } else if (!cut_loop(chain, key)) {
                return fail(Result::Status::not_found, "a belief comes back after a reading");
            } else if (!usable(situation, *steps, next, check)) {
                if ((tail = reusable(situation))) break;
                steps = make_plan(situation, key);
                if (!steps) return std::nullopt;
                next = 0;
                check = false;
            } else if (!follow(situation, key, chain, steps, next, check, tail)) {
                return std::nullopt;
            }
        }
        return close(chain, *tail);
    }

    /// One action. False if there is no plan.
    bool follow(Situation& situation, const Key& key, Chain& chain, const Steps& steps, std::size_t& next,
                bool& check, std::optional<std::uint32_t>& tail) {
        const std::uint32_t action = planner_.compilation().origin((*steps)[next++]).action;
        std::optional<std::vector<SituationOutcome>> outcomes = situations_->outcomes(situation, action);
        if (!outcomes) {
            too_many_outcomes();
            return false;
        }
        check = !task_.readings[action].empty() || !task_.sensors.empty();
        if (outcomes->size() == 1) {
            situation = std::move(outcomes->front().situation);
            if (situation.key() == key) return true;
            chain.places.emplace(key, chain.links.size());
            chain.links.push_back({key, action});
            on_path_.insert(key);
            return true;
        }
        on_path_.insert(key);
        const std::optional<std::vector<PlanDraft::Edge>> edges = branch(std::move(*outcomes), steps, next);
        on_path_.erase(key);
        if (!edges) return false;
        const bool same = std::all_of(edges->begin(), edges->end(), [&](const PlanDraft::Edge& edge) {
            return edge.target == edges->front().target;
        });
        // Where nothing depends on what is read, it need not be read.
        const bool needless = same && task_.physical->effects[action].empty();
        tail = needless ? edges->front().target : draft_.add(action, *edges);
        finish(key, *tail);
        return true;
    }

    void finish(const Key& key, std::uint32_t node) {
        nodes_.emplace(key, node);
        if (finished_set_.insert(node).second) finished_.push_back(node);
    }

    std::uint32_t close(Chain& chain, std::uint32_t node) {
        for (; !chain.links.empty(); chain.links.pop_back()) {
            const Link& link = chain.links.back();
            node = draft_.add(link.action, {{{}, node}});
            on_path_.erase(link.key);
            finish(link.key, node);
        }
        return node;
    }

    /// Forgets what the chain did since it was at `key`. False if it was there before the chain.
    bool cut_loop(Chain& chain, const Key& key) {
        if (!on_path_.contains(key)) return true;
        const auto place = chain.places.find(key);
        if (place == chain.places.end()) return false;
        const std::size_t length = place->second;
        for (; chain.links.size() > length; chain.links.pop_back()) {
            on_path_.erase(chain.links.back().key);
            chain.places.erase(chain.links.back().key);
        }
        return true;
    }

    /// Steps over what is superfluous. Whether the plan can go on.
    bool usable(Situation& situation, const std::vector<OperatorId>& steps, std::size_t& next, bool check) {
        while (next < steps.size() && planner_.superfluous(situation.belief, steps[next])) ++next;
        if (next == steps.size()) return false;
        if (check && !planner_.still_good(situation.belief, steps, next)) return false;
        const std::uint32_t action = planner_.compilation().origin(steps[next]).action;
        if (situations_->can(situation, action)) return true;
        if (!situation.belief.can(action)) situation.belief.remember_exception(action);
        return false;
    }

    /// The finished node that is cheapest for the states, if one works for all of them.
    std::optional<std::uint32_t> reusable(const Situation& situation) {
        if (options_.reuse == Reuse::never || !working_ || situation.states.empty() ||
            situations_->goal(situation) || nodes_.contains(situation.key()))
            return std::nullopt;
        const std::optional<std::uint32_t> node = working_->cheapest(finished_, situation.states);
        if (node) ++result_.reused;
        return node;
    }

    Steps make_plan(Situation& situation, const Key& key) {
        const std::size_t visits = ++visits_[key];
        if (visits > options_.most_returns) {
            fail(Result::Status::not_found, "what is known does not change");
            return nullptr;
        }
        Configuration first = options_.first;
        first.seed += visits - 1;
        Random random(first.seed + result_.plans);
        situation.belief.begin_plan(random);
        KnowledgePlan plan = planner_.plan(situation.belief, first, budget_.within(options_.plan_seconds));
        if (plan.status == Status::out_of_time || plan.status == Status::failed)
            plan = planner_.plan(situation.belief, options_.second, budget_);
        ++result_.plans;
        if (plan.status == Status::solved)
            return std::make_shared<const std::vector<OperatorId>>(std::move(plan.steps));
        if (plan.status == Status::unsolvable || plan.status == Status::unsolvable_early)
            fail(Result::Status::none, "no plan leads on from a belief, whatever is read");
        else if (plan.status == Status::failed)
            fail(Result::Status::not_found, "a search found no plan");
        else
            fail(Result::Status::limit, "no time or memory is left");
        return nullptr;
    }

    const KnowledgePlanner& planner_;
    const BeliefTask& task_;
    const ConditionalPlannerOptions& options_;
    const Budget& budget_;
    const std::optional<std::vector<WorldState>>& worlds_;
    std::optional<StateTable> table_;
    std::optional<Situations> situations_;
    PlanDraft draft_;
    std::optional<WorkingNodes> working_;
    std::map<Key, std::uint32_t> nodes_;
    std::map<Key, std::size_t> visits_;
    std::set<Key> on_path_;
    std::set<std::uint32_t> finished_set_;
    std::vector<std::uint32_t> finished_;
    std::size_t branches_ = 0;
    Result result_;
};

}  // namespace

ConditionalPlanResult make_conditional_plan(const KnowledgePlanner& planner,
                                            const std::optional<std::vector<WorldState>>& worlds,
                                            const ConditionalPlannerOptions& options, const Budget& budget) {
    return Builder(planner, worlds, options, budget)();
}

}  // namespace praxis::belief
