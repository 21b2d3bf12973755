// Errors and warnings that name the place and the mend.
//
//     problem.pddl:14:9: error: unknown object 'truck9'
//       14 |   (at truck9 depot0)
//          |       ^~~~~~ did you mean 'truck0'?
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "parser/source.hpp"

namespace praxis {

enum class Severity { warning, error, unsupported };

struct Diagnostic {
    Severity severity = Severity::error;
    Location where;
    bool placed = true;   ///< false: `where` means nothing (a missing file, say)
    std::string message;  ///< one sentence without a final stop
    std::string hint;     ///< shown behind the caret; may be empty
};

/// The text of one diagnostic in the form above, with a final newline.
std::string to_string(const Diagnostic& diagnostic, const Sources& sources);

/// The input cannot be used. what() is the text of all errors (and warnings that came before), in order.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string text, std::vector<Diagnostic> diagnostics = {})
        : std::runtime_error(std::move(text)), diagnostics_(std::move(diagnostics)) {}
    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    std::vector<Diagnostic> diagnostics_;
};

/// The input is right but uses something that Praxis does not plan for.
class UnsupportedError : public InputError {
  public:
    using InputError::InputError;
};

}  // namespace praxis
