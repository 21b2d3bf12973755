#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "parser/check/check.hpp"
#include "parser/parser.hpp"
#include "parser/reporter.hpp"
#include "parser/syntax/grammar.hpp"

namespace praxis {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSource = std::numeric_limits<std::uint32_t>::max() - 1;

[[noreturn]] void fail(const std::string& message) {
    Diagnostic diagnostic;
    diagnostic.placed = false;
    diagnostic.message = message;
    throw InputError(to_string(diagnostic, {}), {diagnostic});
}

void require_size(const Source& source) {
    if (source.text.size() > kLargestSource) fail(source.name + ": larger than 4 GiB");
}

std::string read_all(std::FILE* file, const std::string& name) {
    std::string text;
    std::size_t used = 0;
    do {
        text.resize(used + std::max<std::size_t>(std::size_t{1} << 16, used));
        used += std::fread(text.data() + used, 1, text.size() - used, file);
        if (used > kLargestSource) fail(name + ": larger than 4 GiB");
    } while (used == text.size());
    if (std::ferror(file) != 0) fail(name + ": cannot be read");
    text.resize(used);
    return text;
}

Source read(const std::string& file_name) {
    if (file_name == "-") return {"<stdin>", read_all(stdin, "<stdin>")};
    std::error_code error;
    if (fs::is_directory(file_name, error)) fail(file_name + ": is a directory, not a file");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(file_name.c_str(), "rb"),
                                                               &std::fclose);
    if (!file) fail(file_name + ": cannot be opened (" + std::strerror(errno) + ")");
    return {file_name, read_all(file.get(), file_name)};
}

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
    require_size(domain);
    require_size(problem);
    auto sources = std::make_shared<Sources>();
    sources->files.push_back(std::move(domain));
    sources->files.push_back(std::move(problem));
    for (const Source& source : sources->files) {
        if (source.text.find_first_not_of(" \t\r\n\v\f") == std::string::npos)
            fail(source.name + ": is empty");
    }
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
        fail("the domain and the problem cannot both come from standard input");
    }
    Source domain = read(domain_file);
    return parse_task(std::move(domain), read(problem_file));
}

Task load(const std::string& domain_file, const std::string& problem_file) {
    return load_with_warnings(domain_file, problem_file).task;
}

std::string find_domain_file(const std::string& problem_file) {
    if (problem_file == "-") fail("the domain of a problem from standard input must be named");
    std::string tried;
    for (const fs::path& candidate : domain_candidates(problem_file)) {
        std::error_code error;
        if (fs::is_regular_file(candidate, error)) return candidate.string();
        tried += (tried.empty() ? "" : ", ") + candidate.string();
    }
    fail(problem_file + ": no domain file found beside it (tried " + tried + ")");
}

}  // namespace praxis
