// From words to a goal: "every cup should be in the drawer" as a checked PDDL formula.
//
// The model proposes, the parser decides: a proposal with an unknown name, a wrong number of arguments or
// wrong types goes back to the model with the parser's message, place and mend included. What is returned has
// been parsed over the given types, predicates and objects, and uses no other names.
#pragma once

#include <map>
#include <stop_token>
#include <string>

#include "belief/perception/chat.hpp"
#include "belief/perception/vocabulary.hpp"

namespace praxis::belief {

struct GoalOptions {
    int attempts = 4;                             ///< proposals, all told
    std::map<std::string, std::string> meanings;  ///< of predicates and objects, where names do not tell
};

struct TranslatedGoal {
    std::string pddl;  ///< one formula on one line, lower case
    int attempts = 1;  ///< proposals that it took
};

/// There is no goal: the model says that the vocabulary cannot express the sentence, or no proposal was
/// right. what() has the model's reason, or the last proposal's errors.
class GoalError : public PerceptionError {
  public:
    using PerceptionError::PerceptionError;
};

/// Throws GoalError; PerceptionError if the model is out of order; StoppedError if `stop` asks;
/// std::invalid_argument if the vocabulary itself is inconsistent.
TranslatedGoal translate_goal(ChatModel& model, const Vocabulary& vocabulary, const std::string& sentence,
                              const GoalOptions& options = {}, std::stop_token stop = {});

/// What is wrong with a goal; empty if nothing is. Exactly one formula, neither trivial nor with other names
/// than the vocabulary's. On success, `goal` is brought to its normal form: one line, lower case, no
/// comments.
std::string check_goal(const Vocabulary& vocabulary, std::string& goal);

}  // namespace praxis::belief
