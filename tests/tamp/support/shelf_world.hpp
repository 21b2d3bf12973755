// A shelf of rows: whoever takes an item, or puts one, must reach past the cells in front of it. The stream
// that plans the reach sees where the items are and blames those in its way.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tamp/refine/refine.hpp"

namespace praxis::tamp::test {

struct Cell {
    int row = 0;
    int depth = 0;  ///< 0: in front
};

/// Items 0, 1, ... start in cells (by number); the goal is to hold `target`.
struct ShelfWorld {
    int rows = 2;
    int depths = 3;
    std::vector<int> start = {};   ///< cell of each item; cell = row * depths + depth
    std::vector<int> walled = {};  ///< cells that nothing can reach
    int target = 0;
    bool definite = true;  ///< the stream's rejections are
    bool each = true;      ///< the stream says that one item in the way is enough

    StreamTask task() const {
        std::string objects = "(:objects";
        for (std::size_t i = 0; i < start.size(); ++i) objects += " i" + std::to_string(i);
        objects += " - item";
        for (int c = 0; c < rows * depths; ++c) objects += " c" + std::to_string(c);
        objects += " - cell)";
        std::string init = "(:init (hand-empty)";
        std::vector<bool> taken(static_cast<std::size_t>(rows * depths), false);
        for (std::size_t i = 0; i < start.size(); ++i) {
            init += " (at i" + std::to_string(i) + " c" + std::to_string(start[i]) + ")";
            taken[static_cast<std::size_t>(start[i])] = true;
        }
        for (std::size_t c = 0; c < taken.size(); ++c)
            if (!taken[c]) init += " (free c" + std::to_string(c) + ")";
        return parse_streams({"domain.pddl", kDomain},
                             {"problem.pddl", "(define (problem shelf) (:domain shelf) " + objects + init +
                                                  ") (:goal (held i" + std::to_string(target) + ")))"},
                             {"streams.pddl", kStreams})
            .task;
    }

    std::map<std::string, Value, std::less<>> values() const {
        std::map<std::string, Value, std::less<>> result;
        for (int c = 0; c < rows * depths; ++c)
            result["c" + std::to_string(c)] = Value::of(Cell{c / depths, c % depths});
        return result;
    }

    StreamLibrary library() const {
        StreamLibrary library;
        const ShelfWorld world = *this;
        StreamInfo info;
        info.max_samples = 1;
        info.effort = 1000;
        library.bind(
            "plan-reach", [world](StreamCall& call) { return world.plan(call); }, info);
        return library;
    }

    bool is_walled(const Cell& cell) const {
        for (const int c : walled)
            if (cell.row == c / depths && cell.depth == c % depths) return true;
        return false;
    }

    StreamResult plan(StreamCall& call) const {
        const Cell& goal = call.inputs[1].get<Cell>();
        if (is_walled(goal))
            return StreamResult::reject({.reason = Reason::kinematics, .message = "walled in"});
        Blame blame;
        blame.reason = Reason::collision;
        blame.message = "in the way";
        blame.definite = definite;
        blame.each = each;
        for (std::uint32_t i = 0; i < call.fluents.size(); ++i) {
            const Cell& there = call.fluents[i].arguments[1].get<Cell>();
            if (there.row == goal.row && there.depth < goal.depth) blame.fluents.push_back(i);
        }
        if (!blame.fluents.empty()) return StreamResult::reject(std::move(blame));
        return StreamResult::sample({Value::of(goal)});
    }

    static constexpr const char* kDomain = R"(
(define (domain shelf)
  (:requirements :typing)
  (:types item cell path)
  (:predicates (at ?i - item ?c - cell) (held ?i - item) (hand-empty) (free ?c - cell)
               (reach ?i - item ?c - cell ?t - path))
  (:action take
    :parameters (?i - item ?c - cell ?t - path)
    :precondition (and (hand-empty) (at ?i ?c) (reach ?i ?c ?t))
    :effect (and (held ?i) (free ?c) (not (at ?i ?c)) (not (hand-empty))))
  (:action put
    :parameters (?i - item ?c - cell ?t - path)
    :precondition (and (held ?i) (free ?c) (reach ?i ?c ?t))
    :effect (and (at ?i ?c) (hand-empty) (not (held ?i)) (not (free ?c)))))
)";
    static constexpr const char* kStreams = R"(
(define (stream shelf)
  (:stream plan-reach
    :inputs (?i - item ?c - cell)
    :outputs (?t - path)
    :fluents (at)
    :certified (reach ?i ?c ?t)))
)";
};

}  // namespace praxis::tamp::test
