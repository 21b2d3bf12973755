// A file of named arrays of 32-bit floats with a JSON header and a checksum.
//
//     "PRAXISNN", version (4 bytes), length of the header (4 bytes), header, arrays one behind the other,
//     checksum (8 bytes)
//
// All numbers are little-endian. The header is a JSON object; its member "arrays" lists [name, length] in
// order, the others are the caller's. The checksum is the 64-bit FNV-1a hash of everything before it. Files
// are written under another name and then renamed, so that a reader never sees half of one.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace praxis::learned {

struct ArrayFile {
    nlohmann::json header = nlohmann::json::object();
    std::vector<std::pair<std::string, std::vector<float>>> arrays;

    /// The array of a name, or InputError that names `file`.
    const std::vector<float>& array(const std::string& name, const std::string& file) const;
};

/// InputError if it cannot be written.
void write_array_file(const std::string& file, const ArrayFile& contents);
/// InputError that says what is wrong: no such file, another kind of file, a later version, cut off, changed
/// since it was written, a header that is not as described.
ArrayFile read_array_file(const std::string& file);
/// The same from memory; `file` is for messages.
ArrayFile parse_array_file(std::string_view bytes, const std::string& file);

}  // namespace praxis::learned
