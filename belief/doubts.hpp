// What failed actions may have changed all the same.
//
// A skill that fails may have done its work or not. An uncertain variable that it may have changed is not
// known any more. A certain one has no value that says so: plans *suppose* one, at first that the action did
// not happen. A *doubt* is a failed action with all the changes that it would have made, taken to have
// happened as a whole or not at all. It is settled by what tells the two apart: a reading of one of its
// variables, or an action that the world executes, or refuses, because of their values. Where nothing does, the
// other way is supposed once the first one fails, too.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "belief/belief_task.hpp"

namespace praxis::belief {

/// A failed action has happened, or has not.
struct Supposition {
    std::uint32_t action = 0;
    bool happened = false;
};

/// "(go desk balance) has not happened".
std::string to_string(const Supposition& supposed, const FiniteDomainTask& task);

struct Doubt {
    struct Change {
        std::int32_t variable;
        std::int32_t before, after;  ///< its value if the action did not happen; if it did
    };
    Supposition supposed;
    std::vector<Change> changes;
};

class Doubts {
  public:
    bool empty() const { return doubts_.empty(); }
    bool about(std::int32_t variable) const;
    bool has_action(std::uint32_t action) const;
    /// Doubts that are about one of the facts; where one of them is derived, all that there are.
    std::size_t count(std::span<const Fact> facts, const FiniteDomainTask& task) const;

    void add(Doubt doubt) { doubts_.push_back(std::move(doubt)); }
    /// Another action has set the variable.
    void overwrite(std::int32_t variable);
    /// `fact` holds: doubts about its variable are settled. Appends what holds therefore.
    void settle(Fact fact, std::vector<Fact>& news);
    /// The last doubt that is about one of the facts (as above) is turned to the other way, and settled if
    /// `settled`. Appends its facts. Nothing if there is none.
    std::optional<Supposition> turn(std::span<const Fact> facts, const FiniteDomainTask& task, bool settled,
                                    std::vector<Fact>& news);

  private:
    void forget_empty();

    std::vector<Doubt> doubts_;  ///< the latest last
};

}  // namespace praxis::belief
