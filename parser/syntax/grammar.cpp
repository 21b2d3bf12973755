#include "parser/syntax/grammar.hpp"

#include <algorithm>
#include <string>

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

namespace {

// Actions.

const auto open = [](auto& context) { builder(context).open(x3::_attr(context)); };
const auto close = [](auto& context) { builder(context).close(x3::_attr(context)); };
const auto enter = [](auto& context) { builder(context).enter(x3::_attr(context)); };
const auto leave = [](auto& context) { builder(context).leave(); };
const auto add_argument = [](auto& context) { builder(context).add_argument(x3::_attr(context)); };
const auto mark_nested = [](auto& context) { builder(context).mark_nested(); };
const auto add_word = [](auto& context) { builder(context).add_word(x3::_attr(context)); };
const auto bind = [](auto& context) { builder(context).bind(builder(context).list()); };
const auto begin_list = [](auto& context) { builder(context).begin_list(); };
const auto add_item = [](auto& context) { builder(context).add_item(x3::_attr(context)); };
const auto begin_types = [](auto& context) { builder(context).begin_types(); };
const auto add_type = [](auto& context) { builder(context).add_type(x3::_attr(context)); };
const auto apply_types = [](auto& context) { builder(context).apply_types(); };

template <NodeKind kind>
const auto head = [](auto& context) { builder(context).set_head(kind, x3::_attr(context)); };

// Typed lists.

const x3::rule<struct TypeClass> type("a type");
const auto either = (opening >> word(Word::either)) > *name[add_type] > closing("a type or ')'");
const auto type_def = x3::eps[begin_types] >> (name[add_type] | either);

template <class Item>
auto typed_list(const Item& item) {
    return x3::eps[begin_list] >> *((+item[add_item]) >> (-(word(Word::minus) > type)[apply_types]));
}

const x3::rule<struct NamesClass> typed_names("names");
const x3::rule<struct VariablesClass> typed_variables("variables");
const auto typed_names_def = typed_list(name);
const auto typed_variables_def = typed_list(variable);

// Conditions, effects, expressions, facts.

const x3::rule<struct ListClass> list("'('");
const x3::rule<struct BodyClass> body("a predicate or a word such as 'and', 'not', 'forall'");
const x3::rule<struct OperandClass> operand("a name, a variable, a number or '('");

const auto argument = term[add_argument] | list[mark_nested];
const auto operand_def = operand_word[add_word] | list;
const auto close_atom = closing("an argument or ')'")[close];
const auto close_lists = closing("'(' or ')'")[close];
const auto close_operands = closing("an operand or ')'")[close];
const auto close_list = closing()[close];

template <NodeKind kind, class... Words>
auto one_of(Words... words) {
    return (word(words)[head<kind>] | ...);
}

const auto comparison =
    one_of<NodeKind::comparison>(Word::less, Word::less_equal, Word::greater, Word::greater_equal);
const auto arithmetic = one_of<NodeKind::arithmetic>(Word::plus, Word::minus, Word::times, Word::divide);
const auto assignment = one_of<NodeKind::assignment>(Word::increase, Word::decrease, Word::assign,
                                                     Word::scale_up, Word::scale_down);

// An assignment's first operand is a list; otherwise its word is a predicate like any other.
const auto body_def = (free_name[head<NodeKind::atom>] > *argument > close_atom) |
                      (word(Word::conjunction)[head<NodeKind::conjunction>] > *list > close_lists) |
                      (word(Word::negation)[head<NodeKind::negation>] > list > close_list) |
                      (word(Word::equal)[head<NodeKind::equality>] > operand > operand > close_list) |
                      (word(Word::disjunction)[head<NodeKind::disjunction>] > *list > close_lists) |
                      (word(Word::implication)[head<NodeKind::implication>] > list > list > close_list) |
                      (word(Word::when)[head<NodeKind::when>] > list > list > close_list) |
                      ((word(Word::universal)[head<NodeKind::universal>] |
                        word(Word::existential)[head<NodeKind::existential>]) > opening > typed_variables >
                       closing("a variable or ')'")[bind] > list > close_list) |
                      (comparison > operand > operand > close_list) |
                      (arithmetic > *operand > close_operands) |
                      ((assignment >> &opening) > operand > operand > close_list) |
                      (name[head<NodeKind::atom>] > *argument > close_atom) | close_list;

const auto list_def = opening[open] > body;

// Sections that are skipped.
const x3::rule<struct SkippedClass> skipped("'('");
const auto skipped_def = opening[enter] > *(any_word | skipped) > closing("a word, '(' or ')'")[leave];

BOOST_SPIRIT_DEFINE(type, typed_names, typed_variables, list, body, operand, skipped)

// Files.

bool is_section_start(const char* at, const char* last) {
    if (at == last || *at != '(') return false;
    at = GapParser::skip(at + 1, last);
    return at != last && *at == ':';
}

class FileParser {
  public:
    FileParser(const Source& source, std::uint32_t file, FileKind kind, SymbolTable& symbols,
               Reporter& reporter)
        : kind_(kind), reporter_(reporter), symbols_(symbols), builder_(tree_, symbols) {
        tree_.file = file;
        tree_.text = source.text;
        at_ = source.text.data();
        last_ = at_ + source.text.size();
        if (std::string_view(source.text).substr(0, 3) == "\xEF\xBB\xBF") at_ += 3;
        reserve();
    }

    Tree parse() {
        if (guarded([this] { parse_header(); }) || !stopped_) parse_sections();
        return std::move(tree_);
    }

  private:
    void reserve() {
        const std::size_t size = tree_.text.size();
        tree_.nodes.reserve(size / 24);
        tree_.names.reserve(size / 12);
    }

    template <class Parser>
    void run(const Parser& parser) {
        const auto with_builder = x3::with<BuilderTag>(std::ref(builder_))[x3::expect[parser]];
        x3::phrase_parse(at_, last_, with_builder, gap, x3::skip_flag::dont_post_skip);
    }

    /// False if there was a syntax error, which is then reported and passed over.
    template <class Part>
    bool guarded(Part part) {
        const char* const begin = at_;
        try {
            part();
            return true;
        } catch (const x3::expectation_failure<const char*>& failure) {
            report(failure.where(), failure.which(), begin);
            recover(std::max(failure.where(), begin + 1));
        } catch (const SyntaxError& error) {
            reporter_.error({tree_.file, error.offset, error.length}, error.message);
            recover(std::max(tree_.text.data() + error.offset, begin + 1));
        }
        builder_.abandon();
        return false;
    }

    void recover(const char* at) {
        at = std::min(at, last_);
        while (at != last_ && !is_section_start(at, last_)) {
            if (*at == ';')
                at = GapParser::skip(at, last_);
            else
                ++at;
        }
        at_ = at;
    }

    void report(const char* at, const std::string& expected, const char* begin) {
        at = GapParser::skip(at, last_);
        std::string hint;
        if (at == last_) {
            const auto lines = std::count(tree_.text.data(), begin, '\n') + 1;
            if (begin != last_) hint = "is a ')' missing? This part starts in line " + std::to_string(lines);
            while (at != tree_.text.data() && (at[-1] == ' ' || (at[-1] >= '\t' && at[-1] <= '\r'))) --at;
            reporter_.error({tree_.file, builder_.offset_of(at), 0},
                            "expected " + expected + ", found the end of the file", hint);
            return;
        }
        const char* end = at;
        while (end != last_ && fold(*end) != 0) ++end;
        const bool is_word = end != at;
        if (!is_word) ++end;
        const std::string_view found(at, static_cast<std::size_t>(end - at));
        if (is_word) hint = swapped_hint(expected, found);
        reporter_.error({tree_.file, builder_.offset_of(at), static_cast<std::uint32_t>(found.size())},
                        "expected " + expected + ", found " + describe(found), hint);
    }

    static std::string describe(std::string_view found) {
        constexpr std::size_t kLongest = 60;
        const auto byte = static_cast<unsigned char>(found[0]);
        if (byte < 0x20 || byte == 0x7F || !is_utf8(found)) {
            constexpr std::string_view kDigits = "0123456789abcdef";
            return std::string("the byte 0x") + kDigits[byte / 16] + kDigits[byte % 16];
        }
        if (found.size() > kLongest) return "a long word";
        return quote(found);
    }

    std::string swapped_hint(const std::string& expected, std::string_view found) {
        const bool domain_expected = kind_ == FileKind::domain;
        const Word own = domain_expected ? Word::domain : Word::problem;
        const Word other = domain_expected ? Word::problem : Word::domain;
        if (expected != quote(spelling(own)) || symbols_.intern(found) != other) return {};
        stopped_ = true;
        return domain_expected ? "this is a problem; the domain's file comes first"
                               : "this is a domain; the problem's file comes second";
    }

    void parse_header() {
        const Word kind = kind_ == FileKind::domain ? Word::domain : Word::problem;
        const auto set_name = [this](auto& context) { tree_.name = x3::_attr(context); };
        run(opening > word(Word::define) > opening > word(kind) > name[set_name] > closing());
    }

    void parse_sections() {
        const char* const define = at_;
        for (;;) {
            at_ = GapParser::skip(at_, last_);
            if (at_ == last_) {
                if (!tree_.broken) report(at_, "a section or ')'", define);
                return;
            }
            if (*at_ == ')') break;
            guarded([this] { parse_section(); });
        }
        at_ = GapParser::skip(at_ + 1, last_);
        if (at_ != last_ && !tree_.broken) {
            const std::string what = kind_ == FileKind::domain ? "domain" : "problem";
            reporter_.error({tree_.file, builder_.offset_of(at_), 1}, "text after the end of the " + what,
                            "is there a ')' too many before it?");
            tree_.broken = true;
        }
    }

    void parse_section() {
        Name section;
        run(opening > keyword[([&](auto& context) { section = x3::_attr(context); })]);
        const bool domain = kind_ == FileKind::domain;
        const auto is = [&](Word wanted) { return section.symbol == wanted; };
        if (is(Word::k_requirements)) return parse_requirements(section);
        if (is(domain ? Word::k_constants : Word::k_objects)) return parse_typed_names(tree_.objects);
        if (domain) {
            if (is(Word::k_types)) return parse_typed_names(tree_.types);
            if (is(Word::k_predicates)) return parse_predicates();
            if (is(Word::k_functions)) return parse_functions();
            if (is(Word::k_action)) return parse_action();
            if (is(Word::k_derived)) return parse_derived();
        } else {
            if (is(Word::k_domain)) return parse_domain_name();
            if (is(Word::k_init)) return parse_init(section);
            if (is(Word::k_goal)) return parse_goal();
            if (is(Word::k_metric)) return parse_metric();
        }
        parse_other(section);
    }

    void parse_requirements(const Name& section) {
        if (!tree_.requirements_at) tree_.requirements_at = section;
        const auto add = [this](auto& context) { tree_.requirements.push_back(x3::_attr(context)); };
        run(*keyword[add] > closing("a keyword (such as ':typing') or ')'"));
    }

    void parse_typed_names(std::vector<Range>& lists) {
        run(typed_names > closing("a name, '- TYPE' or ')'"));
        lists.push_back(builder_.list());
    }

    void parse_predicates() {
        Name predicate;
        const auto set_name = [&](auto& context) { predicate = x3::_attr(context); };
        const auto add = [&](auto&) { tree_.predicates.push_back({predicate, builder_.list(), {}}); };
        run(*(opening > name[set_name] > typed_variables > closing("a variable or ')'")[add]) >
            closing("'(' or ')'"));
    }

    void parse_functions() {
        Name function;
        std::size_t untyped = tree_.functions.size();
        const auto set_name = [&](auto& context) { function = x3::_attr(context); };
        const auto add = [&](auto&) { tree_.functions.push_back({function, builder_.list(), {}}); };
        const auto add_types = [&](auto&) {
            for (; untyped < tree_.functions.size(); ++untyped)
                tree_.functions[untyped].types = builder_.types();
        };
        const auto declaration =
            opening > name[set_name] > typed_variables > closing("a variable or ')'")[add];
        run(*(declaration | (word(Word::minus) > type)[add_types]) > closing("'(', '- TYPE' or ')'"));
    }

    void parse_action() {
        Action action;
        const auto set_name = [&](auto& context) { action.name = x3::_attr(context); };
        const auto set_parameters = [&](auto&) { action.parameters = builder_.list(); };
        const auto set_precondition = [&](auto&) { action.precondition = add_part(action.precondition); };
        const auto set_effect = [&](auto&) { action.effect = add_part(action.effect); };
        run(name[set_name] > *((word(Word::k_parameters) > opening > typed_variables >
                                closing("a variable or ')'")[set_parameters]) |
                               (word(Word::k_precondition) > list[set_precondition]) |
                               (word(Word::k_effect) > list[set_effect])) >
            closing("':parameters', ':precondition', ':effect' or ')'"));
        tree_.actions.push_back(action);
    }

    /// The node just parsed, unless there was one of its kind before.
    NodeIndex add_part(NodeIndex before) {
        const NodeIndex node = builder_.last();
        if (before == kNoNode) return node;
        reporter_.error(tree_.where(tree_.nodes[node]), "an action has one precondition and one effect",
                        "join them with 'and'");
        return before;
    }

    void parse_derived() {
        Derived derived;
        const auto set_name = [&](auto& context) { derived.head.name = x3::_attr(context); };
        const auto set_parameters = [&](auto&) { derived.head.parameters = builder_.list(); };
        const auto set_body = [&](auto&) { derived.body = builder_.last(); };
        run(opening > name[set_name] > typed_variables > closing("a variable or ')'")[set_parameters] >
            list[set_body] > closing());
        tree_.axioms.push_back(derived);
    }

    void parse_domain_name() {
        run(name[([&](auto& context) { tree_.domain = x3::_attr(context); })] > closing());
    }

    void parse_init(const Name& section) {
        tree_.init_sections.push_back(section);
        const auto add = [&](auto&) { tree_.init.push_back(builder_.last()); };
        run(*list[add] > closing("'(' or ')'"));
    }

    void parse_goal() {
        run(list[([&](auto&) { tree_.goals.push_back(builder_.last()); })] > closing());
    }

    void parse_metric() {
        Metric metric;
        const auto set_direction = [&](auto& context) { metric.direction = x3::_attr(context); };
        const auto set_expression = [&](auto&) { metric.expression = builder_.last(); };
        run((word(Word::minimize)[set_direction] | word(Word::maximize)[set_direction]) >
            operand[set_expression] > closing());
        tree_.metrics.push_back(metric);
    }

    void parse_other(const Name& section) {
        static constexpr Word kRefused[] = {
            Word::k_constraints, Word::k_durative_action, Word::k_process, Word::k_event,
            Word::k_task,        Word::k_method,          Word::k_htn,     Word::k_class};
        const bool refused = std::any_of(std::begin(kRefused), std::end(kRefused),
                                         [&](Word word) { return section.symbol == word; });
        if (refused) {
            tree_.refused.push_back(section);
        } else if (section.symbol == Word::k_length) {
            reporter_.warning(tree_.where(section), "':length' is ignored");
        } else {
            report_unknown(section);
        }
        run(*(any_word | skipped) > closing("a word, '(' or ')'"));
    }

    void report_unknown(const Name& section) {
        const bool domain = kind_ == FileKind::domain;
        static constexpr Word kDomain[] = {Word::k_requirements, Word::k_types,     Word::k_constants,
                                           Word::k_predicates,   Word::k_functions, Word::k_action,
                                           Word::k_derived};
        static constexpr Word kProblem[] = {Word::k_requirements, Word::k_domain, Word::k_objects,
                                            Word::k_init,         Word::k_goal,   Word::k_metric};
        Suggestion suggestion(symbols_.text(section.symbol));
        std::string expected;
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
        reporter_.error(tree_.where(section), "a " + own + " has no section " + quote(tree_.spelled(section)),
                        elsewhere ? std::string("it belongs into the ") + (domain ? "problem" : "domain")
                                  : suggestion.hint());
    }

    Tree tree_;
    FileKind kind_;
    Reporter& reporter_;
    SymbolTable& symbols_;
    Builder builder_;
    const char* at_ = nullptr;
    const char* last_ = nullptr;
    bool stopped_ = false;
};

}  // namespace

Tree parse(const Source& source, std::uint32_t file, FileKind kind, SymbolTable& symbols,
           Reporter& reporter) {
    return FileParser(source, file, kind, symbols, reporter).parse();
}

}  // namespace praxis::syntax
