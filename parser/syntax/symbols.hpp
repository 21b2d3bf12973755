// Names as numbers. PDDL names ignore case, so the table holds them folded to lower case (ASCII letters only;
// other characters stand for themselves); two spellings of one name are one symbol. The words of the language
// come first, so that asking whether a name is reserved is one comparison.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace praxis::syntax {

enum class Symbol : std::uint32_t {};

constexpr std::uint32_t index(Symbol symbol) {
    return static_cast<std::uint32_t>(symbol);
}

/// For each byte: itself in lower case if it may stand in a word (a name, variable, keyword or number), else
/// 0.
inline constexpr std::array<std::uint8_t, 256> kFold = [] {
    std::array<std::uint8_t, 256> table{};
    for (unsigned c = 0x21; c < 256; ++c) table[c] = static_cast<std::uint8_t>(c);
    for (unsigned c = 'A'; c <= 'Z'; ++c) table[c] = static_cast<std::uint8_t>(c - 'A' + 'a');
    table['('] = table[')'] = table[';'] = table[0x7F] = 0;
    return table;
}();

constexpr std::uint8_t fold(char c) {
    return kFold[static_cast<unsigned char>(c)];
}

class SymbolTable {
  public:
    SymbolTable();

    /// The symbol of a word; `hash` must be hash_of(word).
    Symbol intern(std::string_view word, std::uint32_t hash);
    Symbol intern(std::string_view word) { return intern(word, hash_of(word)); }

    /// The word, folded. Valid until the next call of intern.
    std::string_view text(Symbol symbol) const {
        const Entry& entry = entries_[index(symbol)];
        return {letters_.data() + entry.offset, entry.length};
    }

    std::size_t size() const { return entries_.size(); }

    static constexpr std::uint32_t kHashSeed = 2166136261U;
    static constexpr std::uint32_t hash_step(std::uint32_t hash, std::uint8_t folded) {
        return (hash ^ folded) * 16777619U;
    }
    static std::uint32_t hash_of(std::string_view word);

  private:
    struct Entry {
        std::size_t offset;
        std::uint32_t length;
        std::uint32_t hash;
    };

    void grow();

    std::string letters_;
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> slots_;  ///< open addressing; symbol + 1, or 0
    std::size_t mask_ = 0;
};

/// The words of the language, as the first symbols of every table.
enum class Word : std::uint32_t {
    // Heads with a syntax of their own: no predicate can be called so.
    conjunction,
    disjunction,
    negation,
    implication,
    existential,
    universal,
    when,
    equal,
    less,
    less_equal,
    greater,
    greater_equal,
    plus,
    minus,
    times,
    divide,
    increase,
    decrease,
    assign,
    scale_up,
    scale_down,
    // Words with a meaning in some places only.
    define,
    domain,
    problem,
    either,
    minimize,
    maximize,
    object,
    number,
    total_cost,
    total_time,
    preference,
    at,
    over,
    start,
    end,
    all,
    always,
    sometime,
    within,
    at_most_once,
    sometime_after,
    sometime_before,
    always_within,
    hold_during,
    hold_after,
    unknown,
    oneof,
    invariant,
    at_least_one,
    at_most_one,
    exactly_one,
    probabilistic,
    stream,
    // Keywords.
    k_requirements,
    k_types,
    k_constants,
    k_predicates,
    k_functions,
    k_action,
    k_derived,
    k_parameters,
    k_precondition,
    k_effect,
    k_domain,
    k_objects,
    k_init,
    k_goal,
    k_metric,
    k_length,
    k_constraints,
    k_durative_action,
    k_process,
    k_event,
    k_task,
    k_method,
    k_htn,
    k_class,
    k_observe,
    k_sensing_model,
    k_default_sensing_model,
    k_sensor,
    k_condition,
    k_sense,
    k_variable,
    k_obs_variable,
    k_observable,
    k_sticky,
    k_open_world,
    k_decay,
    k_hidden,
    k_hidden_objects,
    k_stream,
    k_function,
    k_predicate,
    k_inputs,
    k_outputs,
    k_certified,
    k_fluents,
    count
};

inline constexpr std::uint32_t kReserved = static_cast<std::uint32_t>(Word::scale_down) + 1;

/// How a word of the language is written.
std::string_view spelling(Word word);

constexpr Symbol symbol_of(Word word) {
    return static_cast<Symbol>(word);
}
constexpr bool operator==(Symbol symbol, Word word) {
    return symbol == symbol_of(word);
}
constexpr bool is_reserved(Symbol symbol) {
    return index(symbol) < kReserved;
}

}  // namespace praxis::syntax
