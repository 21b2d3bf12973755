#include "tamp/robots/xml_file.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kLargestText = std::size_t{16} << 20;

}  // namespace

XmlFile::XmlFile(Source source, const std::string& root) : source_(std::move(source)) {
    require_text(source_);
    if (source_.text.size() > kLargestText) fail_unplaced(source_.name + ": larger than 16 MiB");
    // Readers in C would stop there and see another text than this one.
    if (source_.text.find('\0') != std::string::npos) fail_unplaced(source_.name + ": is no text");
    document_.Parse(source_.text.data(), source_.text.size());
    if (document_.Error()) {
        const std::string name = document_.ErrorName();
        const bool deep = document_.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED;
        fail_at_line(document_.ErrorLineNum(),
                     deep ? "elements are nested more than 100 levels deep" : "this is no well-formed XML",
                     name);
    }
    const tinyxml2::XMLElement* element = document_.RootElement();
    if (element == nullptr) fail_unplaced(source_.name + ": has no element <" + root + ">");
    if (element->Name() != root) {
        fail(*element, "the root element is <" + std::string(element->Name()) + ">",
             "expected <" + root + ">");
    }
}

void XmlFile::fail_at_line(int line, const std::string& message, const std::string& hint) const {
    const std::string_view text = source_.text;
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string_view::npos) break;
        begin = end + 1;
    }
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n", begin), end);
    std::size_t length = end - first;
    while (length > 0 && std::string_view(" \t\r").find(text[first + length - 1]) != std::string_view::npos) {
        --length;
    }
    const Diagnostic diagnostic{
        .where = {0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(length)},
        .message = message,
        .hint = hint};
    throw InputError(to_string(diagnostic, {{source_}}), {diagnostic});
}

void XmlFile::fail(const tinyxml2::XMLElement& element, const std::string& message,
                   const std::string& hint) const {
    fail_at_line(element.GetLineNum(), message, hint);
}

std::string XmlFile::attribute(const tinyxml2::XMLElement& element, const char* name) const {
    const char* value = element.Attribute(name);
    if (value == nullptr || *value == '\0') {
        fail(element, "<" + std::string(element.Name()) + "> needs a value of '" + name + "'");
    }
    return value;
}

std::vector<double> XmlFile::numbers(const tinyxml2::XMLElement& element, const char* name) const {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::string text = attribute(element, name);
    std::vector<double> numbers;
    std::size_t at = text.find_first_not_of(kBlanks);
    while (at != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        double number = 0;
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, number);
        if (error != std::errc() || stop != text.data() + end || !std::isfinite(number)) {
            fail(element, quote(text.substr(at, end - at)) + " is no finite number");
        }
        numbers.push_back(number);
        at = text.find_first_not_of(kBlanks, end);
    }
    return numbers;
}

std::vector<const tinyxml2::XMLElement*> children(const tinyxml2::XMLElement& parent, const char* name) {
    std::vector<const tinyxml2::XMLElement*> found;
    for (const auto* child = parent.FirstChildElement(name); child != nullptr;
         child = child->NextSiblingElement(name)) {
        found.push_back(child);
    }
    return found;
}

}  // namespace praxis::tamp
