// Problems for task and motion planning out of a generator: families of problems, each of a size and a seed.
//
//     write_problem(generate_problem("blocked-shelf", 5, 1), "shelf");
//     // shelf/problem.pddl, shelf/scene.yaml; its domain is domains/tamp/pick-place
//
// A family says what its size counts. Equal names, sizes and seeds give equal problems on every machine. Some
// families have infeasible twins: problems that look alike and have no solution, whatever is sampled.
//
// The families follow benchmarks of the field: Lagriffoul et al., "Platform-Independent Benchmarks for Task
// and Motion Planning", RA-L 2018 (hanoi, blocks, clutter, non-monotonic, kitchen); Stilman and Kuffner,
// "Navigation among movable obstacles", 2005 (namo).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace praxis::tamp {

struct GeneratedProblem {
    std::string domain = {};   ///< a folder of domains/tamp
    std::string problem = {};  ///< PDDL
    std::string scene = {};    ///< YAML (docs/scene-format.md)
    /// What the scene names besides: the bytes of maps, by file name.
    std::map<std::string, std::string> files = {};
};

struct ProblemFamily {
    std::string name = {};
    std::string description = {};  ///< one line
    std::string size = {};         ///< what the size counts: "blockers"
    int smallest = 1;
    int largest = 1;
    bool has_twin = false;  ///< infeasible problems can be had
};

const std::vector<ProblemFamily>& problem_families();

/// Throws std::invalid_argument for a family that is not there, a size out of its range, and an infeasible
/// twin that the family does not have.
GeneratedProblem generate_problem(std::string_view family, int size, std::uint64_t seed,
                                  bool feasible = true);

/// Writes problem.pddl, scene.yaml and the other files into the folder, which is made if need be. Throws
/// InputError where that cannot be done.
void write_problem(const GeneratedProblem& problem, const std::string& folder);

}  // namespace praxis::tamp
