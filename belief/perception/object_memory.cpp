#include "belief/perception/object_memory.hpp"

#include <cmath>

#include "belief/perception/assignment.hpp"
#include "belief/perception/errors.hpp"

namespace praxis::belief {
namespace {

bool is_usable(const std::optional<Position>& position) {
    return position && std::isfinite(position->x) && std::isfinite(position->y) && std::isfinite(position->z);
}

}  // namespace

double distance(const Position& a, const Position& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

std::string as_object_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        if (c >= 'A' && c <= 'Z') {
            name.push_back(static_cast<char>(c - 'A' + 'a'));
        } else if ((c >= 'a' && c <= 'z') || (!name.empty() && ((c >= '0' && c <= '9') || c == '_'))) {
            name.push_back(c);
        } else if (!name.empty() && name.back() != '-') {
            name.push_back('-');
        }
    }
    while (name.ends_with('-')) name.pop_back();
    return name;
}

ObjectMemory::ObjectMemory(ObjectMemoryOptions options) : options_(std::move(options)) {
    if (!(options_.gate >= 0)) throw PerceptionError("the gate of an object memory cannot be negative");
}

bool ObjectMemory::compatible(const std::string& seen, const std::string& known) const {
    return options_.compatible ? options_.compatible(seen, known) : seen == known;
}

std::size_t ObjectMemory::add(const std::string& name, const std::string& type,
                              std::optional<Position> position) {
    const auto [entry, added] = by_name_.emplace(name, objects_.size());
    if (added) objects_.push_back({name, type, position, -1, 0});
    return entry->second;
}

const RememberedObject* ObjectMemory::find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &objects_[found->second];
}

void ObjectMemory::moved(const std::string& name, std::optional<Position> position) {
    const auto found = by_name_.find(name);
    if (found != by_name_.end()) objects_[found->second].position = position;
}

void ObjectMemory::match_names(std::span<const Detection> view,
                               std::vector<std::optional<Association>>& result) const {
    std::unordered_map<std::size_t, std::size_t> holder;  // object -> detection
    for (std::size_t i = 0; i < view.size(); ++i) {
        const auto found = by_name_.find(view[i].object);
        if (found == by_name_.end()) continue;
        const RememberedObject& object = objects_[found->second];
        if (!compatible(view[i].type, object.type)) continue;
        const auto [entry, first] = holder.emplace(found->second, i);
        if (!first) {
            const Detection& other = view[entry->second];
            if (!is_usable(object.position) || !is_usable(view[i].position)) continue;
            if (is_usable(other.position) && distance(*other.position, *object.position) <=
                                                 distance(*view[i].position, *object.position)) {
                continue;
            }
            result[entry->second].reset();
            entry->second = i;
        }
        result[i] = Association{found->second, false};
    }
}

void ObjectMemory::match_positions(std::span<const Detection> view,
                                   std::vector<std::optional<Association>>& result) const {
    std::vector<bool> taken(objects_.size(), false);
    for (const auto& association : result) {
        if (association) taken[association->object] = true;
    }
    std::vector<std::size_t> seen;
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < view.size(); ++i) {
        if (!result[i] && is_usable(view[i].position)) seen.push_back(i);
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (!taken[i] && is_usable(objects_[i].position)) known.push_back(i);
    }
    // Each detection may also stay alone, at a price that no sum of distances reaches.
    const std::size_t columns = known.size() + seen.size();
    const double alone = (options_.gate + 1e-9) * static_cast<double>(seen.size() + 1);
    std::vector<double> costs(seen.size() * columns, alone);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Detection& detection = view[seen[i]];
        for (std::size_t j = 0; j < known.size(); ++j) {
            const RememberedObject& object = objects_[known[j]];
            const double metres = distance(*detection.position, *object.position);
            const bool possible = metres <= options_.gate && compatible(detection.type, object.type);
            costs[i * columns + j] = possible ? metres : 4 * alone;
        }
    }
    const std::vector<std::size_t> columns_of = assign(costs, seen.size(), columns);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (columns_of[i] < known.size() && costs[i * columns + columns_of[i]] < alone) {
            result[seen[i]] = Association{known[columns_of[i]], false};
        }
    }
}

std::string ObjectMemory::fresh_name(const std::string& wanted, const std::string& type) const {
    const std::string name = as_object_name(wanted);
    if (!name.empty() && !by_name_.contains(name)) return name;
    std::string stem = as_object_name(type);
    if (stem.empty()) stem = "object";
    for (std::size_t number = 1;; ++number) {
        std::string numbered = stem + std::to_string(number);
        if (!by_name_.contains(numbered) && !reserved_.contains(numbered)) return numbered;
    }
}

void ObjectMemory::see(std::size_t object, const Detection& detection, std::int64_t step) {
    RememberedObject& seen = objects_[object];
    if (is_usable(detection.position)) seen.position = detection.position;
    seen.last_seen = step;
    ++seen.sightings;
}

std::vector<std::optional<ObjectMemory::Association>> ObjectMemory::associate(std::span<const Detection> view,
                                                                              std::int64_t step) {
    std::vector<std::optional<Association>> result(view.size());
    match_names(view, result);
    match_positions(view, result);
    for (std::size_t i = 0; i < view.size(); ++i) {
        const bool nameable = !as_object_name(view[i].object).empty() && !by_name_.contains(view[i].object);
        if (!result[i] && (is_usable(view[i].position) || nameable)) {
            result[i] = Association{add(fresh_name(view[i].object, view[i].type), view[i].type), true};
        }
        if (result[i]) see(result[i]->object, view[i], step);
    }
    return result;
}

}  // namespace praxis::belief
