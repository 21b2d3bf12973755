#include "belief/perception/goal_translator.hpp"

#include <algorithm>
#include <stdexcept>

#include "belief/perception/json_answer.hpp"
#include "parser/parser.hpp"

namespace praxis::belief {
namespace {

/// Blanks between words only, no comments, lower case.
std::string normalised(const std::string& text) {
    std::string result;
    bool comment = false;
    bool blank = false;
    for (const char c : text) {
        if (c == ';') comment = true;
        if (c == '\n' || c == '\r') comment = false;
        if (comment) continue;
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
            blank = true;
            continue;
        }
        if (blank && !result.empty() && result.back() != '(' && c != ')') result.push_back(' ');
        blank = false;
        result.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    }
    return result;
}

/// The text must not close what it did not open: it is put into the middle of a problem.
bool is_one_expression(const std::string& text) {
    if (!text.starts_with('(')) return false;
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i + 1 == text.size();
    }
    return false;
}

/// No predicate and no equality is in it.
bool says_nothing(const Formula& formula) {
    return formula.kind != Connective::atom && formula.kind != Connective::equality &&
           std::ranges::all_of(formula.children, says_nothing);
}

std::string with_meaning(const GoalOptions& options, const std::string& name) {
    const auto found = options.meanings.find(name);
    return found == options.meanings.end() ? std::string() : ": " + found->second;
}

std::string instructions(const Vocabulary& vocabulary, const GoalOptions& options) {
    std::string text =
        "You translate what a person wants into a goal for a planner, written in PDDL. You may use only the "
        "names "
        "listed here.\nTypes:\n- object";
    for (const VocabularyType& type : vocabulary.types) {
        text += "\n- " + type.name;
        for (std::size_t i = 0; i < type.parents.size(); ++i) {
            text += (i == 0 ? " (a kind of " : ", ") + type.parents[i];
        }
        if (!type.parents.empty()) text += ')';
        text += with_meaning(options, type.name);
    }
    text += "\nPredicates:";
    for (const VocabularyPredicate& predicate : vocabulary.predicates) {
        text += "\n- (" + predicate.name;
        for (std::size_t i = 0; i < predicate.parameters.size(); ++i) {
            text += " ?x" + std::to_string(i + 1) + " - " + predicate.parameters[i];
        }
        text += ')' + with_meaning(options, predicate.name);
    }
    text += "\nObjects:";
    for (const VocabularyObject& object : vocabulary.objects) {
        text += "\n- " + object.name + " - " + object.type + with_meaning(options, object.name);
    }
    return text +
           "\nConnectives: (and ...), (or ...), (not ...), (imply a b), (forall (?v - type) ...), (exists "
           "(?v - "
           "type) ...), (= a b).\nAnswer with one JSON object and nothing else: {\"goal\": \"(and ...)\"}, "
           "or "
           "{\"impossible\": \"why\"} if these names cannot say what is wanted. Never invent a name.";
}

/// The proposal in an answer; nothing if there is none, with the reason in `problem`. Throws if the model
/// gives up.
std::string read_proposal(const std::string& text, std::string& problem) {
    const nlohmann::json answer = read_json_answer(text, problem);
    if (answer.is_discarded()) return {};
    const auto impossible = answer.find("impossible");
    if (impossible != answer.end() && impossible->is_string()) {
        throw GoalError("the model finds no goal for this: " + impossible->get<std::string>());
    }
    const auto goal = answer.find("goal");
    if (goal == answer.end() || !goal->is_string()) {
        problem = "there is no text \"goal\"";
        return {};
    }
    return goal->get<std::string>();
}

void check_vocabulary(const Vocabulary& vocabulary) {
    try {
        parse_task({"domain", vocabulary_domain(vocabulary)},
                   {"goal", vocabulary_problem(vocabulary, "(and)")});
    } catch (const InputError& error) {
        throw std::invalid_argument(std::string("the vocabulary is inconsistent:\n") + error.what());
    }
}

}  // namespace

std::string check_goal(const Vocabulary& vocabulary, std::string& goal) {
    constexpr std::size_t kLongest = 20000;
    if (goal.size() > kLongest) return "the goal is longer than " + std::to_string(kLongest) + " bytes";
    const std::string text = normalised(goal);
    if (!is_one_expression(text)) return "the goal is not one expression in balanced parentheses";
    try {
        const Task task = parse_task({"domain", vocabulary_domain(vocabulary)},
                                     {"goal", vocabulary_problem(vocabulary, text)})
                              .task;
        if (says_nothing(task->goal)) {
            return "the goal says nothing";
        }
    } catch (const InputError& error) {
        return error.what();
    }
    goal = text;
    return {};
}

TranslatedGoal translate_goal(ChatModel& model, const Vocabulary& vocabulary, const std::string& sentence,
                              const GoalOptions& options, std::stop_token stop) {
    if (options.attempts < 1) throw std::invalid_argument("a translation needs at least one attempt");
    check_vocabulary(vocabulary);
    std::vector<Message> messages = {{Role::system, instructions(vocabulary, options), {}},
                                     {Role::user, "What is wanted: " + sentence, {}}};
    for (int attempt = 1;; ++attempt) {
        const ChatAnswer answer = model.ask(messages, stop);
        std::string problem;
        std::string proposal = read_proposal(answer.text, problem);
        if (problem.empty()) problem = check_goal(vocabulary, proposal);
        if (problem.empty()) return {proposal, attempt};
        if (attempt >= options.attempts) {
            throw GoalError("no goal in " + std::to_string(attempt) +
                            (attempt == 1 ? " attempt" : " attempts") + "; the last answer: " + problem);
        }
        constexpr std::size_t kRepeated = 4000;  // bytes
        messages.push_back({Role::assistant, answer.text.substr(0, kRepeated), {}});
        messages.push_back({Role::user,
                            "That goal is wrong:\n" + problem +
                                "\nCorrect it, using only the names listed. Answer in the same JSON form.",
                            {}});
    }
}

}  // namespace praxis::belief
