#include "support.hpp"

#include <vector>

#include "parser/diagnostic.hpp"
#include "search/engines/random.hpp"

namespace praxis::belief::testing {
namespace {

constexpr std::size_t kPropositions = 5;

std::string proposition(std::size_t number) {
    return "(p" + std::to_string(number) + ")";
}

std::string literal(Random& random) {
    const std::string atom = proposition(random.below(kPropositions));
    return random.below(3) == 0 ? "(not " + atom + ")" : atom;
}

std::string conjunction(Random& random, std::size_t least, std::size_t most) {
    std::string text = "(and";
    for (std::size_t i = least + random.below(most - least + 1); i > 0; --i) text += " " + literal(random);
    return text + ")";
}

}  // namespace

std::shared_ptr<const BeliefTask> ground(const Texts& texts) {
    const ContingentLoadResult loaded =
        parse_contingent({"domain.pddl", texts.domain}, {"problem.pddl", texts.problem});
    return ground_belief(loaded.task).task;
}

std::shared_ptr<const BeliefTask> ground_random(const Texts& texts) {
    try {
        std::shared_ptr<const BeliefTask> task = ground(texts);
        return task->physical->proved_unsolvable ? nullptr : task;
    } catch (const InputError&) {
        return nullptr;
    }
}

Texts random_task(std::uint64_t seed) {
    Random random(seed);
    Texts texts;
    texts.domain = "(define (domain d) (:predicates";
    for (std::size_t i = 0; i < kPropositions; ++i) texts.domain += " " + proposition(i);
    texts.domain += ") (:functions (total-cost))\n";
    const std::size_t actions = 4 + random.below(4);
    for (std::size_t a = 0; a < actions; ++a) {
        texts.domain += " (:action act" + std::to_string(a) + " :parameters () :precondition " +
                        conjunction(random, 1, 2) + " :effect (and (increase (total-cost) " +
                        std::to_string(random.below(4)) + ") " + literal(random);
        if (random.below(2) == 0) texts.domain += " (when " + literal(random) + " " + literal(random) + ")";
        texts.domain += ")";
        if (random.below(5) == 0) texts.domain += " :observe " + proposition(random.below(kPropositions));
        texts.domain += ")\n";
    }
    const std::size_t looks = 2 + random.below(3);
    for (std::size_t a = 0; a < looks; ++a)
        texts.domain += " (:action look" + std::to_string(a) + " :parameters () :precondition " +
                        conjunction(random, 0, 1) + " :observe " + proposition(random.below(kPropositions)) +
                        ")\n";
    if (random.below(3) == 0)
        texts.domain += " (:sensor sense :parameters () :condition " + literal(random) + " :sense " +
                        proposition(random.below(kPropositions)) + ")\n";
    texts.domain += ")";

    texts.problem = "(define (problem p) (:domain d) (:init (= (total-cost) 0)";
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < kPropositions; ++i) {
        if (random.below(2) == 0) {
            unknown.push_back(i);
            texts.problem += " (unknown " + proposition(i) + ")";
        } else if (random.below(2) == 0) {
            texts.problem += " " + proposition(i);
        }
    }
    if (unknown.size() >= 2) {
        texts.problem += random.below(2) == 0 ? " (oneof" : " (or";
        for (std::size_t i : unknown) texts.problem += " " + proposition(i);
        texts.problem += ")";
    }
    texts.problem +=
        ") (:goal (and " + literal(random) + " " + literal(random) + ")) (:metric minimize (total-cost)))";
    return texts;
}

Texts corridor(int columns, bool sensor) {
    Texts texts;
    texts.domain =
        "(define (domain corridor) (:requirements :typing) (:types place)\n"
        " (:predicates (at ?p - place) (beside ?p ?q - place) (open ?p - place))\n"
        " (:action move :parameters (?p ?q - place) :precondition (and (at ?p) (beside ?p ?q) (open ?q))\n"
        "  :effect (and (not (at ?p)) (at ?q)))\n";
    texts.domain +=
        sensor ? " (:sensor see :parameters (?p ?q - place) :condition (and (at ?p) (beside ?p ?q))\n"
                 "  :sense (open ?q)))"
               : " (:action look :parameters (?p ?q - place) :precondition (and (at ?p) (beside ?p ?q))\n"
                 "  :observe (open ?q)))";
    std::string objects, init, beside;
    const auto place = [](int x, int y) { return "c" + std::to_string(x) + std::to_string(y); };
    const auto join = [&](const std::string& a, const std::string& b) {
        beside += " (beside " + a + " " + b + ") (beside " + b + " " + a + ")";
    };
    for (int x = 0; x <= 2 * columns; ++x) {
        if (x % 2 == 1) init += " (oneof";
        for (int y = 0; y < 3; ++y) {
            objects += " " + place(x, y);
            init += " (open " + place(x, y) + ")";
            if (x > 0) join(place(x - 1, y), place(x, y));
            if (y > 0 && x % 2 == 0) join(place(x, y - 1), place(x, y));
        }
        if (x % 2 == 1) init += ")";
    }
    for (int x = 1; x < 2 * columns; x += 2)
        for (int y = 0; y < 3; ++y) init += " (unknown (open " + place(x, y) + "))";
    texts.problem = "(define (problem corridor-n) (:domain corridor) (:objects" + objects +
                    " - place) (:init (at c01)" + init + beside + ") (:goal (at " + place(2 * columns, 1) +
                    ")))";
    return texts;
}

}  // namespace praxis::belief::testing
