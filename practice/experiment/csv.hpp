// Comma-separated values (RFC 4180): fields with commas, quotes or line ends stand in quotes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source.hpp"

namespace praxis::practice {

/// A field as it stands in a file.
std::string csv_field(std::string_view text);

/// Reads one row after another. Rows end in "\n" or "\r\n"; the last may lack it.
class CsvReader {
  public:
    /// Refers to `source`.
    explicit CsvReader(const Source& source) : source_(source) {}

    /// Whether there was another row. Throws InputError for a quote out of place or never closed.
    bool next();
    /// The fields of the row, without their quotes.
    const std::vector<std::string>& fields() const { return fields_; }
    /// Throws an InputError that shows the row, or one field of it.
    [[noreturn]] void refuse_row(const std::string& message, const std::string& hint) const;
    [[noreturn]] void refuse_field(std::size_t field, const std::string& message,
                                   const std::string& hint) const;

  private:
    std::string read_field();
    [[noreturn]] void refuse(std::size_t from, std::size_t to, const std::string& message,
                             const std::string& hint) const;

    const Source& source_;
    std::size_t at_ = 0;
    std::vector<std::string> fields_;
    std::vector<std::size_t> starts_;  ///< of the fields, and one behind the end of the last
};

}  // namespace praxis::practice
