// Names of ground operators and facts, packed: a name is a list of words, a word an index into a table of symbols.
// Strings are made only when somebody looks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "search/task/packed_lists.hpp"

namespace praxis {

/// names[i] is a list of indices into `symbols`.
struct NameTable {
    std::vector<std::string> symbols;
    PackedLists<std::uint32_t> names;

    std::size_t size() const { return names.size(); }
    /// "pick ball1 rooma left": the words separated by blanks.
    std::string words(std::size_t i) const {
        std::string text;
        for (std::uint32_t word : names[i]) {
            if (!text.empty()) text += ' ';
            text += symbols[word];
        }
        return text;
    }
};

}  // namespace praxis
