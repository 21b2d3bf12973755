// Source texts and places in them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace praxis {

/// A piece of a source text: `length` bytes from `offset` of file number `file`.
struct Location {
    std::uint32_t file = 0;
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
};

/// One file as it was read. Limited to 4 GiB.
struct Source {
    std::string name;  ///< as the user named it; "<stdin>" for standard input
    std::string text;
};

/// The texts of a task, so that locations can be shown.
struct Sources {
    std::vector<Source> files;
};

}  // namespace praxis
