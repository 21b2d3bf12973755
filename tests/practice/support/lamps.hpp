// An environment for tests with conditional effects, a derived predicate, and a skill that plans use again
// and again: lamps in a row.
//
// (toggle l) switches a lamp; (shift) lights the first lamp and each lamp behind one that is lit; (seal) can
// be executed where all are lit, and ends everything. Symbols only: nothing can be executed or proposed.
#pragma once

#include <string>

#include "practice/environment.hpp"

namespace praxis::practice::test {

class Lamps : public Environment {
  public:
    explicit Lamps(int lamps) {
        description_.name = "lamps";
        description_.domain = R"((define (domain lamps)
            (:requirements :typing :negative-preconditions :universal-preconditions :conditional-effects
                           :derived-predicates)
            (:types lamp)
            (:predicates (lit ?l - lamp) (first ?l - lamp) (next ?a ?b - lamp) (sealed) (all-lit))
            (:derived (all-lit) (forall (?l - lamp) (lit ?l)))
            (:action toggle :parameters (?l - lamp) :precondition (not (sealed))
              :effect (and (when (lit ?l) (not (lit ?l))) (when (not (lit ?l)) (lit ?l))))
            (:action shift :parameters () :precondition (not (sealed))
              :effect (and (forall (?l - lamp) (when (first ?l) (lit ?l)))
                           (forall (?a ?b - lamp) (when (and (next ?a ?b) (lit ?a)) (lit ?b)))))
            (:action seal :parameters () :precondition (and (all-lit) (not (sealed))) :effect (sealed))))";
        std::string objects, init = " (first l0)";
        for (int l = 0; l < lamps; ++l) {
            description_.objects.push_back("l" + std::to_string(l));
            objects += " l" + std::to_string(l);
            if (l > 0) init += " (next l" + std::to_string(l - 1) + " l" + std::to_string(l) + ")";
        }
        description_.problem = "(define (problem lamps-1) (:domain lamps) (:objects" + objects +
                               " - lamp) (:init" + init + ") (:goal (sealed)))";
        description_.predicates = {"lit", "sealed", "all-lit"};
        description_.schemas = {{"toggle", {}, {}, {}}, {"shift", {}, {}, {}}, {"seal", {}, {}, {}}};
        description_.horizon = description_.cycle_steps = 2 * lamps;
    }

    const Description& description() const override { return description_; }
    /// Each lamp's light, then the seal.
    bool holds(const State& state, const GroundAtom& atom) const override {
        return (atom.predicate == 1 ? state.back() : state[static_cast<std::size_t>(atom.objects[0])]) == 1;
    }
    void propose(const State&, const GroundSkill&, Random&, std::span<double>) const override {}
    void features(const State&, const GroundSkill&, std::span<double>) const override {}
    /// All dark.
    State dark() const { return State(description_.objects.size() + 1, 0); }

  private:
    Description description_;
};

}  // namespace praxis::practice::test
