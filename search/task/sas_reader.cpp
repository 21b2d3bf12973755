#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/diagnostic.hpp"
#include "search/task/sas.hpp"

namespace praxis {

namespace {

constexpr std::int64_t kMaxInt = std::numeric_limits<std::int32_t>::max();

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// Tokens and lines of the text, and errors at them.
class Lexer {
  public:
    explicit Lexer(const Source& source) : source_(source), text_(source.text) {}

    std::size_t position() const { return position_; }
    std::size_t left() const { return text_.size() - position_; }

    [[noreturn]] void fail(const std::string& message, std::size_t begin, std::size_t end) const {
        Diagnostic diagnostic;
        diagnostic.where = {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
        diagnostic.message = message;
        throw InputError(to_string(diagnostic, Sources{{source_}}), {diagnostic});
    }
    /// Fails at the token or line last read.
    [[noreturn]] void fail(const std::string& message) const { fail(message, token_begin_, token_end_); }

    /// A whole number from `low` to `high`.
    std::int64_t number(std::string_view what, std::int64_t low, std::int64_t high) {
        while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
        token_begin_ = position_;
        while (position_ < text_.size() && !is_blank(text_[position_])) ++position_;
        token_end_ = position_;
        if (token_begin_ == token_end_) fail("unexpected end of file, expected " + std::string(what));
        std::int64_t value = 0;
        const char* const begin = text_.data() + token_begin_;
        const char* const end = text_.data() + token_end_;
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (stop != end || (error != std::errc() && error != std::errc::result_out_of_range)) {
            fail("expected a number: " + std::string(what));
        }
        if (error != std::errc() || value < low || value > high) {
            fail(std::string(what) + " must be from " + std::to_string(low) + " to " + std::to_string(high));
        }
        return value;
    }

    /// How many things follow, each of which takes at least `bytes` bytes of text.
    std::size_t count(std::string_view what, std::size_t bytes, std::int64_t low = 0) {
        const std::size_t value = static_cast<std::size_t>(number(what, low, kMaxInt));
        if (value > left() / bytes + 1) {
            fail(std::string(what) + " is " + std::to_string(value) +
                 ", more than the rest of the file can hold");
        }
        return value;
    }

    /// The next line that is not blank, without blanks around it. What is left of the current line must be
    /// blank.
    std::string_view line(std::string_view what) {
        if (position_ > 0 && text_[position_ - 1] != '\n') {
            if (!take_line().empty()) fail("unexpected text at the end of the line");
        }
        while (position_ < text_.size()) {
            const std::string_view found = take_line();
            if (!found.empty()) return found;
        }
        token_begin_ = token_end_ = text_.size();
        fail("unexpected end of file, expected " + std::string(what));
    }

    void keyword(std::string_view expected) {
        if (line(expected) != expected) fail("expected '" + std::string(expected) + "'");
    }

    void end_of_file() {
        while (position_ < text_.size()) {
            if (!take_line().empty()) fail("unexpected text after the last axiom");
        }
    }

  private:
    std::string_view take_line() {
        const char* const begin = text_.data() + position_;
        const void* const newline = std::memchr(begin, '\n', left());
        const std::size_t end =
            newline == nullptr ? text_.size()
                               : static_cast<std::size_t>(static_cast<const char*>(newline) - text_.data());
        token_begin_ = position_;
        token_end_ = end;
        while (token_begin_ < token_end_ && is_blank(text_[token_begin_])) ++token_begin_;
        while (token_begin_ < token_end_ && is_blank(text_[token_end_ - 1])) --token_end_;
        position_ = std::min(end + 1, text_.size());
        return text_.substr(token_begin_, token_end_ - token_begin_);
    }

    const Source& source_;
    std::string_view text_;
    std::size_t position_ = 0;
    std::size_t token_begin_ = 0;
    std::size_t token_end_ = 0;
};

/// Builds a NameTable; words are looked up by views into the source.
class NameTableBuilder {
  public:
    explicit NameTableBuilder(NameTable& table) : table_(table) {}

    void word(std::string_view text) {
        const auto [place, is_new] =
            index_.try_emplace(text, static_cast<std::uint32_t>(table_.symbols.size()));
        if (is_new) table_.symbols.emplace_back(text);
        table_.names.add(place->second);
    }
    void close() { table_.names.close(); }

  private:
    NameTable& table_;
    std::unordered_map<std::string_view, std::uint32_t> index_;
};

class Reader {
  public:
    explicit Reader(const Source& source)
        : lexer_(source), facts_(task_.fact_names), names_(task_.operator_names) {}

    FiniteDomainTask read() {
        read_header();
        read_variables();
        read_mutex_groups();
        read_initial_state();
        lexer_.keyword("begin_goal");
        read_conditions("the number of goals", task_.goal);
        lexer_.keyword("end_goal");
        read_operators();
        read_axioms();
        lexer_.end_of_file();
        return std::move(task_);
    }

  private:
    void read_header() {
        lexer_.keyword("begin_version");
        lexer_.number("the version of the format", 3, 3);
        lexer_.keyword("end_version");
        lexer_.keyword("begin_metric");
        task_.unit_cost = lexer_.number("the metric", 0, 1) == 0;
        lexer_.keyword("end_metric");
    }

    void read_variables() {
        const std::size_t count = lexer_.count("the number of variables", 30);
        task_.first_fact.push_back(0);
        for (std::size_t i = 0; i < count; ++i) {
            lexer_.keyword("begin_variable");
            lexer_.line("the name of a variable");
            const auto layer = static_cast<std::int32_t>(lexer_.number("the axiom layer", -1, kMaxInt));
            const std::size_t size = lexer_.count("the domain size", 2, 1);
            if (layer >= 0 && size != 2) lexer_.fail("a derived variable must have domain size 2");
            for (std::size_t value = 0; value < size; ++value) read_fact_name();
            lexer_.keyword("end_variable");
            task_.axiom_layers.push_back(layer);
            task_.domain_sizes.push_back(static_cast<std::int32_t>(size));
            task_.first_fact.push_back(task_.first_fact.back() + static_cast<std::uint32_t>(size));
        }
    }

    /// "Atom p(a, b)", "NegatedAtom p(a, b)", "<none of those>"; any other text is the name of an atom
    /// without arguments.
    void read_fact_name() {
        using Form = FiniteDomainTask::FactForm;
        std::string_view text = lexer_.line("the name of a fact");
        const auto take = [&text](std::string_view prefix) {
            const bool found = text.starts_with(prefix);
            if (found) text.remove_prefix(prefix.size());
            return found;
        };
        if (text == "<none of those>") {
            task_.fact_forms.push_back(Form::none_of_those);
            facts_.close();
            return;
        }
        task_.fact_forms.push_back(take("NegatedAtom ") ? Form::negated_atom : Form::atom);
        if (task_.fact_forms.back() == Form::atom) take("Atom ");
        const std::size_t open = text.find('(');
        facts_.word(text.substr(0, open));
        if (open != std::string_view::npos && text.back() == ')' && open + 2 < text.size()) {
            text = text.substr(open + 1, text.size() - open - 2);
            for (std::size_t comma; (comma = text.find(", ")) != std::string_view::npos;) {
                facts_.word(text.substr(0, comma));
                text.remove_prefix(comma + 2);
            }
            facts_.word(text);
        }
        facts_.close();
    }

    void read_mutex_groups() {
        const std::size_t count = lexer_.count("the number of mutex groups", 30);
        std::vector<Fact> group;
        for (std::size_t i = 0; i < count; ++i) {
            lexer_.keyword("begin_mutex_group");
            group.clear();
            for (std::size_t left = lexer_.count("the number of facts in the group", 4); left > 0; --left) {
                group.push_back(read_fact());
            }
            lexer_.keyword("end_mutex_group");
            task_.mutex_groups.append(group);
        }
    }

    void read_initial_state() {
        lexer_.keyword("begin_state");
        for (std::size_t variable = 0; variable < task_.variable_count(); ++variable) {
            const std::int64_t last = task_.domain_sizes[variable] - 1;
            task_.initial_values.push_back(
                static_cast<std::int32_t>(lexer_.number("the initial value", 0, last)));
        }
        lexer_.keyword("end_state");
    }

    void read_operators() {
        const std::size_t count = lexer_.count("the number of operators", 30);
        task_.conditions.close();
        std::vector<Fact> preconditions;
        std::vector<Fact> conditions;
        std::vector<GroundEffect> effects;
        for (std::size_t i = 0; i < count; ++i) {
            lexer_.keyword("begin_operator");
            read_operator_name();
            preconditions.clear();
            effects.clear();
            for (std::size_t left = lexer_.count("the number of prevail conditions", 4); left > 0; --left) {
                preconditions.push_back(read_fact());
            }
            const std::size_t effect_count = lexer_.count("the number of effects", 8, 1);
            for (std::size_t effect = 0; effect < effect_count; ++effect) {
                read_conditions("the number of effect conditions", conditions);
                const std::int32_t variable = read_variable();
                if (task_.derived(variable)) lexer_.fail("an operator cannot set a derived variable");
                const std::int32_t before = read_value(variable, -1);
                const std::int32_t after = read_value(variable, 0);
                if (before >= 0) preconditions.push_back({variable, before});
                effects.push_back({{variable, after}, condition_number(conditions)});
            }
            canonicalize(preconditions);
            const std::int64_t cost = lexer_.number("the cost", 0, kMaxInt - 1);
            lexer_.keyword("end_operator");
            task_.costs.push_back(task_.unit_cost ? 1 : static_cast<std::int32_t>(cost));
            task_.preconditions.append(preconditions);
            task_.effects.append(effects);
        }
    }

    void read_operator_name() {
        std::string_view text = lexer_.line("the name of an operator");
        while (!text.empty()) {
            const auto end = std::ranges::find_if(text, is_blank);
            const auto length = static_cast<std::size_t>(end - text.begin());
            if (length > 0) names_.word(text.substr(0, length));
            text.remove_prefix(std::min(length + 1, text.size()));
        }
        names_.close();
    }

    void read_axioms() {
        const std::size_t count = lexer_.count("the number of axioms", 20);
        std::vector<Fact> body;
        for (std::size_t i = 0; i < count; ++i) {
            lexer_.keyword("begin_rule");
            read_conditions("the number of conditions", body);
            const std::int32_t variable = read_variable();
            if (!task_.derived(variable)) lexer_.fail("an axiom must set a derived variable");
            const std::int32_t fallback = task_.initial_values[static_cast<std::size_t>(variable)];
            if (read_value(variable, 0) != fallback) lexer_.fail("an axiom must change the default value");
            const std::int32_t value = read_value(variable, 0);
            if (value == fallback) lexer_.fail("an axiom must set another than the default value");
            check_layers(variable, body);
            lexer_.keyword("end_rule");
            task_.axioms.push_back({{variable, value}});
            task_.axiom_bodies.append(body);
        }
    }

    void check_layers(std::int32_t head, const std::vector<Fact>& body) const {
        const std::int32_t head_layer = task_.axiom_layers[static_cast<std::size_t>(head)];
        for (const Fact fact : body) {
            const auto variable = static_cast<std::size_t>(fact.variable);
            const std::int32_t layer = task_.axiom_layers[variable];
            if (layer > head_layer || (layer == head_layer && fact.value == task_.initial_values[variable])) {
                lexer_.fail("the axiom's condition on variable " + std::to_string(variable) +
                            " breaks the order of the axiom layers");
            }
        }
    }

    std::int32_t read_variable() {
        const auto count = static_cast<std::int64_t>(task_.variable_count());
        return static_cast<std::int32_t>(lexer_.number("the variable", 0, count - 1));
    }

    std::int32_t read_value(std::int32_t variable, std::int64_t low) {
        const std::int64_t last = task_.domain_sizes[static_cast<std::size_t>(variable)] - 1;
        return static_cast<std::int32_t>(lexer_.number("the value", low, last));
    }

    Fact read_fact() {
        const std::int32_t variable = read_variable();
        return {variable, read_value(variable, 0)};
    }

    void read_conditions(std::string_view what, std::vector<Fact>& facts) {
        facts.clear();
        for (std::size_t left = lexer_.count(what, 4); left > 0; --left) facts.push_back(read_fact());
        canonicalize(facts);
    }

    void canonicalize(std::vector<Fact>& facts) const {
        std::sort(facts.begin(), facts.end());
        facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
        for (std::size_t i = 1; i < facts.size(); ++i) {
            if (facts[i].variable == facts[i - 1].variable) {
                lexer_.fail("the conditions before this ask for two values of variable " +
                            std::to_string(facts[i].variable));
            }
        }
    }

    /// The number of an effect condition; equal ones share one.
    std::uint32_t condition_number(const std::vector<Fact>& facts) {
        if (facts.empty()) return 0;
        std::size_t hash = facts.size();
        for (const Fact fact : facts) {
            hash = (hash ^ task_.fact_number(fact)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        const auto [first, last] = known_conditions_.equal_range(hash);
        for (auto place = first; place != last; ++place) {
            if (std::ranges::equal(task_.conditions[place->second], facts)) return place->second;
        }
        const auto number = static_cast<std::uint32_t>(task_.conditions.size());
        known_conditions_.emplace(hash, number);
        task_.conditions.append(facts);
        return number;
    }

    FiniteDomainTask task_;
    Lexer lexer_;
    NameTableBuilder facts_;
    NameTableBuilder names_;
    std::unordered_multimap<std::size_t, std::uint32_t> known_conditions_;
};

}  // namespace

FiniteDomainTask read_sas(const Source& source) {
    if (source.text.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw InputError(source.name + ": error: the file is larger than 4 GiB\n");
    }
    return Reader(source).read();
}

}  // namespace praxis
