// Which operators are applicable in a state: a decision tree in one flat array.
//
// The operators are sorted by their preconditions, variables ranked by how many operators mention them. A
// node of the tree is a run of items, each item a header word (kind in the low three bits, a count above) and
// its data:
//
//     end     no more items in this node
//     leaf    count operators, applicable here
//     tests   one operator with count facts left to check: operator, then variable and value of each
//     dense   a switch over a variable of domain size count: variable, then the place of a node by value (0:
//     none) sparse  a switch with count values: variable, the values in increasing order, then the nodes
//
// Items of one node are independent: all are looked at, which makes the "don't care" branches of a decision
// tree. Derived variables may occur, the state must be complete.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/budget.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

class SuccessorGenerator {
  public:
    /// If the budget runs out, the generator is incomplete; the budget then says so.
    explicit SuccessorGenerator(const FiniteDomainTask& task, const Budget& budget = {});

    /// Calls visit(OperatorId) once for each applicable operator, always in the same order.
    template <class Visit>
    void for_each(const std::int32_t* values, Visit&& visit) const {
        walk(0, values, visit);
    }
    /// The same into a vector, which is cleared first.
    void applicable(const std::int32_t* values, std::vector<OperatorId>& operators) const {
        operators.clear();
        walk(0, values, [&](OperatorId id) { operators.push_back(id); });
    }

    /// Bytes on the heap.
    std::size_t memory() const { return code_.capacity() * sizeof(std::uint32_t); }

  private:
    enum Kind : std::uint32_t { end, leaf, tests, dense, sparse };

    template <class Visit>
    void walk(std::uint32_t place, const std::int32_t* values, Visit&& visit) const {
        for (const std::uint32_t* item = code_.data() + place;;) {
            const std::uint32_t count = *item >> 3;
            switch (*item++ & 7) {
                case leaf:
                    for (std::uint32_t i = 0; i < count; ++i) visit(OperatorId(item[i]));
                    item += count;
                    break;
                case tests: {
                    const std::uint32_t* fact = item + 1;
                    const std::uint32_t* last = fact + 2 * count;
                    while (fact != last && values[fact[0]] == static_cast<std::int32_t>(fact[1])) fact += 2;
                    if (fact == last) visit(OperatorId(*item));
                    item = last;
                    break;
                }
                case dense: {
                    const std::uint32_t child = item[1 + static_cast<std::uint32_t>(values[*item])];
                    if (child != 0) walk(child, values, visit);
                    item += 1 + count;
                    break;
                }
                case sparse: {
                    const auto value = static_cast<std::uint32_t>(values[*item]);
                    const std::uint32_t* first = item + 1;
                    const std::uint32_t* found = std::lower_bound(first, first + count, value);
                    if (found != first + count && *found == value) walk(found[count], values, visit);
                    item += 1 + 2 * count;
                    break;
                }
                default:
                    return;
            }
        }
    }

    friend class SuccessorGeneratorBuilder;
    std::vector<std::uint32_t> code_;
};

}  // namespace praxis
