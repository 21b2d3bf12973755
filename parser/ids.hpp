// Strong index types. An id is a dense index into a vector of its owner (a task's objects, operators, ...);
// ids of different kinds do not convert into each other, so that they cannot be mixed up.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace praxis {

template <class Tag>
class Id {
  public:
    /// The invalid id.
    constexpr Id() = default;
    constexpr explicit Id(std::size_t index) : index_(static_cast<std::uint32_t>(index)) {}

    constexpr std::uint32_t index() const { return index_; }
    constexpr bool valid() const { return index_ != kNone; }
    friend constexpr auto operator<=>(Id, Id) = default;

  private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t index_ = kNone;
};

using TypeId = Id<struct TypeTag>;
using PredicateId = Id<struct PredicateTag>;
using FunctionId = Id<struct FunctionTag>;
using ObjectId = Id<struct ObjectTag>;
using SchemaId = Id<struct SchemaTag>;

}  // namespace praxis

template <class Tag>
struct std::hash<praxis::Id<Tag>> {
    std::size_t operator()(praxis::Id<Tag> id) const noexcept { return id.index(); }
};
