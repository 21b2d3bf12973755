#include "parser/syntax/messages.hpp"

#include <optional>
#include <span>
#include <utility>

#include "parser/suggest.hpp"
#include "parser/syntax/tokens.hpp"

namespace praxis::syntax {

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const auto lead = static_cast<unsigned char>(text[at]);
        const std::size_t more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC2 ? 1 : 4;
        if (lead > 0xF4 || more == 4 || at + more >= text.size()) return false;
        for (std::size_t i = 1; i <= more; ++i) {
            if ((static_cast<unsigned char>(text[at + i]) & 0xC0U) != 0x80U) return false;
        }
        at += more + 1;
    }
    return true;
}

std::string_view describe(FileKind kind) {
    return kind == FileKind::domain ? "domain" : kind == FileKind::problem ? "problem" : "stream file";
}

std::string describe(std::string_view found) {
    constexpr std::size_t kLongest = 60;
    const auto byte = static_cast<unsigned char>(found[0]);
    if (byte < 0x20 || byte == 0x7F || !is_utf8(found)) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        return std::string("the byte 0x") + kDigits[byte / 16] + kDigits[byte % 16];
    }
    if (found.size() > kLongest) return "a long word";
    return quote(found);
}

void report_unknown_section(Reporter& reporter, const Tree& tree, FileKind kind, const SymbolTable& symbols,
                            const Name& section) {
    static constexpr Word kDomain[] = {
        Word::k_requirements, Word::k_types,        Word::k_constants,
        Word::k_predicates,   Word::k_functions,    Word::k_action,
        Word::k_derived,      Word::k_sensor,       Word::k_default_sensing_model,
        Word::k_observable,   Word::k_sticky,       Word::k_open_world,
        Word::k_variable,     Word::k_obs_variable, Word::k_decay};
    static constexpr Word kProblem[] = {Word::k_requirements, Word::k_domain,        Word::k_objects,
                                        Word::k_init,         Word::k_goal,          Word::k_metric,
                                        Word::k_hidden,       Word::k_hidden_objects};
    static constexpr Word kStreams[] = {Word::k_stream, Word::k_function, Word::k_predicate};
    static constexpr std::pair<FileKind, std::span<const Word>> kSections[] = {
        {FileKind::domain, kDomain}, {FileKind::problem, kProblem}, {FileKind::streams, kStreams}};
    Suggestion suggestion(symbols.text(section.symbol));
    std::optional<FileKind> elsewhere;
    for (const auto& [owner, words] : kSections) {
        for (const Word word : words) {
            if (owner == kind) suggestion.consider(spelling(word));
            if (owner != kind && !elsewhere && section.symbol == word) elsewhere = owner;
        }
    }
    // ":predicate" in a domain is a misspelling rather than a part of a stream file.
    if (elsewhere == FileKind::streams && suggestion.found()) elsewhere.reset();
    reporter.error(
        tree.where(section),
        "a " + std::string(describe(kind)) + " has no section " + quote(tree.spelled(section)),
        elsewhere ? "it belongs into the " + std::string(describe(*elsewhere)) : suggestion.hint());
}

}  // namespace praxis::syntax
