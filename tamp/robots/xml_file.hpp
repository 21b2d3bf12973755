// XML with places in it, for the readers of robots.
#pragma once

#include <tinyxml2.h>

#include <array>
#include <string>
#include <vector>

#include "parser/source.hpp"

namespace praxis::tamp {

/// A well-formed XML text. Its elements keep the numbers of their lines.
class XmlFile {
  public:
    /// Throws InputError if the text is no XML, is nested more than 100 levels deep, larger than 16 MiB, or
    /// has another root element than `root`.
    XmlFile(Source source, const std::string& root);

    const tinyxml2::XMLElement& root() const { return *document_.RootElement(); }
    const Source& source() const { return source_; }

    /// Throw InputError at the element's line.
    [[noreturn]] void fail(const tinyxml2::XMLElement& element, const std::string& message,
                           const std::string& hint = {}) const;
    /// The attribute, which must be there and not empty.
    std::string attribute(const tinyxml2::XMLElement& element, const char* name) const;
    /// Finite numbers separated by blanks.
    std::vector<double> numbers(const tinyxml2::XMLElement& element, const char* name) const;

  private:
    [[noreturn]] void fail_at_line(int line, const std::string& message, const std::string& hint) const;

    Source source_;
    tinyxml2::XMLDocument document_;
};

/// The children of this name, in order.
std::vector<const tinyxml2::XMLElement*> children(const tinyxml2::XMLElement& parent, const char* name);

}  // namespace praxis::tamp
