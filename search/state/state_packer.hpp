// States as a few machine words.
//
// Every variable that is not derived gets a field of ceil(log2(domain size)) bits inside one 32-bit word;
// fields are placed first-fit by decreasing width, so that hardly a bit is lost. Derived variables take no
// room: the axiom evaluator computes them after unpacking. Packed states of one packer are equal exactly if
// all their words are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis {

class StatePacker {
  public:
    explicit StatePacker(const FiniteDomainTask& task);

    /// 32-bit words a packed state takes; at least one.
    std::size_t word_count() const { return first_slot_.size() - 1; }
    std::size_t variable_count() const { return places_.size(); }

    void pack(const std::int32_t* values, std::uint32_t* words) const;
    /// Writes the values of all variables that are not derived, and of no others.
    void unpack(const std::uint32_t* words, std::int32_t* values) const;

    /// The value of one variable that is not derived.
    std::int32_t get(const std::uint32_t* words, std::int32_t variable) const {
        const Place& place = places_[static_cast<std::size_t>(variable)];
        return static_cast<std::int32_t>((words[place.word] >> place.shift) & place.mask);
    }
    void set(std::uint32_t* words, Fact fact) const {
        const Place& place = places_[static_cast<std::size_t>(fact.variable)];
        std::uint32_t& word = words[place.word];
        word =
            (word & ~(place.mask << place.shift)) | (static_cast<std::uint32_t>(fact.value) << place.shift);
    }

  private:
    struct Place {
        std::uint32_t word = 0;
        std::uint32_t mask = 0;
        std::uint32_t shift = 0;
    };
    struct Slot {
        std::uint32_t variable;
        std::uint32_t mask;
        std::uint32_t shift;
    };
    std::vector<Place> places_;              // by variable
    std::vector<Slot> slots_;                // by word
    std::vector<std::uint32_t> first_slot_;  // by word; one more at the end
};

}  // namespace praxis
