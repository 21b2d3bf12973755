#include "search/state/successor_generator.hpp"

#include <numeric>
#include <span>

namespace praxis {

// Facts are renumbered so that their numbers sort by the rank of their variable; an operator's key is its
// sorted list of such numbers.
class SuccessorGeneratorBuilder {
  public:
    SuccessorGeneratorBuilder(const FiniteDomainTask& task, const Budget& budget)
        : task_(task), budget_(budget) {}

    std::vector<std::uint32_t> build() {
        rank_variables();
        make_keys();
        if (!stopped()) sort_operators();
        code_.assign(1, SuccessorGenerator::end);
        if (!stopped()) write_tree();
        keys_ = {};
        code_.shrink_to_fit();
        return std::move(code_);
    }

  private:
    struct Pending {
        std::uint32_t patch;  // where the place of the node is to be written
        std::uint32_t begin;
        std::uint32_t end;
        std::uint32_t depth;
    };

    bool stopped() const { return budget_.exhausted() != Stop::none; }
    bool poll() { return (++steps_ & 0xfff) == 0 && stopped(); }

    std::span<const std::uint32_t> key(std::uint32_t operator_index) const {
        const std::uint32_t begin = task_.preconditions.begin_of(operator_index);
        return {keys_.data() + begin, task_.preconditions[operator_index].size()};
    }

    void rank_variables() {
        const std::size_t variables = task_.variable_count();
        std::vector<std::uint32_t> mentions(variables, 0);
        for (const Fact& fact : task_.preconditions.items())
            ++mentions[static_cast<std::size_t>(fact.variable)];
        order_.resize(variables);
        std::iota(order_.begin(), order_.end(), 0u);
        std::stable_sort(order_.begin(), order_.end(),
                         [&](auto a, auto b) { return mentions[a] > mentions[b]; });
        first_key_.resize(variables);
        key_variable_.reserve(task_.fact_count());
        for (std::uint32_t variable : order_) {
            first_key_[variable] = static_cast<std::uint32_t>(key_variable_.size());
            key_variable_.resize(
                key_variable_.size() + static_cast<std::size_t>(task_.domain_sizes[variable]), variable);
        }
    }

    void make_keys() {
        keys_.reserve(task_.preconditions.total());
        for (std::size_t i = 0; i < task_.operator_count(); ++i) {
            if (poll()) return;
            const std::size_t begin = keys_.size();
            for (const Fact& fact : task_.preconditions[i]) {
                keys_.push_back(first_key_[static_cast<std::size_t>(fact.variable)] +
                                static_cast<std::uint32_t>(fact.value));
            }
            std::sort(keys_.begin() + static_cast<std::ptrdiff_t>(begin), keys_.end());
        }
    }

    // Counting sort by the first fact, then comparisons within the groups that share it.
    void sort_operators() {
        std::vector<std::uint32_t> group_end(key_variable_.size() + 2, 0);
        const auto group = [&](std::uint32_t i) {
            const auto facts = key(i);
            return facts.empty() ? 0u : facts[0] + 1;
        };
        const auto count = static_cast<std::uint32_t>(task_.operator_count());
        for (std::uint32_t i = 0; i < count; ++i) ++group_end[group(i) + 1];
        std::partial_sum(group_end.begin(), group_end.end(), group_end.begin());
        sorted_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) sorted_[group_end[group(i)]++] = i;
        std::uint32_t begin = 0;
        for (std::uint32_t end : group_end) {
            if (end <= begin + 1) {
                begin = std::max(begin, end);
                continue;
            }
            if (stopped()) return;
            std::sort(sorted_.begin() + begin, sorted_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
                const auto left = key(a), right = key(b);
                const auto order = std::lexicographical_compare_three_way(left.begin(), left.end(),
                                                                          right.begin(), right.end());
                return order != 0 ? order < 0 : a < b;
            });
            begin = end;
        }
    }

    void write_tree() {
        std::vector<Pending> pending;
        pending.push_back({0, 0, static_cast<std::uint32_t>(sorted_.size()), 0});
        code_.clear();
        bool root = true;
        while (!pending.empty()) {
            const Pending node = pending.back();
            pending.pop_back();
            if (!root) code_[node.patch] = static_cast<std::uint32_t>(code_.size());
            root = false;
            const std::size_t first_child = pending.size();
            write_node(node, pending);
            std::reverse(pending.begin() + static_cast<std::ptrdiff_t>(first_child), pending.end());
            if (poll()) return;
        }
    }

    void write_node(const Pending& node, std::vector<Pending>& pending) {
        std::uint32_t i = node.begin;
        while (i < node.end && key(sorted_[i]).size() == node.depth) ++i;
        if (i > node.begin) {
            header(SuccessorGenerator::leaf, i - node.begin);
            code_.insert(code_.end(), sorted_.begin() + node.begin, sorted_.begin() + i);
        }
        while (i < node.end) {
            const std::uint32_t begin = i;
            const std::uint32_t variable = key_variable_[key(sorted_[i])[node.depth]];
            while (i < node.end && key_variable_[key(sorted_[i])[node.depth]] == variable) ++i;
            if (i - begin == 1) {
                write_tests(sorted_[begin], node.depth);
            } else {
                write_switch(variable, begin, i, node.depth, pending);
            }
        }
        code_.push_back(SuccessorGenerator::end);
    }

    void write_tests(std::uint32_t operator_index, std::uint32_t depth) {
        const auto facts = key(operator_index).subspan(depth);
        header(SuccessorGenerator::tests, static_cast<std::uint32_t>(facts.size()));
        code_.push_back(operator_index);
        for (std::uint32_t fact : facts) {
            code_.push_back(key_variable_[fact]);
            code_.push_back(value_of(fact));
        }
    }

    void write_switch(std::uint32_t variable, std::uint32_t begin, std::uint32_t end, std::uint32_t depth,
                      std::vector<Pending>& pending) {
        branches_.clear();
        for (std::uint32_t i = begin; i < end;) {
            const std::uint32_t from = i;
            const std::uint32_t fact = key(sorted_[i])[depth];
            while (i < end && key(sorted_[i])[depth] == fact) ++i;
            branches_.push_back({value_of(fact), from, i, depth + 1});
        }
        const auto domain = static_cast<std::uint32_t>(task_.domain_sizes[variable]);
        const auto count = static_cast<std::uint32_t>(branches_.size());
        const bool is_dense = domain <= 8 || domain <= 3 * count;
        header(is_dense ? SuccessorGenerator::dense : SuccessorGenerator::sparse, is_dense ? domain : count);
        code_.push_back(variable);
        const auto table = static_cast<std::uint32_t>(code_.size());
        if (is_dense) {
            code_.resize(code_.size() + domain, 0);
        } else {
            for (const Pending& branch : branches_) code_.push_back(branch.patch);
            code_.resize(code_.size() + count, 0);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            Pending child = branches_[i];
            child.patch = is_dense ? table + child.patch : table + count + i;
            pending.push_back(child);
        }
    }

    void header(std::uint32_t kind, std::uint32_t count) { code_.push_back(count << 3 | kind); }
    std::uint32_t value_of(std::uint32_t fact) const { return fact - first_key_[key_variable_[fact]]; }

    const FiniteDomainTask& task_;
    const Budget& budget_;
    std::uint64_t steps_ = 0;
    std::vector<std::uint32_t> order_;         // variables by rank
    std::vector<std::uint32_t> first_key_;     // by variable: the number of its value 0
    std::vector<std::uint32_t> key_variable_;  // by number of a fact
    std::vector<std::uint32_t> keys_;          // parallel to the items of task.preconditions
    std::vector<std::uint32_t> sorted_;
    std::vector<Pending> branches_;  // `patch` holds the value
    std::vector<std::uint32_t> code_;
};

SuccessorGenerator::SuccessorGenerator(const FiniteDomainTask& task, const Budget& budget)
    : code_(SuccessorGeneratorBuilder(task, budget).build()) {}

}  // namespace praxis
