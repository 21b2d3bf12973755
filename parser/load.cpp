#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "parser/check/check.hpp"
#include "parser/files.hpp"
#include "parser/parser.hpp"
#include "parser/reporter.hpp"
#include "parser/syntax/grammar.hpp"

namespace praxis {
namespace {

namespace fs = std::filesystem;

/// The text with the first `from` replaced; empty if there is none.
std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) return {};
    return text.replace(at, from.size(), to);
}

std::vector<fs::path> domain_candidates(const fs::path& problem) {
    const fs::path folder = problem.parent_path();
    const std::string name = problem.filename().string();
    const std::string stem = problem.stem().string();
    const std::string extension = problem.extension().string();
    std::vector<std::string> names = {"domain.pddl", stem + "-domain" + extension};
    if (const std::size_t end = stem.find_first_of("-_"); end != std::string::npos) {
        names.push_back(stem.substr(0, end) + "-domain.pddl");
    }
    for (const char* prefix : {"domain_", "domain-", "domain"}) names.push_back(prefix + name);
    for (const auto& [from, to] : {std::pair{"problem", "domain"}, {"prob", "domain"}, {"prob", "dom"}}) {
        names.push_back(replaced(name, from, to));
    }
    if (const std::size_t digit = stem.find_first_of("0123456789"); digit != std::string::npos) {
        const std::string number = stem.substr(digit, stem.find_first_not_of("0123456789", digit) - digit);
        names.push_back("domain" + number + ".pddl");
    }
    std::vector<fs::path> result;
    for (const std::string& candidate : names) {
        if (!candidate.empty() && candidate != name) result.push_back(folder / candidate);
    }
    result.push_back(folder / ".." / "domain.pddl");
    return result;
}

}  // namespace

LoadResult parse_task(Source domain, Source problem) {
    require_text(domain);
    require_text(problem);
    auto sources = std::make_shared<Sources>();
    sources->files.push_back(std::move(domain));
    sources->files.push_back(std::move(problem));
    syntax::SymbolTable symbols;
    Reporter reporter;
    const syntax::Tree domain_tree =
        syntax::parse(sources->files[0], 0, syntax::FileKind::domain, symbols, reporter);
    const syntax::Tree problem_tree =
        syntax::parse(sources->files[1], 1, syntax::FileKind::problem, symbols, reporter);
    auto task = std::make_shared<LiftedTask>();
    if (!domain_tree.broken && !problem_tree.broken) {
        *task = check::check(domain_tree, problem_tree, symbols, reporter);
    }
    task->sources = sources;
    LoadResult result;
    result.warnings = reporter.finish(*sources);
    result.task = std::move(task);
    return result;
}

LoadResult load_with_warnings(const std::string& domain_file, const std::string& problem_file) {
    if (domain_file == "-" && problem_file == "-") {
        fail_unplaced("the domain and the problem cannot both come from standard input");
    }
    Source domain = read_source(domain_file);
    return parse_task(std::move(domain), read_source(problem_file));
}

Task load(const std::string& domain_file, const std::string& problem_file) {
    return load_with_warnings(domain_file, problem_file).task;
}

std::string find_domain_file(const std::string& problem_file) {
    if (problem_file == "-") fail_unplaced("the domain of a problem from standard input must be named");
    std::string tried;
    for (const fs::path& candidate : domain_candidates(problem_file)) {
        std::error_code error;
        if (fs::is_regular_file(candidate, error)) return candidate.string();
        tried += (tried.empty() ? "" : ", ") + candidate.string();
    }
    fail_unplaced(problem_file + ": no domain file found beside it (tried " + tried + ")");
}

}  // namespace praxis
