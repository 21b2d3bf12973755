// host DOMAIN PROBLEM: plans within ten seconds and prints the plan.
#include <iostream>
#include <search/session.hpp>

int main(int argc, char** argv) try {
    if (argc != 3) return 31;
    const praxis::Task task = praxis::load(argv[1], argv[2]);
    praxis::Session session(task);
    praxis::Budget budget;
    budget.limit_wall_time(10);
    const praxis::Result result = session.plan(praxis::alias("agile"), budget);
    if (!result.plan) return 12;
    std::cout << praxis::to_string(*result.plan, *task);
} catch (const praxis::InputError& error) {
    std::cerr << error.what();
    return 31;
}
