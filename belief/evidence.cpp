#include "belief/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::belief {
namespace {

/// Readings of perfect accuracy count as this one.
constexpr double kMostAccurate = 1 - 1e-9;

double logit(double probability) {
    return std::log(probability / (1 - probability));
}

}  // namespace

Evidence::Evidence(Belief& belief, double accept)
    : belief_(&belief),
      log_odds_(belief.compilation().belief().uncertain.size(), 0),
      believed_(log_odds_.size(), false) {
    if (!(accept > 0.5 && accept < 1))
        throw std::invalid_argument("the probability to accept must be above 0.5 and below 1");
    threshold_ = logit(accept);
}

void Evidence::act(std::uint32_t action) {
    discard(action);
    belief_->act(action);
    history_.push_back({Kind::acted, {}, action, 0});
}

std::optional<Supposition> Evidence::fail(std::uint32_t action) {
    discard(action);
    history_.push_back({Kind::failed, {}, action, 0});
    return belief_->fail(action);
}

std::optional<Supposition> Evidence::refuse(std::uint32_t action) {
    history_.push_back({Kind::refused, {}, action, 0});
    return belief_->refuse(action);
}

std::optional<Supposition> Evidence::suppose_otherwise() {
    history_.push_back({Kind::supposed_otherwise, {}, 0, 0});
    return belief_->suppose_otherwise();
}

void Evidence::discard(std::uint32_t action) {
    const BeliefTask& task = belief_->compilation().belief();
    const auto discard_variable = [&](std::int32_t variable) {
        log_odds_[index(variable)] = 0;
        believed_[index(variable)] = false;
    };
    for (const GroundEffect& effect : task.physical->effects[action]) discard_variable(effect.fact.variable);
    for (std::int32_t variable : task.forgotten[action]) discard_variable(variable);
}

void Evidence::read(const Answer& answer) {
    const auto variable = static_cast<std::size_t>(answer.fact.variable);
    if (!belief_->compilation().belief().uncertain[variable]) {
        // There are no odds of several values: what is in doubt is what is read.
        if (belief_->in_doubt(answer.fact.variable)) believe(answer.fact, threshold_);
        return;
    }
    ++readings_;
    double& odds = log_odds_[variable];
    const double weight = logit(std::min(answer.accuracy, kMostAccurate));
    odds += answer.fact.value == 0 ? weight : -weight;
    const Fact likelier{answer.fact.variable, odds > 0 ? 0 : 1};
    if (std::abs(odds) >= threshold_) {
        if (!belief_->knows(likelier)) believe(likelier, std::abs(odds));
    } else if (believed_[variable] && !belief_->knows(likelier)) {
        doubt(answer.fact.variable);
    }
}

bool Evidence::guess() {
    bool news = false;
    for (std::size_t v = 0; v < log_odds_.size(); ++v) {
        const Fact likelier{static_cast<std::int32_t>(v), log_odds_[v] > 0 ? 0 : 1};
        if (log_odds_[v] == 0 || belief_->truth(likelier) != Truth::unknown) continue;
        believe(likelier, std::abs(log_odds_[v]));
        news = true;
    }
    return news;
}

/// Where the fact contradicts what is believed, the weaker of these beliefs go first.
void Evidence::believe(Fact fact, double weight) {
    if (believed_[static_cast<std::size_t>(fact.variable)]) doubt(fact.variable);
    while (!belief_->learn(fact)) {
        const Step* weakest = nullptr;
        for (const Step& step : history_)
            if (step.kind == Kind::learnt && step.weight <= weight &&
                (weakest == nullptr || step.weight < weakest->weight))
                weakest = &step;
        if (weakest == nullptr) return;  // what speaks against it is stronger
        doubt(weakest->fact.variable);
    }
    believed_[static_cast<std::size_t>(fact.variable)] = true;
    history_.push_back({Kind::learnt, fact, 0, weight});
}

void Evidence::doubt(std::int32_t variable) {
    std::erase_if(history_, [&](const Step& step) {
        return step.kind == Kind::learnt && step.fact.variable == variable;
    });
    believed_[static_cast<std::size_t>(variable)] = false;
    rebuild();
}

void Evidence::rebuild() {
    Belief fresh(belief_->shared_compilation());
    for (const Step& step : history_) {
        switch (step.kind) {
            case Kind::learnt:
                fresh.learn(step.fact);
                break;
            case Kind::acted:
                fresh.act(step.action);
                break;
            case Kind::failed:
                fresh.fail(step.action);
                break;
            case Kind::refused:
                fresh.refuse(step.action);
                break;
            case Kind::supposed_otherwise:
                fresh.suppose_otherwise();
                break;
        }
    }
    *belief_ = std::move(fresh);
}

}  // namespace praxis::belief
