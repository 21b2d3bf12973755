// What a robot perceives: readings of ground atoms and detections of objects.
//
// A *reading* says that an atom holds, does not hold, or that the observer cannot tell. A *detection* says
// that an object is seen somewhere. Objects are named, since what is detected may be new to the task.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace praxis::belief {

/// What is known of an atom: two bits, never both.
enum class Truth : std::uint8_t { unknown = 0, known_true = 1, known_false = 2 };

/// "(inside cup1 drawer)" by names: words[0] is the predicate, the others are objects.
struct AtomName {
    std::vector<std::string> words;
    friend auto operator<=>(const AtomName&, const AtomName&) = default;
};

struct Reading {
    AtomName atom;
    Truth value = Truth::unknown;
    double accuracy = 1;  ///< probability that the value is right, if it is not unknown; above 0.5
};

/// A position in metres in the world's frame.
struct Position {
    double x = 0, y = 0, z = 0;
};

struct Detection {
    std::string object;  ///< the observer's name for it; stable ids are the same from view to view
    std::string type;    ///< a type of the domain
    std::optional<Position> position;
    double confidence = 1;  ///< 0..1
};

struct Percept {
    std::vector<Reading> readings;
    std::vector<Detection> detections;
};

}  // namespace praxis::belief
