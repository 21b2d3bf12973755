#include "practice/experiment/csv.hpp"

#include <algorithm>

#include "parser/diagnostic.hpp"

namespace praxis::practice {

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + "\"";
}

bool CsvReader::next() {
    const std::string& text = source_.text;
    if (at_ >= text.size()) return false;
    fields_.clear();
    starts_.assign(1, at_);
    while (true) {
        fields_.push_back(read_field());
        starts_.push_back(at_ + 1);
        if (at_ == text.size()) return true;
        if (text[at_++] == ',') continue;
        if (text[at_ - 1] == '\r') ++at_;
        return true;
    }
}

/// Ends at the comma, at the line's end or at the end of the text.
std::string CsvReader::read_field() {
    const std::string& text = source_.text;
    const std::size_t start = at_;
    if (at_ == text.size() || text[at_] != '"') {
        at_ = std::min(text.find_first_of(",\n", at_), text.size());
        if (at_ < text.size() && text[at_] == '\n' && at_ > start && text[at_ - 1] == '\r') --at_;
        const std::string field = text.substr(start, at_ - start);
        if (const std::size_t odd = field.find_first_of("\"\r"); odd != std::string::npos)
            refuse(start + odd, start + odd + 1, "a quote or carriage return inside of a field",
                   "put the field in quotes, and write a quote in it twice");
        return field;
    }
    std::string field;
    while (true) {
        const std::size_t quote = text.find('"', ++at_);
        if (quote == std::string::npos) refuse(start, start + 1, "a quote that is never closed", "");
        field.append(text, at_, quote - at_);
        at_ = quote + 1;
        if (at_ == text.size() || text[at_] != '"') break;
        field += '"';
    }
    const bool at_end =
        at_ == text.size() || text[at_] == ',' || text[at_] == '\n' || text.compare(at_, 2, "\r\n") == 0;
    if (!at_end) refuse(at_, at_ + 1, "text after a closed quote", "put the whole field in quotes");
    return field;
}

void CsvReader::refuse(std::size_t from, std::size_t to, const std::string& message,
                       const std::string& hint) const {
    Diagnostic diagnostic;
    diagnostic.where = {0, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to - from)};
    diagnostic.message = message;
    diagnostic.hint = hint;
    throw InputError(to_string(diagnostic, {{source_}}), {diagnostic});
}

void CsvReader::refuse_row(const std::string& message, const std::string& hint) const {
    refuse(starts_.front(), starts_.back() - 1, message, hint);
}

void CsvReader::refuse_field(std::size_t field, const std::string& message, const std::string& hint) const {
    refuse(starts_[field], starts_[field + 1] - 1, message, hint);
}

}  // namespace praxis::practice
