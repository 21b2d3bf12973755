#include "search/plan.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "parser/suggest.hpp"

namespace praxis {

namespace {

constexpr std::size_t kMostErrors = 20;

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](char c) { return lower(c); });
    return result;
}

/// For messages: printable and of bounded length.
std::string shown(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string result(text.substr(0, kLongest));
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return text.size() > kLongest ? result + "..." : result;
}

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

class Reader {
  public:
    Reader(const Source& source, const LiftedTask& task) : source_(source), text_(source.text), task_(task) {
        for (std::size_t i = 0; i < task.schemas.size(); ++i)
            schemas_.emplace(lower(task.schemas[i].name), i);
        for (std::size_t i = 0; i < task.objects.size(); ++i)
            objects_.emplace(lower(task.objects[i].name), i);
    }

    ParsedPlan read() {
        while (errors_.size() < kMostErrors && skip_blank()) {
            if (text_[position_] != '(' && !read_label()) continue;
            if (at_end() || text_[position_] != '(') continue;
            read_step();
        }
        if (!errors_.empty()) fail();
        return std::move(result_);
    }

  private:
    bool at_end() const { return position_ >= text_.size(); }

    /// Moves to the next character that is neither blank nor in a comment; false at the end.
    bool skip_blank() {
        while (!at_end()) {
            if (text_[position_] == ';') {
                const std::size_t end = std::min(text_.find('\n', position_), text_.size());
                read_comment(text_.substr(position_, end - position_));
                position_ = end;
            } else if (is_space(text_[position_])) {
                ++position_;
            } else {
                return true;
            }
        }
        return false;
    }

    /// "; cost = 12 (unit cost)" or "; Cost: 12.5" claim a cost; any other comment is free.
    void read_comment(std::string_view comment) {
        std::size_t i = 0;
        const auto blanks = [&] {
            while (i < comment.size() && (is_space(comment[i]) || comment[i] == ';')) ++i;
        };
        blanks();
        if (lower(comment.substr(i, 4)) != "cost") return;
        i += 4;
        blanks();
        if (i >= comment.size() || (comment[i] != '=' && comment[i] != ':')) return;
        ++i;
        blanks();
        std::size_t end = i;
        while (end < comment.size() && !is_space(comment[end]) && comment[end] != '(') ++end;
        if (const std::optional<Rational> cost = claimed(comment.substr(i, end - i))) {
            result_.plan.cost = *cost;
            result_.cost_claimed = true;
        }
    }

    /// A decimal number or a fraction "7/3".
    static std::optional<Rational> claimed(std::string_view text) {
        const std::size_t slash = text.find('/');
        if (slash == std::string_view::npos) return Rational::parse(text);
        const auto numerator = Rational::parse(text.substr(0, slash));
        const auto denominator = Rational::parse(text.substr(slash + 1));
        if (!numerator || !denominator || *denominator == Rational(0)) return std::nullopt;
        try {
            return *numerator / *denominator;
        } catch (const std::overflow_error&) {
            return std::nullopt;
        }
    }

    /// What may stand outside of steps: "12:", "0.003:" before one and "[1.000]" behind it.
    bool read_label() {
        const std::size_t begin = position_;
        if (text_[begin] == '[' && !result_.plan.steps.empty()) {
            const std::size_t end = text_.find_first_of("]\n", begin);
            if (end != std::string_view::npos && text_[end] == ']' &&
                Rational::parse(trim(text_.substr(begin + 1, end - begin - 1)))) {
                position_ = end + 1;
                return true;
            }
        }
        while (!at_end() && !is_space(text_[position_]) && !is_one_of(text_[position_], ":();")) ++position_;
        const std::string_view word = text_.substr(begin, position_ - begin);
        const auto number = Rational::parse(word);
        while (!at_end() && (text_[position_] == ' ' || text_[position_] == '\t')) ++position_;
        if (!at_end() && text_[position_] == ':' && number) {
            if (time_ && *number < *time_)
                error(begin, word.size(), "the steps are not in the order of their numbers");
            time_ = number;
            ++position_;
            return skip_blank();
        }
        error(begin, std::max<std::size_t>(word.size(), 1), "expected a step such as (move a b)");
        position_ = std::max(begin + 1, std::min(text_.find('\n', begin), text_.size()));
        return false;
    }

    static std::string_view trim(std::string_view text) {
        while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
        while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
        return text;
    }

    static bool is_one_of(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

    void read_step() {
        const std::size_t begin = position_++;
        std::vector<std::string_view> words;
        while (skip_blank() && !is_one_of(text_[position_], "()")) {
            const std::size_t start = position_;
            while (!at_end() && !is_space(text_[position_]) && !is_one_of(text_[position_], "();"))
                ++position_;
            words.push_back(text_.substr(start, position_ - start));
        }
        if (at_end()) return error(begin, 1, "this step is not closed with ')'");
        if (text_[position_] == '(') {
            return error(begin, 1, "this step is not closed before the next '('");
        }
        ++position_;
        if (words.empty()) return error(begin, position_ - begin, "a step needs the name of an action");
        resolve(begin, words);
    }

    void resolve(std::size_t begin, const std::vector<std::string_view>& words) {
        const auto found = schemas_.find(lower(words[0]));
        if (found == schemas_.end()) {
            return error(words[0], "unknown action '" + shown(words[0]) + "'", hint(words[0], task_.schemas));
        }
        const Schema& schema = task_.schemas[found->second];
        const std::size_t wanted = schema.scope.parameter_count;
        if (words.size() - 1 != wanted) {
            return error(begin, position_ - begin,
                         "action '" + schema.name + "' takes " + std::to_string(wanted) +
                             (wanted == 1 ? " argument" : " arguments") + ", not " +
                             std::to_string(words.size() - 1));
        }
        PlanStep step;
        step.schema = SchemaId(found->second);
        step.where = location(begin, position_ - begin);
        for (std::size_t i = 0; i < wanted; ++i) {
            const std::string_view word = words[i + 1];
            const auto object = objects_.find(lower(word));
            if (object == objects_.end()) {
                error(word, "unknown object '" + shown(word) + "'", hint(word, task_.objects));
                continue;
            }
            const Type& type = task_.types[schema.scope.variable_types[i].index()];
            if (!type.contains[object->second]) {
                const Object& given = task_.objects[object->second];
                error(word, "object '" + given.name + "' is of type '" +
                                task_.types[given.type.index()].name + "', but parameter " +
                                schema.scope.variable_names[i] + " of '" + schema.name + "' is of type '" +
                                type.name + "'");
            }
            step.arguments.emplace_back(object->second);
        }
        result_.plan.steps.push_back(std::move(step));
    }

    template <class Named>
    static std::string hint(std::string_view word, const std::vector<Named>& all) {
        Suggestion suggestion(lower(word));
        for (const Named& named : all) suggestion.consider(named.name);
        return suggestion.hint();
    }

    Location location(std::size_t offset, std::size_t length) const {
        return {0, static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(length)};
    }

    void error(std::string_view word, std::string message, std::string hint = "") {
        error(static_cast<std::size_t>(word.data() - text_.data()), word.size(), std::move(message),
              std::move(hint));
    }

    void error(std::size_t offset, std::size_t length, std::string message, std::string hint = "") {
        Diagnostic diagnostic;
        diagnostic.where = location(offset, length);
        diagnostic.message = std::move(message);
        diagnostic.hint = std::move(hint);
        errors_.push_back(std::move(diagnostic));
    }

    [[noreturn]] void fail() const {
        const Sources sources{{source_}};
        std::string text;
        for (const Diagnostic& diagnostic : errors_) text += to_string(diagnostic, sources);
        throw InputError(std::move(text), errors_);
    }

    const Source& source_;
    std::string_view text_;
    const LiftedTask& task_;
    std::unordered_map<std::string, std::size_t> schemas_;
    std::unordered_map<std::string, std::size_t> objects_;
    std::size_t position_ = 0;
    std::optional<Rational> time_;
    std::vector<Diagnostic> errors_;
    ParsedPlan result_;
};

}  // namespace

std::string to_string(const Plan& plan, const LiftedTask& task) {
    std::string text;
    for (const PlanStep& step : plan.steps) {
        text += "(" + task.schemas[step.schema.index()].name;
        for (const ObjectId object : step.arguments) (text += ' ') += task.objects[object.index()].name;
        text += ")\n";
    }
    const std::string cost = plan.cost.to_string();
    text += "; cost = " + cost + (task.minimize_cost ? " (general cost)\n" : " (unit cost)\n");
    return text + "; Cost: " + cost + "\n";
}

ParsedPlan parse_plan(const Source& source, const LiftedTask& task) {
    return Reader(source, task).read();
}

}  // namespace praxis
