#include "search/state/state_packer.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace praxis {

namespace {

constexpr std::uint32_t kWordBits = 32;

std::uint32_t field_width(std::int32_t domain_size) {
    return static_cast<std::uint32_t>(
        std::bit_width(static_cast<std::uint32_t>(std::max(domain_size, 1) - 1)));
}

}  // namespace

StatePacker::StatePacker(const FiniteDomainTask& task) : places_(task.variable_count()) {
    std::array<std::vector<std::uint32_t>, kWordBits + 1> by_width;
    for (std::uint32_t variable = 0; variable < task.variable_count(); ++variable) {
        if (task.axiom_layers[variable] < 0)
            by_width[field_width(task.domain_sizes[variable])].push_back(variable);
    }
    std::array<std::vector<std::uint32_t>, kWordBits + 1> words_with_room;
    std::vector<std::vector<std::uint32_t>> contents(1);
    words_with_room[kWordBits].push_back(0);
    for (std::uint32_t width = kWordBits + 1; width-- > 0;) {
        for (std::uint32_t variable : by_width[width]) {
            std::uint32_t room = std::max(width, 1u);
            while (room <= kWordBits && words_with_room[room].empty()) ++room;
            if (width == 0) room = kWordBits + 1;
            std::uint32_t word = 0;
            if (width > 0) {
                if (room > kWordBits) {
                    room = kWordBits;
                    words_with_room[room].push_back(static_cast<std::uint32_t>(contents.size()));
                    contents.emplace_back();
                }
                word = words_with_room[room].back();
                words_with_room[room].pop_back();
                words_with_room[room - width].push_back(word);
                places_[variable] = {word, static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1),
                                     kWordBits - room};
            }
            contents[word].push_back(variable);
        }
    }
    first_slot_.push_back(0);
    for (const auto& variables : contents) {
        for (std::uint32_t variable : variables) {
            slots_.push_back({variable, places_[variable].mask, places_[variable].shift});
        }
        first_slot_.push_back(static_cast<std::uint32_t>(slots_.size()));
    }
}

void StatePacker::pack(const std::int32_t* values, std::uint32_t* words) const {
    for (std::size_t word = 0; word < word_count(); ++word) {
        std::uint32_t bits = 0;
        for (std::uint32_t i = first_slot_[word]; i < first_slot_[word + 1]; ++i) {
            bits |= static_cast<std::uint32_t>(values[slots_[i].variable]) << slots_[i].shift;
        }
        words[word] = bits;
    }
}

void StatePacker::unpack(const std::uint32_t* words, std::int32_t* values) const {
    for (std::size_t word = 0; word < word_count(); ++word) {
        const std::uint32_t bits = words[word];
        for (std::uint32_t i = first_slot_[word]; i < first_slot_[word + 1]; ++i) {
            const Slot slot = slots_[i];
            values[slot.variable] = static_cast<std::int32_t>((bits >> slot.shift) & slot.mask);
        }
    }
}

}  // namespace praxis
