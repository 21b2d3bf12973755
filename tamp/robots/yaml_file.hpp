// YAML with places in it, for the readers of robots.
#pragma once

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "parser/source.hpp"

namespace praxis::tamp {

/// A YAML text with a map at its root. All throw InputError that names file and line.
class YamlFile {
  public:
    /// Limits: 16 MiB, 100 levels of brackets, no aliases.
    explicit YamlFile(Source source);

    YAML::Node root() const { return root_; }
    const Source& source() const { return source_; }

    [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const;
    /// Throws if the map has a key that is not among these.
    void require_keys(const YAML::Node& map, std::initializer_list<const char*> keys) const;
    /// An entry that must be there.
    YAML::Node entry(const YAML::Node& map, const char* key) const;
    std::string text(const YAML::Node& node) const;
    /// A finite number.
    double number(const YAML::Node& node) const;
    /// A list of `size` finite numbers.
    std::vector<double> numbers(const YAML::Node& node, std::size_t size) const;
    void require_map(const YAML::Node& node) const;
    void require_list(const YAML::Node& node) const;

  private:
    Source source_;
    YAML::Node root_;
};

}  // namespace praxis::tamp
