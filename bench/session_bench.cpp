// Planning again from a changed state: what a Session adds before the search starts, on a task of about a
// thousand ground actions (a van on a grid of 16 x 16 places with two parcels).
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

#include "search/session.hpp"

namespace {

constexpr int kSide = 16;

std::string place(int x, int y) {
    return "p" + std::to_string(x) + "-" + std::to_string(y);
}

praxis::Task grid_task() {
    const std::string domain =
        "(define (domain van) (:requirements :strips :typing) (:types place parcel)\n"
        "(:predicates (at ?p - place) (road ?a ?b - place) (in ?x - parcel ?p - place) (held ?x - parcel))\n"
        "(:action drive :parameters (?a ?b - place) :precondition (and (at ?a) (road ?a ?b))\n"
        " :effect (and (not (at ?a)) (at ?b)))\n"
        "(:action take :parameters (?x - parcel ?p - place) :precondition (and (at ?p) (in ?x ?p))\n"
        " :effect (and (not (in ?x ?p)) (held ?x)))\n"
        "(:action drop :parameters (?x - parcel ?p - place) :precondition (and (at ?p) (held ?x))\n"
        " :effect (and (not (held ?x)) (in ?x ?p))))\n";
    std::string objects;
    std::string init;
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y) {
            objects += " " + place(x, y);
            const auto road = [&](int u, int v) {
                if (u < kSide && v < kSide)
                    init += "(road " + place(x, y) + " " + place(u, v) + ") (road " + place(u, v) + " " +
                            place(x, y) + ")\n";
            };
            road(x + 1, y);
            road(x, y + 1);
        }
    const std::string problem =
        "(define (problem van) (:domain van) (:objects" + objects +
        " - place left right - parcel)\n(:init (at p0-0) (in left p3-4) (in right p9-9)\n" + init +
        ") (:goal (and (in left p0-0) (in right p0-0))))\n";
    return praxis::parse_task({"van.pddl", domain}, {"grid.pddl", problem}).task;
}

praxis::Atom atom(const praxis::LiftedTask& task, const std::string& predicate,
                  const std::vector<std::string>& arguments) {
    praxis::Atom result;
    for (std::size_t i = 0; i < task.predicates.size(); ++i)
        if (task.predicates[i].name == predicate) result.predicate = praxis::PredicateId(i);
    for (const std::string& name : arguments)
        for (std::size_t i = 0; i < task.objects.size(); ++i)
            if (task.objects[i].name == name) result.arguments.emplace_back(i);
    return result;
}

/// The van here, the parcels where they shall be: the search ends at once.
std::vector<praxis::Atom> solved_state(const praxis::LiftedTask& task, int x, int y) {
    return {atom(task, "at", {place(x, y)}), atom(task, "in", {"left", "p0-0"}),
            atom(task, "in", {"right", "p0-0"})};
}

void replan(benchmark::State& state, const char* expression) {
    const praxis::Task task = grid_task();
    praxis::Session session(task);
    const auto one = solved_state(*task, 3, 3);
    const auto two = solved_state(*task, 12, 5);
    const praxis::Configuration configuration = praxis::configuration(expression);
    bool first = true;
    for (auto _ : state) {
        session.set_initial_state(first ? one : two);
        first = !first;
        if (!session.plan(configuration).plan) std::abort();
    }
    if (session.groundings() != 1) std::abort();
    state.counters["operators"] = static_cast<double>(session.ground_task()->operator_count());
}

void set_initial_state(benchmark::State& state) {
    const praxis::Task task = grid_task();
    praxis::Session session(task);
    const auto one = solved_state(*task, 3, 3);
    const auto two = solved_state(*task, 12, 5);
    bool first = true;
    for (auto _ : state) {
        session.set_initial_state(first ? one : two);
        first = !first;
    }
}

void ground_again(benchmark::State& state) {
    const praxis::Task task = grid_task();
    for (auto _ : state) benchmark::DoNotOptimize(praxis::Session(task).groundings());
}

BENCHMARK(set_initial_state);
BENCHMARK_CAPTURE(replan, blind, "eager_greedy([goalcount()])");
BENCHMARK_CAPTURE(replan, ff, "lazy_greedy([ff()],preferred=[ff()])");
BENCHMARK(ground_again)->Unit(benchmark::kMillisecond);

}  // namespace
