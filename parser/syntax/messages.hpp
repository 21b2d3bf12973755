// What the grammar says about text it does not expect.
#pragma once

#include <string>
#include <string_view>

#include "parser/reporter.hpp"
#include "parser/syntax/grammar.hpp"

namespace praxis::syntax {

/// "domain", "problem", "stream file".
std::string_view describe(FileKind kind);

/// A word or character as a message shows it.
std::string describe(std::string_view found);

/// Reports a section that a file of this kind does not have, with the section that may be meant.
void report_unknown_section(Reporter& reporter, const Tree& tree, FileKind kind, const SymbolTable& symbols,
                            const Name& section);

}  // namespace praxis::syntax
