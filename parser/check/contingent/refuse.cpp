#include "parser/check/contingent/refuse.hpp"

#include <algorithm>
#include <utility>

namespace praxis::check {
namespace {

std::string_view construct_of(syntax::Symbol keyword) {
    using syntax::Word;
    static constexpr std::pair<Word, std::string_view> kConstructs[] = {
        {Word::k_observe, "sensing actions"},
        {Word::k_sensing_model, "sensing actions"},
        {Word::k_default_sensing_model, "sensing actions"},
        {Word::k_sensor, "sensors"},
        {Word::k_variable, "multi-valued variables"},
        {Word::k_obs_variable, "multi-valued variables"},
        {Word::k_hidden, "hidden worlds"},
        {Word::k_hidden_objects, "hidden objects"},
    };
    for (const auto& [word, construct] : kConstructs) {
        if (keyword == word) return construct;
    }
    return "partially observable predicates";
}

}  // namespace

void refuse_contingent(Context& context, const syntax::Tree& tree) {
    std::vector<std::string_view> said;
    for (const syntax::Name& keyword : tree.contingent.keywords) {
        const std::string_view construct = construct_of(keyword.symbol);
        if (std::find(said.begin(), said.end(), construct) != said.end()) continue;
        said.push_back(construct);
        context.reporter.unsupported(tree.where(keyword), std::string(construct), std::string(kBeliefHint));
    }
    for (const syntax::Name& section : tree.misplaced) {
        const bool domain = section.symbol == syntax::Word::k_objects;
        context.reporter.error(tree.where(section),
                               std::string(domain ? "a domain" : "a problem") + " has no section " +
                                   quote(tree.spelled(section)),
                               std::string("it belongs into the ") + (domain ? "problem" : "domain"));
    }
}

}  // namespace praxis::check
