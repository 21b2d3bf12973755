// All that is asked about one moment as one prompt, and the answer to it as readings.
//
// Ground atoms become numbered questions by a sentence per predicate; the model answers in JSON by number.
// What does not fit the schema is never guessed at: an atom without exactly one clear answer is unknown.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "belief/percept.hpp"

namespace praxis::belief {

/// How atoms of a predicate are asked for.
struct PredicateQuestion {
    std::string sentence;            ///< "Is {0} inside {1}?"; empty: "Is (inside cup1 drawer) true?"
    bool ask = true;                 ///< false: cameras cannot tell, do not ask
    std::optional<double> accuracy;  ///< of answers, if not the observer's
};

struct QuestionTexts {
    std::map<std::string, PredicateQuestion> predicates;
    std::map<std::string, std::string> objects;  ///< "cup1" -> "the red cup", so that the model finds it
    std::vector<std::string> types;              ///< of the objects to detect; empty: nothing is detected
    std::string remarks;  ///< further words to the model, such as what the place looks like
};

/// The sentence that asks for an atom. Throws PerceptionError if a sentence names an argument that the atom
/// has not or has a brace that is none of "{0}", "{1}", ...
std::string question_sentence(const QuestionTexts& texts, const AtomName& atom);

/// The text of a prompt: the views by name and in order, the objects, the numbered questions (from 1), the
/// answer's schema.
std::string question_prompt(const QuestionTexts& texts, std::span<const std::string> views,
                            std::span<const std::string> objects, std::span<const AtomName> questions);

/// A thing that the model sees in a view, before it is lifted into the world.
struct SeenObject {
    std::string object;  ///< empty: none that is known
    std::string type;
    std::size_t view = 0;
    std::optional<std::array<double, 2>> pixel;
    double confidence = 1;
};

struct QuestionAnswers {
    bool usable = false;        ///< false: `problems` says why it must be asked again
    std::vector<Truth> values;  ///< per question; unknown where unanswered or contradictory
    std::vector<SeenObject> seen;
    std::vector<std::string> problems;  ///< what was wrong and left out
};

/// Reads an answer. Unusable: no JSON object, no list of answers, or questions of which no one got a valid
/// answer.
QuestionAnswers read_question_answers(const std::string& text, std::size_t questions,
                                      std::span<const std::string> views, std::span<const std::string> types);

}  // namespace praxis::belief
