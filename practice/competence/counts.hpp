// Outcomes, counted.
#pragma once

#include <cstdint>

namespace praxis::practice {

struct Counts {
    std::int64_t successes = 0, failures = 0;

    std::int64_t total() const { return successes + failures; }
    void add(bool success) { ++(success ? successes : failures); }
    Counts& operator+=(const Counts& other) {
        successes += other.successes;
        failures += other.failures;
        return *this;
    }
    friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace praxis::practice
