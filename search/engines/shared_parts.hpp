// What evaluators of several engines have in common, made once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace praxis {

/// Immutable structures by name, all for one task and query. May be used by several threads at once.
class SharedParts {
  public:
    /// The part of that name, made by `make()`, which returns a shared pointer to T, where it is not there
    /// yet. A name always stands for the same type.
    template <class T, class Make>
    std::shared_ptr<const T> get(const std::string& name, const Make& make) {
        const std::scoped_lock lock(mutex_);
        std::shared_ptr<const void>& part = parts_[name];
        if (!part) part = make();
        return std::static_pointer_cast<const T>(part);
    }

  private:
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const void>> parts_;
};

}  // namespace praxis
