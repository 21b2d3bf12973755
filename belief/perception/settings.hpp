// Settings written as a JSON object, read member by member: every error names the place, and a member that
// nobody asked for is one.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace praxis::belief {

class Settings {
  public:
    /// `name`: the file's, for errors. Everything here throws PerceptionError for what does not fit.
    static Settings parse(std::string_view text, const std::string& name);

    bool has(const std::string& member) const { return json_->contains(member); }
    std::string text(const std::string& member);
    std::string text(const std::string& member, const std::string& otherwise);
    double number(const std::string& member, double low, double high, std::optional<double> otherwise = {});
    std::int64_t whole(const std::string& member, std::int64_t low, std::int64_t high,
                       std::optional<std::int64_t> otherwise = {});
    bool flag(const std::string& member, bool otherwise);
    /// A list of exactly `count` numbers of this range.
    std::vector<double> numbers(const std::string& member, std::size_t count, double low, double high);
    Settings object(const std::string& member);
    std::vector<Settings> objects(const std::string& member);
    /// The members of an object of objects; of an object of texts. None where it is not written.
    std::vector<std::pair<std::string, Settings>> named_objects(const std::string& member);
    std::vector<std::pair<std::string, std::string>> named_texts(const std::string& member);
    /// The text of the object as it is written.
    std::string raw(const std::string& member);

    /// All members have been read.
    void finish() const;
    [[noreturn]] void fail(const std::string& member, const std::string& what) const;

  private:
    using Json = nlohmann::json;
    Settings(std::shared_ptr<const Json> root, const Json* json, std::string place)
        : root_(std::move(root)), json_(json), place_(std::move(place)) {}
    /// Null where it is not written.
    const Json* find(const std::string& member);
    const Json& get(const std::string& member);
    Settings part(const Json& json, const std::string& place) const;

    std::shared_ptr<const Json> root_;  ///< keeps `json_` alive
    const Json* json_;
    std::string place_;
    std::set<std::string> read_;
};

}  // namespace praxis::belief
