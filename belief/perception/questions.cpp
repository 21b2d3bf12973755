#include "belief/perception/questions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "belief/perception/errors.hpp"
#include "belief/perception/json_answer.hpp"

namespace praxis::belief {
namespace {

using Json = nlohmann::json;

std::string in_parentheses(const AtomName& atom) {
    std::string text = "(";
    for (const std::string& word : atom.words) text += (text.size() > 1 ? " " : "") + word;
    return text + ')';
}

std::string described(const QuestionTexts& texts, const std::string& object) {
    const auto found = texts.objects.find(object);
    return found == texts.objects.end() ? object : object + " (" + found->second + ')';
}

std::string listed(std::span<const std::string> words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

const Json* member(const Json& object, const char* name) {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

/// "true", "false" and "unknown", also as JSON's own true and false.
std::optional<Truth> read_truth(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? Truth::known_true : Truth::known_false;
    if (!value.is_string()) return std::nullopt;
    const std::string& word = value.get_ref<const std::string&>();
    if (word == "true") return Truth::known_true;
    if (word == "false") return Truth::known_false;
    if (word == "unknown") return Truth::unknown;
    return std::nullopt;
}

void read_answers(const Json& list, std::size_t questions, QuestionAnswers& result) {
    std::vector<std::optional<Truth>> first(questions);
    std::vector<bool> contradictory(questions, false);
    std::size_t valid = 0;
    for (const Json& entry : list) {
        const Json* number = entry.is_object() ? member(entry, "question") : nullptr;
        const Json* answer = entry.is_object() ? member(entry, "answer") : nullptr;
        if (number == nullptr || answer == nullptr || !number->is_number_integer()) {
            result.problems.push_back("an answer is not of the form {\"question\": 1, \"answer\": \"true\"}");
            continue;
        }
        // A number above the range of a signed one is negative here, and refused as well.
        const auto question = number->get<std::int64_t>();
        if (question < 1 || static_cast<std::uint64_t>(question) > questions) {
            result.problems.push_back("there is no question " + number->dump());
            continue;
        }
        const auto index = static_cast<std::size_t>(question - 1);
        const auto value = read_truth(*answer);
        if (!value) {
            result.problems.push_back("the answer to question " + number->dump() +
                                      " is not \"true\", \"false\" or \"unknown\"");
            contradictory[index] = true;
            continue;
        }
        ++valid;
        if (first[index] && *first[index] != *value) {
            result.problems.push_back("question " + number->dump() + " has contradicting answers");
            contradictory[index] = true;
        }
        first[index] = value;
    }
    for (std::size_t i = 0; i < questions; ++i) {
        if (!first[i] && !contradictory[i]) {
            result.problems.push_back("question " + std::to_string(i + 1) + " has no answer");
        }
        if (first[i] && !contradictory[i]) result.values[i] = *first[i];
    }
    result.usable = valid > 0 || questions == 0;
    if (!result.usable) {
        result.problems.insert(result.problems.begin(), "no question has a valid answer");
    }
}

std::optional<double> read_number(const Json& value) {
    if (!value.is_number()) return std::nullopt;
    const double number = value.get<double>();
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Nothing if the entry cannot be used, with the reason in `why`.
std::optional<SeenObject> read_seen(const Json& entry, std::span<const std::string> views,
                                    std::span<const std::string> types, std::string& why) {
    const Json* type = entry.is_object() ? member(entry, "type") : nullptr;
    if (type == nullptr || !type->is_string()) {
        why = "it has no type";
        return std::nullopt;
    }
    SeenObject seen;
    seen.type = type->get<std::string>();
    if (std::ranges::find(types, seen.type) == types.end()) {
        why = "its type is none of those asked for";
        return std::nullopt;
    }
    if (const Json* object = member(entry, "object"); object != nullptr && object->is_string()) {
        seen.object = object->get<std::string>();
    }
    const Json* view = member(entry, "view");
    const auto found = view != nullptr && view->is_string()
                           ? std::ranges::find(views, view->get_ref<const std::string&>())
                           : (view == nullptr && views.size() == 1 ? views.begin() : views.end());
    if (found == views.end()) {
        why = "its view is none of those given";
        return std::nullopt;
    }
    seen.view = static_cast<std::size_t>(found - views.begin());
    if (const Json* pixel = member(entry, "pixel");
        pixel != nullptr && pixel->is_array() && pixel->size() == 2) {
        const auto u = read_number((*pixel)[0]);
        const auto v = read_number((*pixel)[1]);
        if (u && v) seen.pixel = {*u, *v};
    }
    if (const Json* confidence = member(entry, "confidence"); confidence != nullptr) {
        const auto number = read_number(*confidence);
        if (!number || *number < 0 || *number > 1) {
            why = "its confidence is not a number from 0 to 1";
            return std::nullopt;
        }
        seen.confidence = *number;
    }
    return seen;
}

}  // namespace

std::string question_sentence(const QuestionTexts& texts, const AtomName& atom) {
    const auto found = texts.predicates.find(atom.words.empty() ? std::string() : atom.words.front());
    if (found == texts.predicates.end() || found->second.sentence.empty()) {
        return "Is " + in_parentheses(atom) + " true?";
    }
    const std::string& sentence = found->second.sentence;
    std::string text;
    for (std::size_t i = 0; i < sentence.size();) {
        if (sentence[i] != '{') {
            text += sentence[i++];
            continue;
        }
        const std::size_t close = std::min(sentence.find('}', i), sentence.size() - 1);
        std::size_t argument = 0;
        const auto [end, error] = std::from_chars(sentence.data() + i + 1, sentence.data() + close, argument);
        if (error != std::errc() || end != sentence.data() + close || sentence[close] != '}' ||
            argument >= atom.words.size() - 1) {
            throw PerceptionError("the sentence '" + sentence + "' does not fit " + in_parentheses(atom) +
                                  ": write {0} for its first argument, {1} for its second, and so on");
        }
        text += atom.words[argument + 1];
        i = close + 1;
    }
    return text;
}

std::string question_prompt(const QuestionTexts& texts, std::span<const std::string> views,
                            std::span<const std::string> objects, std::span<const AtomName> questions) {
    std::string text =
        "The images show the workplace of a robot at one moment. Views, in this order: " + listed(views) +
        ".\n";
    if (!texts.remarks.empty()) text += texts.remarks + '\n';
    if (!objects.empty()) {
        text += "Known objects:";
        for (const std::string& object : objects) text += "\n- " + described(texts, object);
        text += '\n';
    }
    text += "Questions:\n";
    for (std::size_t i = 0; i < questions.size(); ++i) {
        text += std::to_string(i + 1) + ". " + question_sentence(texts, questions[i]) + '\n';
    }
    text +=
        "Answer each question by its number with \"true\" or \"false\" if the images show it, and with "
        "\"unknown\" "
        "if they do not (hidden, out of view, not clear). Never guess.\n";
    if (!texts.types.empty()) {
        text +=
            "List also every object of these types that you see: " + listed(texts.types) +
            ". \"object\" is the name of a known object, or null if it is none of them; \"view\" is the name "
            "of "
            "the view; \"pixel\" is the [column, row] of the object's centre in that view, counted from its "
            "upper left corner.\n";
    }
    text +=
        "Answer with one JSON object of this form and nothing else:\n{\"answers\": [{\"question\": 1, "
        "\"answer\": "
        "\"true\"}]";
    if (!texts.types.empty()) {
        text += ", \"detections\": [{\"object\": null, \"type\": \"" + texts.types.front() +
                "\", \"view\": \"" + (views.empty() ? std::string() : views.front()) +
                "\", \"pixel\": [0, 0]}]";
    }
    return text + "}\n";
}

QuestionAnswers read_question_answers(const std::string& text, std::size_t questions,
                                      std::span<const std::string> views,
                                      std::span<const std::string> types) {
    QuestionAnswers result;
    result.values.assign(questions, Truth::unknown);
    std::string why;
    const Json answer = read_json_answer(text, why);
    if (answer.is_discarded()) {
        result.problems.push_back(why);
        return result;
    }
    const Json* answers = member(answer, "answers");
    if (answers != nullptr ? !answers->is_array() : questions > 0) {
        result.problems.push_back("there is no list \"answers\"");
        return result;
    }
    read_answers(answers == nullptr ? Json::array() : *answers, questions, result);
    const Json* detections = member(answer, "detections");
    if (detections == nullptr || types.empty()) return result;
    if (!detections->is_array()) {
        result.problems.push_back("\"detections\" is not a list");
        return result;
    }
    for (const Json& entry : *detections) {
        if (auto seen = read_seen(entry, views, types, why)) {
            result.seen.push_back(std::move(*seen));
        } else {
            result.problems.push_back("a detection is left out: " + why);
        }
    }
    return result;
}

}  // namespace praxis::belief
