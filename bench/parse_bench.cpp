// Reading PDDL: megabytes a second of the parser alone and of parsing with all checks.
// Run: bin/parse_bench DOMAIN PROBLEM [--benchmark_...]; without files, on a generated task of about a
// megabyte.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iostream>
#include <sstream>

#include "parser/parser.hpp"
#include "parser/syntax/grammar.hpp"

namespace {

using praxis::Source;

std::string file_text(const char* name) {
    std::ifstream file(name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Source grid_domain() {
    return {"domain.pddl",
            "(define (domain grid) (:requirements :typing) (:types place)\n"
            "(:predicates (at ?p - place) (visited ?p - place) (connected ?a ?b - place))\n"
            "(:action move :parameters (?a ?b - place) :precondition (and (at ?a) (connected ?a ?b))\n"
            " :effect (and (not (at ?a)) (at ?b) (visited ?b))))\n"};
}

Source grid_problem(int side) {
    std::ostringstream text;
    const auto place = [&](int x, int y) { text << " loc-x" << x << "-y" << y; };
    text << "(define (problem grid) (:domain grid)\n(:objects";
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) place(x, y);
    }
    text << " - place)\n(:init (at loc-x0-y0)\n";
    const auto connect = [&](int x, int y, int u, int v) {
        if (u >= side || v >= side) return;
        for (int turn = 0; turn < 2; ++turn, std::swap(x, u), std::swap(y, v)) {
            text << "  (connected";
            place(x, y);
            place(u, v);
            text << ")\n";
        }
    };
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            connect(x, y, x + 1, y);
            connect(x, y, x, y + 1);
        }
    }
    text << ")\n(:goal (visited loc-x1-y1)))\n";
    return {"problem.pddl", text.str()};
}

void set_bytes(benchmark::State& state, const Source& domain, const Source& problem) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(domain.text.size() + problem.text.size()));
}

void parse_only(benchmark::State& state, const Source& domain, const Source& problem) {
    for (auto _ : state) {
        praxis::syntax::SymbolTable symbols;
        praxis::Reporter reporter;
        using praxis::syntax::FileKind;
        benchmark::DoNotOptimize(praxis::syntax::parse(domain, 0, FileKind::domain, symbols, reporter));
        benchmark::DoNotOptimize(praxis::syntax::parse(problem, 1, FileKind::problem, symbols, reporter));
    }
    set_bytes(state, domain, problem);
}

void parse_and_check(benchmark::State& state, const Source& domain, const Source& problem) {
    for (auto _ : state) benchmark::DoNotOptimize(praxis::parse_task(domain, problem));
    set_bytes(state, domain, problem);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc != 1 && argc != 3) {
        std::cerr << "usage: parse_bench [DOMAIN PROBLEM] [--benchmark_...]\n";
        return 2;
    }
    const Source domain = argc == 3 ? Source{argv[1], file_text(argv[1])} : grid_domain();
    const Source problem = argc == 3 ? Source{argv[2], file_text(argv[2])} : grid_problem(90);
    benchmark::RegisterBenchmark("parse", [&](benchmark::State& state) {
        parse_only(state, domain, problem);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("parse_and_check", [&](benchmark::State& state) {
        parse_and_check(state, domain, problem);
    })->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
}
