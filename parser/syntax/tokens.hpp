// The terminals of the grammar as Spirit X3 parsers: words of several kinds, keywords, parentheses, and the
// gap (space and comments) between them. A word is scanned, folded and hashed in one pass and becomes a
// symbol at once; no string is made.
#pragma once

#include <boost/spirit/home/x3.hpp>

#include <functional>
#include <string>

#include "parser/suggest.hpp"
#include "parser/syntax/builder.hpp"

namespace praxis::syntax {

namespace x3 = boost::spirit::x3;

struct BuilderTag;

template <class Context>
Builder& builder(const Context& context) {
    return x3::get<BuilderTag>(context).get();
}

/// True for well-formed UTF-8.
bool is_utf8(std::string_view text);

/// Space and comments.
struct GapParser : x3::parser<GapParser> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    static const char* skip(const char* at, const char* last) {
        while (at != last) {
            const char c = *at;
            if (c == ' ' || (c >= '\t' && c <= '\r')) {
                ++at;
            } else if (c == ';') {
                while (at != last && *at != '\n') ++at;
            } else {
                break;
            }
        }
        return at;
    }

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context&, RuleContext&, Attribute&) const {
        const char* const begin = first;
        first = skip(first, last);
        return first != begin;
    }
};

enum class WordKind : std::uint8_t { name, variable, keyword, term, operand, any };

/// Whether a word that starts so may be of the kind.
constexpr bool may_be(WordKind kind, const char* first, std::size_t length) {
    const bool lone_dash = length == 1 && *first == '-';
    switch (kind) {
        case WordKind::name:
            return *first != '?' && *first != ':' && *first != '-';
        case WordKind::variable:
            return *first == '?' && length > 1;
        case WordKind::keyword:
            return *first == ':' && length > 1;
        case WordKind::term:
            return *first != ':' && *first != '-' && !(*first == '?' && length == 1);
        case WordKind::operand:
            return *first != ':' && !lone_dash && !(*first == '?' && length == 1);
        case WordKind::any:
            return true;
    }
    return false;
}

/// One word of a kind. With `free`, not a reserved one.
template <WordKind kind, bool free = false>
struct WordParser : x3::parser<WordParser<kind, free>> {
    using attribute_type = Name;
    static constexpr bool has_attribute = true;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        x3::skip_over(first, last, context);
        const char* at = first;
        std::uint32_t hash = SymbolTable::kHashSeed;
        std::uint8_t seen = 0;
        while (at != last) {
            const std::uint8_t letter = fold(*at);
            if (letter == 0 || (letter == '?' && at != first)) break;
            hash = SymbolTable::hash_step(hash, letter);
            seen |= letter;
            ++at;
        }
        const auto length = static_cast<std::size_t>(at - first);
        if (length == 0 || !may_be(kind, first, length)) return false;
        Builder& target = builder(context);
        const std::uint32_t offset = target.offset_of(first);
        if (seen >= 0x80 && !is_utf8({first, length})) {
            throw SyntaxError{offset, static_cast<std::uint32_t>(length), "text that is not UTF-8"};
        }
        const Symbol symbol = target.symbols().intern({first, length}, hash);
        if (free && is_reserved(symbol)) return false;
        x3::traits::move_to(Name{symbol, offset, static_cast<std::uint32_t>(length)}, attribute);
        first = at;
        return true;
    }
};

/// One word of the language.
struct KeywordParser : x3::parser<KeywordParser> {
    using attribute_type = Name;
    static constexpr bool has_attribute = true;

    explicit constexpr KeywordParser(Word wanted) : word(wanted) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        x3::skip_over(first, last, context);
        const std::string_view wanted = spelling(word);
        const auto left = static_cast<std::size_t>(last - first);
        if (left < wanted.size()) return false;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (fold(first[i]) != static_cast<std::uint8_t>(wanted[i])) return false;
        }
        if (left > wanted.size() && fold(first[wanted.size()]) != 0) return false;
        x3::traits::move_to(Name{symbol_of(word), builder(context).offset_of(first),
                                 static_cast<std::uint32_t>(wanted.size())},
                            attribute);
        first += wanted.size();
        return true;
    }

    Word word;
};

/// One of ( and ). The attribute is its offset; `description` says what else could stand there.
struct ParenthesisParser : x3::parser<ParenthesisParser> {
    using attribute_type = std::uint32_t;
    static constexpr bool has_attribute = true;

    constexpr ParenthesisParser(char c, const char* text) : character(c), description(text) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        x3::skip_over(first, last, context);
        if (first == last || *first != character) return false;
        x3::traits::move_to(builder(context).offset_of(first), attribute);
        ++first;
        return true;
    }

    char character;
    const char* description;
};

inline constexpr GapParser gap{};
inline constexpr WordParser<WordKind::name> name{};
inline constexpr WordParser<WordKind::name, true> free_name{};
inline constexpr WordParser<WordKind::variable> variable{};
inline constexpr WordParser<WordKind::keyword> keyword{};
inline constexpr WordParser<WordKind::term> term{};
inline constexpr WordParser<WordKind::operand> operand_word{};
inline constexpr WordParser<WordKind::any> any_word{};
inline constexpr ParenthesisParser opening{'(', "'('"};

constexpr KeywordParser word(Word wanted) {
    return KeywordParser(wanted);
}
constexpr ParenthesisParser closing(const char* description = "')'") {
    return {')', description};
}

}  // namespace praxis::syntax

namespace boost::spirit::x3 {

template <praxis::syntax::WordKind kind, bool free>
struct get_info<praxis::syntax::WordParser<kind, free>> {
    using result_type = std::string;
    std::string operator()(const praxis::syntax::WordParser<kind, free>&) const {
        using praxis::syntax::WordKind;
        switch (kind) {
            case WordKind::name:
                return "a name";
            case WordKind::variable:
                return "a variable (such as '?x')";
            case WordKind::keyword:
                return "a keyword (such as ':typing')";
            case WordKind::term:
                return "a name or a variable";
            case WordKind::operand:
                return "a name, a variable or a number";
            case WordKind::any:
                break;
        }
        return "a word";
    }
};

template <class Subject, class Action>
struct get_info<action<Subject, Action>> {
    using result_type = std::string;
    std::string operator()(const action<Subject, Action>& parser) const { return what(parser.subject); }
};

template <class Left, class Right>
struct get_info<sequence<Left, Right>> {
    using result_type = std::string;
    std::string operator()(const sequence<Left, Right>& parser) const { return what(parser.left); }
};

template <class Left, class Right>
struct get_info<alternative<Left, Right>> {
    using result_type = std::string;
    std::string operator()(const alternative<Left, Right>& parser) const {
        return what(parser.left) + " or " + what(parser.right);
    }
};

template <>
struct get_info<praxis::syntax::KeywordParser> {
    using result_type = std::string;
    std::string operator()(const praxis::syntax::KeywordParser& parser) const {
        return praxis::quote(praxis::syntax::spelling(parser.word));
    }
};

template <>
struct get_info<praxis::syntax::ParenthesisParser> {
    using result_type = std::string;
    std::string operator()(const praxis::syntax::ParenthesisParser& parser) const {
        return parser.description;
    }
};

}  // namespace boost::spirit::x3
