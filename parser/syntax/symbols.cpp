#include "parser/syntax/symbols.hpp"

#include <algorithm>

namespace praxis::syntax {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Word::count)> kSpellings = {
    "and",
    "or",
    "not",
    "imply",
    "exists",
    "forall",
    "when",
    "=",
    "<",
    "<=",
    ">",
    ">=",
    "+",
    "-",
    "*",
    "/",
    "increase",
    "decrease",
    "assign",
    "scale-up",
    "scale-down",
    "define",
    "domain",
    "problem",
    "either",
    "minimize",
    "maximize",
    "object",
    "number",
    "total-cost",
    "total-time",
    "preference",
    "at",
    "over",
    "start",
    "end",
    "all",
    "always",
    "sometime",
    "within",
    "at-most-once",
    "sometime-after",
    "sometime-before",
    "always-within",
    "hold-during",
    "hold-after",
    "unknown",
    "oneof",
    "invariant",
    "at-least-one",
    "at-most-one",
    "exactly-one",
    "probabilistic",
    "stream",
    ":requirements",
    ":types",
    ":constants",
    ":predicates",
    ":functions",
    ":action",
    ":derived",
    ":parameters",
    ":precondition",
    ":effect",
    ":domain",
    ":objects",
    ":init",
    ":goal",
    ":metric",
    ":length",
    ":constraints",
    ":durative-action",
    ":process",
    ":event",
    ":task",
    ":method",
    ":htn",
    ":class",
    ":observe",
    ":sensing-model",
    ":default-sensing-model",
    ":sensor",
    ":condition",
    ":sense",
    ":variable",
    ":obs-variable",
    ":observable",
    ":sticky",
    ":open-world",
    ":decay",
    ":hidden",
    ":hidden-objects",
    ":stream",
    ":function",
    ":predicate",
    ":inputs",
    ":outputs",
    ":certified",
    ":fluents",
};

bool equal_folded(std::string_view word, const char* folded) {
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (fold(word[i]) != static_cast<std::uint8_t>(folded[i])) return false;
    }
    return true;
}

}  // namespace

std::string_view spelling(Word word) {
    return kSpellings[static_cast<std::size_t>(word)];
}

SymbolTable::SymbolTable() : slots_(1024, 0), mask_(1023) {
    for (const std::string_view word : kSpellings) intern(word);
}

std::uint32_t SymbolTable::hash_of(std::string_view word) {
    std::uint32_t hash = kHashSeed;
    for (const char c : word) hash = hash_step(hash, fold(c));
    return hash;
}

Symbol SymbolTable::intern(std::string_view word, std::uint32_t hash) {
    std::size_t slot = (hash ^ (hash >> 15)) & mask_;
    for (; slots_[slot] != 0; slot = (slot + 1) & mask_) {
        const Entry& entry = entries_[slots_[slot] - 1];
        if (entry.hash == hash && entry.length == word.size() &&
            equal_folded(word, letters_.data() + entry.offset)) {
            return static_cast<Symbol>(slots_[slot] - 1);
        }
    }
    entries_.push_back({letters_.size(), static_cast<std::uint32_t>(word.size()), hash});
    for (const char c : word) letters_ += static_cast<char>(fold(c));
    slots_[slot] = static_cast<std::uint32_t>(entries_.size());
    if (entries_.size() * 2 > slots_.size()) grow();
    return static_cast<Symbol>(entries_.size() - 1);
}

void SymbolTable::grow() {
    slots_.assign(slots_.size() * 4, 0);
    mask_ = slots_.size() - 1;
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
        const std::uint32_t hash = entries_[i].hash;
        std::size_t slot = (hash ^ (hash >> 15)) & mask_;
        while (slots_[slot] != 0) slot = (slot + 1) & mask_;
        slots_[slot] = i + 1;
    }
}

}  // namespace praxis::syntax
