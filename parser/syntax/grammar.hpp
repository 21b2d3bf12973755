// PDDL's grammar.
#pragma once

#include "parser/reporter.hpp"
#include "parser/source.hpp"
#include "parser/syntax/tree.hpp"

namespace praxis::syntax {

enum class FileKind { domain, problem, streams };

/// The tree of one file; `file` is its number in locations. The tree refers to the source's text. Syntax
/// errors go to the reporter; after one, parsing goes on with the next section, so that the tree is as
/// complete as can be.
Tree parse(const Source& source, std::uint32_t file, FileKind kind, SymbolTable& symbols, Reporter& reporter);

}  // namespace praxis::syntax
