#include "tamp/problems/generate.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "parser/files.hpp"
#include "tamp/problems/families.hpp"

namespace praxis::tamp {

namespace {

struct Generator {
    ProblemFamily family;
    GeneratedProblem (*make)(ProblemRequest);
};

const std::vector<Generator>& generators() {
    static const std::vector<Generator> all = {
        {{"blocked-shelf", "a target behind blockers in a cell of a shelf", "blockers", 1, 15, true},
         blocked_shelf},
        {{"blocks", "blocks to be stacked anew, one site out of reach", "blocks", 6, 14}, blocks},
        {{"clutter", "sticks to be sorted by colour", "sticks", 2, 40, true}, clutter},
        {{"hanoi", "the towers of Hanoi", "discs", 2, 7}, hanoi},
        {{"kitchen", "food to be washed, cooked and served", "pieces of food", 1, 8}, kitchen},
        {{"non-monotonic", "blockers that must return to where they stood", "blockers", 1, 8}, non_monotonic},
        {{"namo", "a parcel behind movable boxes, some of them in doors", "boxes", 20, 60}, namo},
        {{"packing", "pieces that just fit into a tray", "pieces", 3, 6, true}, packing},
        {{"point-cloud-shelf", "the blocked shelf as a noisy cloud of points", "blockers", 1, 8},
         point_cloud_shelf},
        {{"rooms", "things in rooms with doors, for a mobile robot", "things", 6, 20}, rooms},
        {{"rooms-octomap", "the same, the walls as an OctoMap", "things", 6, 20}, rooms_octomap},
    };
    return all;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    if (!file) fail_unplaced("cannot write " + path.string());
}

}  // namespace

const std::vector<ProblemFamily>& problem_families() {
    static const std::vector<ProblemFamily> families = [] {
        std::vector<ProblemFamily> all;
        for (const Generator& generator : generators()) all.push_back(generator.family);
        return all;
    }();
    return families;
}

GeneratedProblem generate_problem(std::string_view family, int size, std::uint64_t seed, bool feasible) {
    const auto& all = generators();
    const auto found =
        std::ranges::find(all, family, [](const Generator& generator) { return generator.family.name; });
    if (found == all.end()) {
        std::string names;
        for (const Generator& generator : all) names += (names.empty() ? "" : ", ") + generator.family.name;
        throw std::invalid_argument("there is no family of problems '" + std::string(family) +
                                    "'; there are " + names);
    }
    const ProblemFamily& what = found->family;
    if (size < what.smallest || size > what.largest) {
        throw std::invalid_argument("family '" + what.name + "' has " + std::to_string(what.smallest) +
                                    " to " + std::to_string(what.largest) + " " + what.size + ", not " +
                                    std::to_string(size));
    }
    if (!feasible && !what.has_twin) {
        throw std::invalid_argument("family '" + what.name + "' has no infeasible problems");
    }
    const std::string name = what.name + "-" + std::to_string(size) + "-" + std::to_string(seed);
    // Sizes of one seed get other random numbers.
    Random random(seed * 1000 + static_cast<std::uint64_t>(size));
    return found->make({feasible ? name : name + "-infeasible", size, Random(random.next()), feasible});
}

void write_problem(const GeneratedProblem& problem, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path path(folder);
    write_file(path / "problem.pddl", problem.problem);
    write_file(path / "scene.yaml", problem.scene);
    for (const auto& [name, bytes] : problem.files) write_file(path / name, bytes);
}

}  // namespace praxis::tamp
