#include "search/task/finite_domain_task.hpp"

namespace praxis {

namespace {

template <class T>
std::size_t bytes(const std::vector<T>& items) {
    return items.capacity() * sizeof(T);
}

template <class T>
std::size_t bytes(const PackedLists<T>& lists) {
    return (lists.size() + 1) * sizeof(std::uint32_t) + bytes(lists.items());
}

std::size_t bytes(const NameTable& table) {
    std::size_t sum = bytes(table.symbols) + bytes(table.names);
    for (const std::string& symbol : table.symbols) {
        if (symbol.capacity() > std::string().capacity()) sum += symbol.capacity() + 1;
    }
    return sum;
}

}  // namespace

std::string FiniteDomainTask::fact_name(Fact fact) const {
    const std::uint32_t number = fact_number(fact);
    if (fact_forms[number] == FactForm::none_of_those) return "<none of those>";
    std::string text = fact_forms[number] == FactForm::atom ? "Atom " : "NegatedAtom ";
    const std::span<const std::uint32_t> words = fact_names.names[number];
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i == 1) text += '(';
        if (i > 1) text += ", ";
        text += fact_names.symbols[words[i]];
    }
    text += words.size() > 1 ? ")" : "()";
    return text;
}

std::size_t FiniteDomainTask::memory() const {
    return bytes(domain_sizes) + bytes(axiom_layers) + bytes(initial_values) + bytes(first_fact) +
           bytes(fact_names) + bytes(fact_forms) + bytes(preconditions) + bytes(effects) + bytes(conditions) +
           bytes(costs) + bytes(operator_names) + bytes(axioms) + bytes(axiom_bodies) + bytes(goal) +
           bytes(mutex_groups);
}

}  // namespace praxis
