// Any bytes as a plan file for a small task with every kind of condition: a plan or an InputError, then a
// verdict.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "parser/parser.hpp"
#include "search/validate.hpp"

namespace {

constexpr const char* kDomain = R"((define (domain yard)
  (:requirements :adl :derived-predicates :action-costs)
  (:types engine track)
  (:predicates (at ?e - engine ?t - track) (rail ?a ?b - track) (locked ?t - track) (linked ?a ?b - track))
  (:functions (length ?a ?b - track) - number (total-cost) - number)
  (:derived (linked ?a ?b - track)
    (or (rail ?a ?b) (exists (?c - track) (and (linked ?a ?c) (rail ?c ?b) (not (locked ?c))))))
  (:action go :parameters (?e - engine ?from ?to - track)
    :precondition (and (at ?e ?from) (linked ?from ?to) (forall (?o - engine) (imply (at ?o ?to) (= ?o ?e))))
    :effect (and (not (at ?e ?from)) (at ?e ?to) (increase (total-cost) (length ?from ?to))))
  (:action toggle :parameters (?t - track)
    :effect (and (when (locked ?t) (not (locked ?t))) (when (not (locked ?t)) (locked ?t))
                 (increase (total-cost) (/ 1 3))))
  (:action clear :parameters () :effect (forall (?t - track) (not (locked ?t))))))";

constexpr const char* kProblem = R"((define (problem p) (:domain yard)
  (:objects e f - engine a b c d - track)
  (:init (at e a) (at f d) (rail a b) (rail b c) (rail c a) (rail c d) (locked b)
         (= (length a b) 1.5) (= (length b c) 9223372036854775807) (= (length c a) 2) (= (total-cost) 0))
  (:goal (and (at e b) (exists (?t - track) (not (linked ?t a)))))
  (:metric minimize (total-cost))))";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const praxis::Task task =
        praxis::parse_task({"domain.pddl", kDomain}, {"problem.pddl", kProblem}).task;
    try {
        const praxis::Source source{"plan", std::string(reinterpret_cast<const char*>(data), size)};
        const praxis::Plan plan = praxis::parse_plan(source, *task).plan;
        const praxis::Verdict verdict = praxis::validate(*task, plan);
        if (verdict.valid != verdict.reason.empty() || verdict.step > plan.steps.size() + 1) std::abort();
        const praxis::Plan again = praxis::parse_plan({"again", praxis::to_string(plan, *task)}, *task).plan;
        if (again.steps != plan.steps) std::abort();
    } catch (const praxis::InputError&) {
    }
    return 0;
}
