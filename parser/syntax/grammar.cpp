#include "parser/syntax/grammar.hpp"

#include <algorithm>
#include <string>

#include "parser/suggest.hpp"
#include "parser/syntax/messages.hpp"
#include "parser/syntax/rules.hpp"

namespace praxis::syntax {

namespace {

// Files.

bool is_section_start(const char* at, const char* last) {
    if (at == last || *at != '(') return false;
    at = GapParser::skip(at + 1, last);
    return at != last && *at == ':';
}

bool is_define(const char* at, const char* last) {
    if (*at != '(') return false;
    at = GapParser::skip(at + 1, last);
    for (const char wanted : spelling(Word::define)) {
        if (at == last || fold(*at) != static_cast<std::uint8_t>(wanted)) return false;
        ++at;
    }
    return at == last || fold(*at) == 0;
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

    std::string swapped_hint(const std::string& expected, std::string_view found) {
        if (kind_ == FileKind::streams) return {};
        const bool domain_expected = kind_ == FileKind::domain;
        const Word own = domain_expected ? Word::domain : Word::problem;
        const Word other = domain_expected ? Word::problem : Word::domain;
        if (expected != quote(spelling(own)) || symbols_.intern(found) != other) return {};
        stopped_ = true;
        return domain_expected ? "this is a problem; the domain's file comes first"
                               : "this is a domain; the problem's file comes second";
    }

    void parse_header() {
        const Word kind = kind_ == FileKind::domain    ? Word::domain
                          : kind_ == FileKind::problem ? Word::problem
                                                       : Word::stream;
        const auto set_name = [this](auto& context) { tree_.name = x3::_attr(context); };
        run(opening > word(Word::define) > opening > word(kind) > name[set_name] > closing());
    }

    void parse_sections() {
        const char* const define = at_;
        std::size_t repeated = 0;  // headers within the first that are not closed yet
        bool closed = false;
        for (;;) {
            at_ = GapParser::skip(at_, last_);
            if (at_ == last_) {
                if (!tree_.broken && !closed) report(at_, "a section or ')'", define);
                return;
            }
            if (*at_ == ')') {
                if (repeated == 0) break;
                --repeated;
                ++at_;
                closed = true;
                continue;
            }
            if (is_define(at_, last_)) {
                reporter_.warning({tree_.file, builder_.offset_of(at_), 1}, "a second 'define'",
                                  "taken as one with the first");
                ++repeated;
                guarded([this] { parse_header(); });
                continue;
            }
            guarded([this] { parse_section(); });
        }
        at_ = GapParser::skip(at_ + 1, last_);
        if (at_ != last_ && !tree_.broken) {
            reporter_.error({tree_.file, builder_.offset_of(at_), 1},
                            "text after the end of the " + std::string(describe(kind_)),
                            "is there a ')' too many before it?");
            tree_.broken = true;
        }
    }

    void parse_section() {
        Name section;
        run(opening > keyword[([&](auto& context) { section = x3::_attr(context); })]);
        if (kind_ == FileKind::streams) return parse_stream_section(section);
        const bool domain = kind_ == FileKind::domain;
        const auto is = [&](Word wanted) { return section.symbol == wanted; };
        if (is(Word::k_requirements)) return parse_requirements(section);
        if (is(Word::k_constants) || is(Word::k_objects)) {
            if (is(domain ? Word::k_objects : Word::k_constants)) tree_.misplaced.push_back(section);
            return parse_typed_names(tree_.objects);
        }
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
        if (!parse_contingent(section)) parse_other(section);
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
        const auto begin_sensing = [&](auto& context) {
            const auto number = static_cast<std::uint32_t>(tree_.actions.size());
            tree_.contingent.actions.push_back({x3::_attr(context), number, {}});
            note(x3::_attr(context));
        };
        const auto add_sensing = [&](auto&) {
            tree_.contingent.actions.back().nodes.push_back(builder_.last());
        };
        const auto set_precondition = [&](auto&) { action.precondition = add_part(action.precondition); };
        const auto set_effect = [&](auto&) { action.effect = add_part(action.effect); };
        run(name[set_name] >
            *((word(Word::k_parameters) > opening > typed_variables >
               closing("a variable or ')'")[set_parameters]) |
              (word(Word::k_precondition) > list[set_precondition]) |
              (word(Word::k_effect) > list[set_effect]) |
              (word(Word::k_observe)[begin_sensing] > list[add_sensing] > *list[add_sensing]) |
              (word(Word::k_sensing_model)[begin_sensing] > list[add_sensing])) >
            closing("':parameters', ':precondition', ':effect' or ')'"));
        tree_.actions.push_back(action);
    }

    void note(const Name& word) { tree_.contingent.keywords.push_back(word); }

    /// Sections of partial observability; false if it is none of this file.
    bool parse_contingent(const Name& section) {
        const auto is = [&](Word wanted) { return section.symbol == wanted; };
        const bool domain = kind_ == FileKind::domain;
        if (is(Word::k_variable) || is(Word::k_obs_variable)) {
            parse_variable(section);
        } else if (domain && is(Word::k_sensor)) {
            parse_sensor();
        } else if (domain && is(Word::k_default_sensing_model)) {
            run(list[([&](auto&) { tree_.contingent.default_models.push_back(builder_.last()); })] >
                closing());
        } else if (domain && (is(Word::k_observable) || is(Word::k_sticky) || is(Word::k_open_world))) {
            parse_predicate_list(section);
        } else if (domain && is(Word::k_decay)) {
            parse_decay();
        } else if (!domain && is(Word::k_hidden)) {
            HiddenSection hidden{section, {}};
            run(*list[([&](auto&) { hidden.literals.push_back(builder_.last()); })] > closing("'(' or ')'"));
            tree_.contingent.hidden.push_back(std::move(hidden));
        } else if (!domain && is(Word::k_hidden_objects)) {
            parse_typed_names(tree_.contingent.hidden_objects);
        } else {
            return false;
        }
        note(section);
        return true;
    }

    void parse_variable(const Name& section) {
        VariableDeclaration result;
        result.keyword = section;
        const auto set_name = [&](auto& context) { result.name = x3::_attr(context); };
        const auto set_parameters = [&](auto&) { result.parameters = builder_.list(); };
        const auto begin_objects = [&](auto&) { builder_.begin_types(); };
        const auto set_objects = [&](auto&) { result.objects = builder_.types(); };
        const auto add_value = [&](auto&) { result.values.push_back(builder_.last()); };
        const auto values = *list[add_value] > closing("'(' or ')'");
        if (kind_ == FileKind::domain) {
            run((name[set_name] | (opening > name[set_name] > typed_variables >
                                   closing("a variable or ')'")[set_parameters])) > values);
        } else {
            run((name[set_name] | (opening > name[set_name] > x3::eps[begin_objects] > *name[add_type] >
                                   closing("an object or ')'")[set_objects])) > values);
        }
        tree_.contingent.variables.push_back(std::move(result));
    }

    void parse_sensor() {
        SensorDeclaration sensor;
        const auto set_name = [&](auto& context) { sensor.name = x3::_attr(context); };
        const auto set_parameters = [&](auto&) { sensor.parameters = builder_.list(); };
        const auto set_condition = [&](auto&) {
            const NodeIndex node = builder_.last();
            if (sensor.condition != kNoNode) {
                reporter_.error(tree_.where(tree_.nodes[node]), "a sensor has one condition",
                                "join them with 'and'");
            }
            sensor.condition = node;
        };
        const auto add_sensed = [&](auto&) { sensor.sensed.push_back(builder_.last()); };
        run(name[set_name] > *((word(Word::k_parameters) > opening > typed_variables >
                                closing("a variable or ')'")[set_parameters]) |
                               (word(Word::k_condition) > list[set_condition]) |
                               (word(Word::k_sense) > list[add_sensed] > *list[add_sensed])) >
            closing("':parameters', ':condition', ':sense' or ')'"));
        tree_.contingent.sensors.push_back(std::move(sensor));
    }

    void parse_predicate_list(const Name& section) {
        PredicateList result{section, {}, {}};
        const auto add_name = [&](auto& context) { result.words.push_back(x3::_attr(context)); };
        const auto add_node = [&](auto&) { result.nodes.push_back(builder_.last()); };
        run(*(name[add_name] | list[add_node]) > closing("a predicate or ')'"));
        tree_.contingent.predicates.push_back(std::move(result));
    }

    void parse_decay() {
        DecayDeclaration decay;
        const auto set_predicate = [&](auto& context) { decay.predicate = x3::_attr(context); };
        const auto add_decay = [&](auto& context) {
            decay.steps = x3::_attr(context);
            tree_.contingent.decays.push_back(decay);
        };
        const auto pair = name[set_predicate] > name[add_decay];
        run(pair > *pair > closing("a predicate or ')'"));
    }

    void parse_stream_section(const Name& section) {
        if (section.symbol == Word::k_stream) return parse_stream(section);
        const bool test = section.symbol == Word::k_predicate;
        if (test || section.symbol == Word::k_function) return parse_external(section, test);
        report_unknown_section(reporter_, tree_, kind_, symbols_, section);
        run(*(any_word | skipped) > closing("a word, '(' or ')'"));
    }

    void parse_stream(const Name& section) {
        StreamDeclaration stream;
        stream.keyword = section;
        const auto set_name = [&](auto& context) { stream.name = x3::_attr(context); };
        const auto set_inputs = [&](auto&) { stream.inputs = builder_.list(); };
        const auto set_outputs = [&](auto&) { stream.outputs = builder_.list(); };
        const auto add_domain = [&](auto&) { stream.domain.push_back(builder_.last()); };
        const auto add_certified = [&](auto&) { stream.certified.push_back(builder_.last()); };
        const auto add_fluent = [&](auto& context) { stream.fluents.push_back(x3::_attr(context)); };
        const auto variables = opening > typed_variables;
        const auto end_of_variables = closing("a variable or ')'");
        run(name[set_name] >
            *((word(Word::k_inputs) > variables > end_of_variables[set_inputs]) |
              (word(Word::k_outputs) > variables > end_of_variables[set_outputs]) |
              (word(Word::k_domain) > list[add_domain]) | (word(Word::k_certified) > list[add_certified]) |
              (word(Word::k_fluents) > opening > *name[add_fluent] > closing("a predicate or ')'"))) >
            closing("':inputs', ':domain', ':outputs', ':certified', ':fluents' or ')'"));
        tree_.streams.streams.push_back(std::move(stream));
    }

    /// `(:function (NAME PARAMETER...) DOMAIN)`, also with `:predicate`.
    void parse_external(const Name& section, bool test) {
        StreamDeclaration external;
        external.keyword = section;
        const auto set_name = [&](auto& context) { external.name = x3::_attr(context); };
        const auto set_inputs = [&](auto&) { external.inputs = builder_.list(); };
        const auto add_domain = [&](auto&) { external.domain.push_back(builder_.last()); };
        run(opening > name[set_name] > typed_variables > closing("a variable or ')'")[set_inputs] >
            -list[add_domain] > closing());
        (test ? tree_.streams.predicates : tree_.streams.functions).push_back(std::move(external));
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
            report_unknown_section(reporter_, tree_, kind_, symbols_, section);
        }
        run(*(any_word | skipped) > closing("a word, '(' or ')'"));
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
