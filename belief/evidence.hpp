// Readings that may be wrong: how much speaks for each fact, and what is believed therefore.
//
// Each uncertain variable has log-odds, the sum of log(a / (1 - a)) over the readings of accuracy a since an
// action may have changed it (Bayes' rule for independent readings and even odds at first). Beyond the
// threshold a fact is believed; where later readings speak against it, it is not any more, and everything
// that was concluded from it is taken back: the belief is built anew from the actions and from what is still
// believed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "belief/belief.hpp"
#include "belief/environment.hpp"

namespace praxis::belief {

class Evidence {
  public:
    /// Facts of probability `accept` (above 0.5, below 1) or more are believed. Refers to the belief. Throws
    /// std::invalid_argument.
    Evidence(Belief& belief, double accept);

    /// An action has been executed; has failed; has been refused. No plan is needed as the goal is supposed
    /// to hold. As in `Belief`.
    void act(std::uint32_t action);
    std::optional<Supposition> fail(std::uint32_t action);
    std::optional<Supposition> refuse(std::uint32_t action);
    std::optional<Supposition> suppose_otherwise();
    /// Something has been read.
    void read(const Answer& answer);
    /// Believes whatever is likelier than not, for want of a better way. False if there is nothing new to
    /// believe.
    bool guess();

    /// Grows with each reading that was taken in: beliefs with different evidence are different.
    std::uint64_t readings() const { return readings_; }
    /// The log-odds that the variable's value is 0.
    double log_odds(std::int32_t variable) const { return log_odds_[static_cast<std::size_t>(variable)]; }

  private:
    enum class Kind : std::uint8_t { learnt, acted, failed, refused, supposed_otherwise };
    struct Step {
        Kind kind = Kind::learnt;
        Fact fact;
        std::uint32_t action = 0;
        double weight = 0;  ///< log-odds when it was believed
    };

    /// What speaks for the values that the action may have changed does not any more.
    void discard(std::uint32_t action);
    void believe(Fact fact, double weight);
    void doubt(std::int32_t variable);
    void rebuild();

    Belief* belief_;
    double threshold_;
    std::vector<double> log_odds_;  ///< by variable, for the value 0
    std::vector<bool> believed_;    ///< by variable: by readings, as opposed to deduced
    std::vector<Step> history_;
    std::uint64_t readings_ = 0;
};

}  // namespace praxis::belief
