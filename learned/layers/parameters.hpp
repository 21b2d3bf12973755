// Where the parameters of each part of a model lie in one flat array.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace praxis::learned {

/// A named piece of the array.
struct ParameterBlock {
    std::string name;
    std::size_t first = 0, size = 0;

    template <class T>
    std::span<T> of(std::span<T> parameters) const {
        return parameters.subspan(first, size);
    }
};

/// Blocks one behind the other.
class ParameterLayout {
  public:
    /// A new block at the end; returns its description.
    ParameterBlock add(std::string name, std::size_t size) {
        blocks_.push_back({std::move(name), size_, size});
        size_ += size;
        return blocks_.back();
    }
    std::size_t size() const { return size_; }
    const std::vector<ParameterBlock>& blocks() const { return blocks_; }

  private:
    std::vector<ParameterBlock> blocks_;
    std::size_t size_ = 0;
};

}  // namespace praxis::learned
