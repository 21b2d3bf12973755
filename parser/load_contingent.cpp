#include <memory>
#include <utility>

#include "parser/check/contingent/contingent.hpp"
#include "parser/contingent.hpp"
#include "parser/files.hpp"
#include "parser/reporter.hpp"
#include "parser/syntax/grammar.hpp"

namespace praxis {

bool ContingentTask::contingent() const {
    const auto any = [](const std::vector<bool>& marks) {
        for (const bool mark : marks) {
            if (mark) return true;
        }
        return false;
    };
    for (const SchemaSensing& schema : sensing) {
        if (!schema.observations.empty() || !schema.model.empty() || !schema.forgotten.empty()) return true;
    }
    return !sensors.empty() || !default_model.empty() || !default_observations.empty() ||
           !variables.empty() || !unknown.empty() || !clauses.empty() || !hidden_objects.empty() ||
           !decays.empty() || any(open_world) || any(declared_observable);
}

ContingentLoadResult parse_contingent(Source domain, Source problem, std::vector<Source> worlds) {
    auto sources = std::make_shared<Sources>();
    sources->files.push_back(std::move(domain));
    sources->files.push_back(std::move(problem));
    for (Source& world : worlds) sources->files.push_back(std::move(world));
    for (const Source& source : sources->files) require_text(source);
    syntax::SymbolTable symbols;
    Reporter reporter;
    std::vector<syntax::Tree> trees;
    bool broken = false;
    for (std::uint32_t i = 0; i < sources->files.size(); ++i) {
        const syntax::FileKind kind = i == 0 ? syntax::FileKind::domain : syntax::FileKind::problem;
        trees.push_back(syntax::parse(sources->files[i], i, kind, symbols, reporter));
        broken = broken || trees.back().broken;
    }
    auto task = std::make_shared<ContingentTask>();
    auto lifted = std::make_shared<LiftedTask>();
    if (!broken) {
        const std::vector<syntax::Tree> world_trees(std::make_move_iterator(trees.begin() + 2),
                                                    std::make_move_iterator(trees.end()));
        check::CheckedContingentTask checked =
            check::check_contingent(trees[0], trees[1], world_trees, symbols, reporter);
        *task = std::move(checked.contingent);
        *lifted = std::move(checked.lifted);
    }
    lifted->sources = sources;
    task->task = std::move(lifted);
    ContingentLoadResult result;
    result.warnings = reporter.finish(*sources);
    result.task = std::move(task);
    return result;
}

ContingentLoadResult load_contingent(const std::string& domain_file, const std::string& problem_file,
                                     const std::vector<std::string>& world_files) {
    std::size_t from_standard_input = (domain_file == "-" ? 1U : 0U) + (problem_file == "-" ? 1U : 0U);
    for (const std::string& file : world_files) from_standard_input += file == "-" ? 1U : 0U;
    if (from_standard_input > 1) fail_unplaced("only one file can come from standard input");
    Source domain = read_source(domain_file);
    Source problem = read_source(problem_file);
    std::vector<Source> worlds;
    for (const std::string& file : world_files) worlds.push_back(read_source(file));
    return parse_contingent(std::move(domain), std::move(problem), std::move(worlds));
}

}  // namespace praxis
