#include "parser/syntax/messages.hpp"

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
    const bool domain = kind == FileKind::domain;
    static constexpr Word kDomain[] = {
        Word::k_requirements, Word::k_types,        Word::k_constants,
        Word::k_predicates,   Word::k_functions,    Word::k_action,
        Word::k_derived,      Word::k_sensor,       Word::k_default_sensing_model,
        Word::k_observable,   Word::k_sticky,       Word::k_open_world,
        Word::k_variable,     Word::k_obs_variable, Word::k_decay};
    static constexpr Word kProblem[] = {Word::k_requirements, Word::k_domain,        Word::k_objects,
                                        Word::k_init,         Word::k_goal,          Word::k_metric,
                                        Word::k_hidden,       Word::k_hidden_objects};
    Suggestion suggestion(symbols.text(section.symbol));
    bool elsewhere = false;
    for (const Word word : kDomain) {
        if (domain) suggestion.consider(spelling(word));
        elsewhere = elsewhere || section.symbol == word;
    }
    for (const Word word : kProblem) {
        if (!domain) suggestion.consider(spelling(word));
        elsewhere = elsewhere || section.symbol == word;
    }
    const std::string own = domain ? "domain" : "problem";
    reporter.error(tree.where(section), "a " + own + " has no section " + quote(tree.spelled(section)),
                   elsewhere ? std::string("it belongs into the ") + (domain ? "problem" : "domain")
                             : suggestion.hint());
}

}  // namespace praxis::syntax
