// A small environment for tests: tokens on the places of a graph.
//
// (move t a b) takes token t along an edge; (mark t a) marks a token that stands on the last place. The
// parameter of `mark` must be within 0.2 of the state's last number, drawn for each task; `move` never fails.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "practice/environment.hpp"

namespace praxis::practice::test {

class Tokens : public SimulatedEnvironment {
  public:
    using Edges = std::vector<std::pair<int, int>>;

    Tokens(int tokens, int places, const Edges& edges) : tokens_(tokens) {
        description_.name = "tokens";
        description_.domain =
            R"((define (domain tokens) (:requirements :strips :typing :negative-preconditions)
            (:types token place)
            (:predicates (at ?t - token ?p - place) (edge ?a ?b - place) (end ?p - place) (marked ?t - token))
            (:action move :parameters (?t - token ?a ?b - place)
              :precondition (and (at ?t ?a) (edge ?a ?b)) :effect (and (not (at ?t ?a)) (at ?t ?b)))
            (:action mark :parameters (?t - token ?a - place)
              :precondition (and (at ?t ?a) (end ?a) (not (marked ?t))) :effect (marked ?t))))";
        std::string objects, init, goal;
        for (int t = 0; t < tokens; ++t) {
            description_.objects.push_back("t" + std::to_string(t));
            objects += " t" + std::to_string(t);
            init += " (at t" + std::to_string(t) + " p0)";
            goal += " (marked t" + std::to_string(t) + ")";
        }
        objects += " - token";
        for (int p = 0; p < places; ++p) {
            description_.objects.push_back("p" + std::to_string(p));
            objects += " p" + std::to_string(p);
        }
        objects += " - place";
        for (auto [a, b] : edges) init += " (edge p" + std::to_string(a) + " p" + std::to_string(b) + ")";
        init += " (end p" + std::to_string(places - 1) + ")";
        description_.problem = "(define (problem tokens-1) (:domain tokens) (:objects" + objects +
                               ") (:init" + init + ") (:goal (and" + goal + ")))";
        description_.predicates = {"at", "marked"};
        description_.schemas = {{"move", {}, {}, {}}, {"mark", {"force"}, {"wanted", "noise"}, {0}}};
        description_.horizon = tokens * (places + 2);
        description_.cycle_steps = 30;
    }

    const Description& description() const override { return description_; }
    /// Places of the tokens, whether they are marked, the wanted force.
    bool holds(const State& state, const GroundAtom& atom) const override {
        const auto token = static_cast<std::size_t>(atom.objects[0]);
        if (atom.predicate == 0) return state[token] == atom.objects[1] - tokens_;
        return state[static_cast<std::size_t>(tokens_) + token] == 1;
    }
    void propose(const State&, const GroundSkill&, Random& random,
                 std::span<double> parameters) const override {
        parameters[0] = uniform(random, -1, 1);
    }
    void features(const State& state, const GroundSkill& skill, std::span<double> features) const override {
        if (skill.schema == 0) return;
        features[0] = state.back();
        features[1] = state[0];
    }
    PracticeTask sample_task(Random& random) const override {
        PracticeTask task;
        task.initial.assign(static_cast<std::size_t>(2 * tokens_ + 1), 0);
        task.initial.back() = uniform(random, -0.7, 0.7);
        for (int t = 0; t < tokens_; ++t) task.goal.push_back({1, {t}});
        return task;
    }
    void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                 Random&) const override {
        const auto token = static_cast<std::size_t>(skill.objects[0]);
        if (skill.schema == 0)
            state[token] = skill.objects[2] - tokens_;
        else if (std::abs(parameters[0] - state.back()) < 0.2)
            state[static_cast<std::size_t>(tokens_) + token] = 1;
    }

  private:
    int tokens_;
    Description description_;
};

}  // namespace praxis::practice::test
