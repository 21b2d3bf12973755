#include <memory>
#include <utility>

#include "parser/check/check.hpp"
#include "parser/check/streams/streams.hpp"
#include "parser/files.hpp"
#include "parser/reporter.hpp"
#include "parser/streams.hpp"
#include "parser/syntax/grammar.hpp"

namespace praxis {

StreamLoadResult parse_streams(Source domain, Source problem, Source streams) {
    auto sources = std::make_shared<Sources>();
    for (Source* source : {&domain, &problem, &streams}) {
        require_text(*source);
        sources->files.push_back(std::move(*source));
    }
    syntax::SymbolTable symbols;
    Reporter reporter;
    const auto parse = [&](std::uint32_t file, syntax::FileKind kind) {
        return syntax::parse(sources->files[file], file, kind, symbols, reporter);
    };
    const syntax::Tree domain_tree = parse(0, syntax::FileKind::domain);
    const syntax::Tree problem_tree = parse(1, syntax::FileKind::problem);
    const syntax::Tree stream_tree = parse(2, syntax::FileKind::streams);
    auto task = std::make_shared<LiftedTask>();
    StreamLoadResult result;
    if (!domain_tree.broken && !problem_tree.broken && !stream_tree.broken) {
        check::Context context(symbols, reporter, *task);
        check::check_task(context, domain_tree, problem_tree);
        check::check_streams(context, stream_tree, result.task);
        if (stream_tree.name) result.task.name = symbols.text(stream_tree.name->symbol);
    }
    task->sources = sources;
    result.warnings = reporter.finish(*sources);
    result.task.task = std::move(task);
    return result;
}

StreamLoadResult load_streams_with_warnings(const std::string& domain_file, const std::string& problem_file,
                                            const std::string& stream_file) {
    const std::string* const files[] = {&domain_file, &problem_file, &stream_file};
    int from_standard_input = 0;
    for (const std::string* file : files) from_standard_input += *file == "-" ? 1 : 0;
    if (from_standard_input > 1) fail_unplaced("only one file can come from standard input");
    Source domain = read_source(domain_file);
    Source problem = read_source(problem_file);
    return parse_streams(std::move(domain), std::move(problem), read_source(stream_file));
}

StreamTask load_streams(const std::string& domain_file, const std::string& problem_file,
                        const std::string& stream_file) {
    return load_streams_with_warnings(domain_file, problem_file, stream_file).task;
}

}  // namespace praxis
