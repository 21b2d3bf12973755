#include "parser/diagnostic.hpp"

#include <algorithm>
#include <string_view>

namespace praxis {
namespace {

constexpr std::size_t kTabStop = 8;
constexpr std::size_t kWidth = 100;  ///< characters of a source line that are shown
constexpr std::size_t kBefore = 40;  ///< of them before the place, where a line is cut

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The length of the well-formed UTF-8 character at `at`, or 0.
std::size_t character_length(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
    if (length == 0 || lead > 0xF4 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues_character(text[at + i])) return 0;
    }
    return length;
}

/// A source line as a terminal shows it, and where a byte range of it ends up.
struct Picture {
    std::string text;
    std::size_t begin = 0;
    std::size_t width = 0;
};

Picture picture(std::string_view line, std::size_t begin, std::size_t end) {
    Picture result;
    std::size_t column = 0;
    std::size_t end_column = 0;
    for (std::size_t at = 0; at < line.size();) {
        if (at <= begin) result.begin = column;
        const std::size_t length = std::max<std::size_t>(character_length(line, at), 1);
        if (line[at] == '\t') {
            do {
                result.text += ' ';
                ++column;
            } while (column % kTabStop != 0);
        } else if (static_cast<unsigned char>(line[at]) < 0x20 || line[at] == 0x7F ||
                   character_length(line, at) == 0) {
            result.text += '?';
            ++column;
        } else {
            result.text += line.substr(at, length);
            ++column;
        }
        at += length;
        if (at <= end) end_column = column;
    }
    if (begin >= line.size()) result.begin = column;
    result.width = std::max<std::size_t>(end_column > result.begin ? end_column - result.begin : 0, 1);
    return result;
}

std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

std::string_view severity_name(Severity severity) {
    switch (severity) {
        case Severity::warning:
            return "warning";
        case Severity::unsupported:
            return "unsupported";
        case Severity::error:
            break;
    }
    return "error";
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic, const Sources& sources) {
    std::string result;
    const auto add_message = [&] {
        result += severity_name(diagnostic.severity);
        result += ": ";
        result += diagnostic.message;
    };
    if (!diagnostic.placed || diagnostic.where.file >= sources.files.size()) {
        add_message();
        if (!diagnostic.hint.empty()) result += "; " + diagnostic.hint;
        return result + '\n';
    }
    const Source& source = sources.files[diagnostic.where.file];
    const std::string_view text = source.text;
    const std::size_t offset = std::min<std::size_t>(diagnostic.where.offset, text.size());
    const std::size_t newline = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t line_begin = newline == std::string_view::npos ? 0 : newline + 1;
    std::size_t line_end = std::min(text.find('\n', offset), text.size());
    if (line_end > line_begin && text[line_end - 1] == '\r' && line_end - 1 >= offset) --line_end;
    const auto line_number =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n') + 1;
    const std::size_t column = count_characters(text.substr(line_begin, offset - line_begin)) + 1;
    const std::size_t end = std::clamp<std::size_t>(offset + diagnostic.where.length, offset, line_end);

    result += source.name + ':' + std::to_string(line_number) + ':' + std::to_string(column) + ": ";
    add_message();

    std::size_t shown_begin = line_begin;
    std::size_t shown_end = line_end;
    if (line_end - line_begin > kWidth) {
        shown_begin = offset - std::min(offset - line_begin, kBefore);
        while (shown_begin > line_begin && continues_character(text[shown_begin])) --shown_begin;
        shown_end = std::min(line_end, shown_begin + kWidth);
        while (shown_end < line_end && continues_character(text[shown_end])) ++shown_end;
    }
    const std::string before = shown_begin > line_begin ? "..." : "";
    const std::string after = shown_end < line_end ? "..." : "";
    const Picture shown = picture(text.substr(shown_begin, shown_end - shown_begin), offset - shown_begin,
                                  std::min(end, shown_end) - shown_begin);
    const std::string number = std::to_string(line_number);
    result += "\n  " + number + " | " + before + shown.text + after + '\n';
    result += std::string(number.size() + 3, ' ') + "| " + std::string(before.size() + shown.begin, ' ') +
              '^' + std::string(shown.width - 1, '~');
    if (!diagnostic.hint.empty()) result += ' ' + diagnostic.hint;
    return result + '\n';
}

}  // namespace praxis
