#include <cstdio>
#include <cstdlib>

#include "tests/tamp/support/bound_problem.hpp"

// tamp_bench FAMILY SIZE SEED SECONDS [infeasible]
int main(int argc, char** argv) {
    using namespace praxis;
    using namespace praxis::tamp;
    const bool feasible = argc < 6;
    const GeneratedProblem problem =
        generate_problem(argv[1], std::atoi(argv[2]), static_cast<std::uint64_t>(std::atoll(argv[3])), feasible);
    const std::string folder = "/tmp/praxis-bench";
    write_problem(problem, folder);
    const BoundProblem bound(problem, folder);
    for (const std::string& line : check_scene(bound.scene)) std::printf("! %s\n", line.c_str());
    Budget budget;
    budget.limit_wall_time(std::atof(argv[4]));
    const double begin = processor_seconds();
    const Refinement found = bound.refine(budget);
    const RefineStatistics& s = found.statistics;
    std::printf("%s %s %s: %s %.3f s; searches %lu skeletons %lu calls %lu samples %lu nogoods %lu+%lu; search %.3f sample %.3f ground %.3f ops %lu exact %d\n",
                argv[1], argv[2], argv[3], std::string(to_string(found.status)).c_str(), processor_seconds() - begin,
                s.searches, s.skeletons, s.stream_calls, s.samples, s.nogoods, s.soft_nogoods, s.search_seconds,
                s.sample_seconds, s.ground_seconds, s.operators, s.exact);
    for (const auto& [stream, count] : s.rejections) std::printf("   %s rejected %lu\n", stream.c_str(), count);
    if (found.plan && getenv("PLAN")) for (std::size_t i = 0; i < found.plan->steps.size(); ++i) std::printf("%s\n", found.plan->action(i).c_str());
    else if (found.plan) std::printf("   %zu actions\n", found.plan->steps.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(found.attempts.size(), 6); ++i) {
        const Attempt& a = found.attempts[i];
        std::printf("   %lu x %s %s: %s\n", a.count, a.action.c_str(), a.stream.c_str(), a.message.c_str());
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(found.reasons.size(), 6); ++i) std::printf("   because %s\n", found.reasons[i].c_str());
}
