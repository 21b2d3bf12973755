// Small tasks as texts.
#pragma once

#include <string>

namespace praxis::test {

/// A robot that moves along doors.
inline const std::string kWalkDomain =
    "(define (domain walk) (:requirements :strips :typing)\n"
    "  (:types room)\n"
    "  (:predicates (at ?r - room) (door ?a ?b - room))\n"
    "  (:action go :parameters (?a ?b - room)\n"
    "    :precondition (and (at ?a) (door ?a ?b))\n"
    "    :effect (and (not (at ?a)) (at ?b))))\n";

/// From a to d in three steps.
inline const std::string kWalkProblem =
    "(define (problem walk1) (:domain walk) (:objects a b c d - room)\n"
    "  (:init (at a) (door a b) (door b c) (door c d))\n"
    "  (:goal (at d)))\n";

inline const std::string kWalkPlan = "(go a b)\n(go b c)\n(go c d)\n";

/// The goal is cut off.
inline const std::string kCutOffProblem =
    "(define (problem walk2) (:domain walk) (:objects a b c d - room)\n"
    "  (:init (at a) (door a b) (door d c))\n"
    "  (:goal (at d)))\n";

/// Two keys in one hand: reachable without deletes, but not with them.
inline const std::string kKeysDomain =
    "(define (domain keys) (:requirements :strips)\n"
    "  (:predicates (free) (open ?x) (done ?x))\n"
    "  (:action use :parameters (?x) :precondition (and (free) (open ?x))\n"
    "    :effect (and (not (free)) (done ?x))))\n";
inline const std::string kKeysProblem =
    "(define (problem keys1) (:domain keys) (:objects k1 k2)\n"
    "  (:init (free) (open k1) (open k2)) (:goal (and (done k1) (done k2))))\n";

/// A sliding-tile puzzle that no blind search solves soon (the 24-puzzle, rows reversed).
std::string hard_tiles_problem();

}  // namespace praxis::test
