#include "tamp/motion/obstructions.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::tamp {

namespace {

/// The first configuration on the way that is not free; the end, if all are.
Configuration first_collision(CollisionChecker& checker, const Configuration& from, const Configuration& to,
                              double step) {
    double squares = 0;
    for (std::size_t v = 0; v < from.size(); ++v) squares += (to[v] - from[v]) * (to[v] - from[v]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::sqrt(squares) / step)));
    Configuration at = from;
    for (int i = 0; i <= pieces; ++i) {
        for (std::size_t v = 0; v < at.size(); ++v) at[v] = from[v] + (to[v] - from[v]) * i / pieces;
        if (!checker.is_free(at)) return at;
    }
    return at;
}

bool is_loose_body(const World& world, const Participant& who) {
    return who.kind == Participant::Kind::body && !world[who.index].attachment;
}

}  // namespace

std::vector<Obstruction> find_obstructions(CollisionChecker& checker,
                                           std::span<const std::pair<Configuration, Configuration>> blocked,
                                           double step) {
    const World& world = *checker.problem().world;
    std::vector<Obstruction> obstructions;
    const auto count = [&](const Participant& who) {
        const auto found = std::ranges::find(obstructions, who, &Obstruction::who);
        if (found != obstructions.end()) {
            ++found->count;
        } else {
            obstructions.push_back({who, 1});
        }
    };
    std::vector<Contact> contacts;
    for (const auto& [from, to] : blocked) {
        contacts.clear();
        checker.find_contacts(first_collision(checker, from, to, step), contacts);
        for (const Contact& contact : contacts) {
            const bool first = is_loose_body(world, contact.first);
            const bool second = is_loose_body(world, contact.second);
            if (first || !second) count(contact.first);
            if (second || !first) count(contact.second);
        }
    }
    std::ranges::stable_sort(obstructions, std::ranges::greater(), &Obstruction::count);
    return obstructions;
}

}  // namespace praxis::tamp
