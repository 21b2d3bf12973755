// Which seen thing is which object: association of detections with objects known before.
//
// A detection is first matched by its name, if it is that of a known object of a compatible type: names that
// an observer gives are stable. Those left are matched with objects of a compatible type by position: one to
// one, no farther than the gate, as many as possible and then with the least sum of distances (Hungarian
// method). What still is left is new and gets a name of its own. Detections of one view are of different
// things; those of another view are matched with the objects after the first, so that a thing that two views
// show stays one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "belief/percept.hpp"

namespace praxis::belief {

struct RememberedObject {
    std::string name;
    std::string type;
    std::optional<Position> position;  ///< where it was seen last; none if never with a position
    std::int64_t last_seen = -1;       ///< step; -1: never
    std::int64_t sightings = 0;
};

struct ObjectMemoryOptions {
    double gate = 0.05;  ///< metres; what is farther from where an object was is another one
    /// Whether a thing detected as the first type may be an object of the second. By default: equal types.
    std::function<bool(const std::string&, const std::string&)> compatible;
};

class ObjectMemory {
  public:
    struct Association {
        std::size_t object = 0;  ///< index into objects()
        bool is_new = false;
    };

    /// Throws PerceptionError if the gate is negative or not a number.
    explicit ObjectMemory(ObjectMemoryOptions options = {});

    /// An object that is known without having been seen; its index. One that is there already stays as it is.
    std::size_t add(const std::string& name, const std::string& type,
                    std::optional<Position> position = std::nullopt);

    /// A name that no new object is given unless a detection bears it.
    void reserve(const std::string& name) { reserved_.insert(name); }

    /// Matches the detections of one view with the objects, and remembers them. A result per detection: none
    /// for one that has neither the name of a known object, nor a position, nor a new name. Of detections
    /// with the same name, the nearest to where the object was keeps it.
    std::vector<std::optional<Association>> associate(std::span<const Detection> view, std::int64_t step);

    const std::vector<RememberedObject>& objects() const { return objects_; }
    /// Nothing if there is none of the name.
    const RememberedObject* find(const std::string& name) const;
    /// The robot moved the object itself: it is looked for there from now on, or anywhere by name alone.
    void moved(const std::string& name, std::optional<Position> position);

  private:
    bool compatible(const std::string& seen, const std::string& known) const;
    void match_names(std::span<const Detection> view, std::vector<std::optional<Association>>& result) const;
    void match_positions(std::span<const Detection> view,
                         std::vector<std::optional<Association>>& result) const;
    std::string fresh_name(const std::string& wanted, const std::string& type) const;
    void see(std::size_t object, const Detection& detection, std::int64_t step);

    ObjectMemoryOptions options_;
    std::vector<RememberedObject> objects_;
    std::unordered_map<std::string, std::size_t> by_name_;
    std::unordered_set<std::string> reserved_;
};

double distance(const Position& a, const Position& b);

/// The text as a name of PDDL: lower case, with '-' for what cannot be in one; empty if nothing is left of
/// it.
std::string as_object_name(const std::string& text);

}  // namespace praxis::belief
