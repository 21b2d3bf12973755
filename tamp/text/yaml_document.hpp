// A YAML file whose readers complain with line and column. Included by readers only: yaml-cpp stays behind
// them.
#pragma once

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source.hpp"
#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

/// `what` in the functions below is a phrase for messages: "the radius of body 'cup'". All throw InputError.
class YamlDocument {
  public:
    /// Parses one document of at most 64 MiB whose top is a map.
    explicit YamlDocument(Source source);

    const std::string& name() const { return sources_.files[0].name; }
    YAML::Node root() const { return root_; }

    [[noreturn]] void fail(const YAML::Node& at, const std::string& message,
                           const std::string& hint = {}) const;

    void require_map(const YAML::Node& node, const std::string& what) const;
    void require_list(const YAML::Node& node, const std::string& what) const;
    /// Refuses keys that are not in `known`, and keys that stand twice.
    void require_keys(const YAML::Node& map, const std::string& what,
                      std::initializer_list<std::string_view> known) const;
    /// The value of a key; not given (see `is_given`) if it is not there or `node` is no map.
    static YAML::Node find(const YAML::Node& node, const char* key);
    /// The value of a key that must be there.
    YAML::Node member(const YAML::Node& map, const char* key, const std::string& what) const;

    double number(const YAML::Node& node, const std::string& what) const;  ///< finite
    double length(const YAML::Node& node, const std::string& what) const;  ///< finite and above 0
    /// A list of exactly so many finite numbers.
    std::vector<double> numbers(const YAML::Node& node, const std::string& what, std::size_t count) const;
    Vector3 vector(const YAML::Node& node, const std::string& what) const;
    bool boolean(const YAML::Node& node, const std::string& what) const;
    std::string text(const YAML::Node& node, const std::string& what) const;  ///< not blank
    /// A list of texts.
    std::vector<std::string> texts(const YAML::Node& node, const std::string& what) const;

  private:
    Sources sources_;
    YAML::Node root_;
};

/// There, and neither null nor an empty list.
bool is_given(const YAML::Node& node);

}  // namespace praxis::tamp
