// What can go wrong in perception, as exceptions.
#pragma once

#include <stdexcept>

namespace praxis::belief {

/// A service or an image cannot be used: what() says what was asked, what happened, and what may mend it.
class PerceptionError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The caller's stop token asked for the end; nothing is wrong.
class StoppedError : public PerceptionError {
  public:
    StoppedError() : PerceptionError("stopped") {}
};

}  // namespace praxis::belief
