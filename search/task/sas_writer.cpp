#include <algorithm>
#include <charconv>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "search/task/sas.hpp"

namespace praxis {

namespace {

/// Collects text and hands it to a stream in large pieces.
class Writer {
  public:
    explicit Writer(std::ostream& out) : out_(out) {}
    ~Writer() { flush(); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    Writer& operator<<(std::string_view text) {
        buffer_ += text;
        if (buffer_.size() > kFlushAt) flush();
        return *this;
    }
    Writer& operator<<(std::int64_t number) {
        char digits[24];
        const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
        return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
    }
    Writer& operator<<(Fact fact) {
        return *this << std::int64_t{fact.variable} << " " << std::int64_t{fact.value};
    }

  private:
    static constexpr std::size_t kFlushAt = 1 << 16;

    void flush() {
        out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        buffer_.clear();
    }

    std::ostream& out_;
    std::string buffer_;
};

void write_lines(Writer& out, std::span<const Fact> facts) {
    out << static_cast<std::int64_t>(facts.size()) << "\n";
    for (const Fact fact : facts) out << fact << "\n";
}

/// What one operator says about each variable; kept between operators to be cleared cheaply.
struct OperatorScratch {
    explicit OperatorScratch(std::size_t variables) : before(variables, -1), affected(variables, false) {}
    std::vector<std::int32_t> before;
    std::vector<char> affected;
};

void write_operator(Writer& out, const FiniteDomainTask& task, std::size_t index, OperatorScratch& scratch) {
    const std::span<const Fact> preconditions = task.preconditions[index];
    const std::span<const GroundEffect> effects = task.effects[index];
    const auto at = [](Fact fact) { return static_cast<std::size_t>(fact.variable); };
    for (const Fact fact : preconditions) scratch.before[at(fact)] = fact.value;
    for (const GroundEffect& effect : effects) scratch.affected[at(effect.fact)] = true;

    const auto prevails = [&](Fact fact) { return !scratch.affected[at(fact)]; };
    out << "begin_operator\n"
        << task.operator_names.words(index) << "\n"
        << std::int64_t{std::ranges::count_if(preconditions, prevails)} << "\n";
    for (const Fact fact : preconditions) {
        if (prevails(fact)) out << fact << "\n";
    }
    out << static_cast<std::int64_t>(effects.size()) << "\n";
    for (const GroundEffect& effect : effects) {
        const std::span<const Fact> conditions = task.conditions[effect.condition];
        out << static_cast<std::int64_t>(conditions.size()) << " ";
        for (const Fact fact : conditions) out << fact << " ";
        out << std::int64_t{effect.fact.variable} << " " << std::int64_t{scratch.before[at(effect.fact)]}
            << " " << std::int64_t{effect.fact.value} << "\n";
    }
    out << std::int64_t{task.costs[index]} << "\nend_operator\n";

    for (const Fact fact : preconditions) scratch.before[at(fact)] = -1;
    for (const GroundEffect& effect : effects) scratch.affected[at(effect.fact)] = false;
}

}  // namespace

void write_sas(const FiniteDomainTask& task, std::ostream& stream) {
    Writer out(stream);
    const bool extra_variable = task.goal.empty() || task.proved_unsolvable;
    const auto variables = static_cast<std::int64_t>(task.variable_count());

    out << "begin_version\n3\nend_version\nbegin_metric\n"
        << std::int64_t{!task.unit_cost} << "\nend_metric\n";
    out << variables + (extra_variable ? 1 : 0) << "\n";
    for (std::int32_t variable = 0; variable < variables; ++variable) {
        const std::size_t index = static_cast<std::size_t>(variable);
        out << "begin_variable\nvar" << std::int64_t{variable} << "\n"
            << std::int64_t{task.axiom_layers[index]} << "\n"
            << std::int64_t{task.domain_sizes[index]} << "\n";
        for (std::int32_t value = 0; value < task.domain_sizes[index]; ++value) {
            out << task.fact_name({variable, value}) << "\n";
        }
        out << "end_variable\n";
    }
    if (extra_variable) {
        out << "begin_variable\nvar" << variables
            << "\n-1\n2\nAtom dummy(val1)\nAtom dummy(val2)\nend_variable\n";
    }

    out << static_cast<std::int64_t>(task.mutex_groups.size()) << "\n";
    for (std::size_t i = 0; i < task.mutex_groups.size(); ++i) {
        out << "begin_mutex_group\n";
        write_lines(out, task.mutex_groups[i]);
        out << "end_mutex_group\n";
    }

    out << "begin_state\n";
    for (const std::int32_t value : task.initial_values) out << std::int64_t{value} << "\n";
    if (extra_variable) out << "0\n";
    out << "end_state\nbegin_goal\n";
    std::vector<Fact> goal = task.goal;
    if (extra_variable)
        goal.push_back({static_cast<std::int32_t>(variables), task.proved_unsolvable ? 1 : 0});
    write_lines(out, goal);
    out << "end_goal\n";

    std::int64_t operators = 0;
    for (std::size_t i = 0; i < task.operator_count(); ++i) operators += task.effects[i].empty() ? 0 : 1;
    out << operators << "\n";
    OperatorScratch scratch(task.variable_count());
    for (std::size_t i = 0; i < task.operator_count(); ++i) {
        if (!task.effects[i].empty()) write_operator(out, task, i, scratch);
    }

    out << static_cast<std::int64_t>(task.axioms.size()) << "\n";
    for (std::size_t i = 0; i < task.axioms.size(); ++i) {
        const Fact head = task.axioms[i].head;
        const std::int32_t fallback = task.initial_values[static_cast<std::size_t>(head.variable)];
        out << "begin_rule\n";
        write_lines(out, task.axiom_bodies[i]);
        out << std::int64_t{head.variable} << " " << std::int64_t{fallback} << " " << std::int64_t{head.value}
            << "\nend_rule\n";
    }
}

}  // namespace praxis
