#include "parser/check/requirements.hpp"

#include <algorithm>
#include <initializer_list>

namespace praxis::check {
namespace {

constexpr std::size_t kFeatures = static_cast<std::size_t>(Feature::count);

constexpr std::array<std::string_view, kFeatures> kFlags = {
    ":typing",
    ":equality",
    ":negative-preconditions",
    ":disjunctive-preconditions",
    ":existential-preconditions",
    ":universal-preconditions",
    ":conditional-effects",
    ":derived-predicates",
    ":action-costs",
};

/// Flags that stand for others, or for nothing that is checked here.
struct Implication {
    std::string_view flag;
    std::initializer_list<Feature> features;
};

constexpr std::initializer_list<Feature> kAdl = {
    Feature::typing,
    Feature::equality,
    Feature::negative_preconditions,
    Feature::disjunctive_preconditions,
    Feature::existential_preconditions,
    Feature::universal_preconditions,
    Feature::conditional_effects,
};

const std::array<Implication, 25> kImplications = {{
    {":adl", kAdl},
    {":ucpop", kAdl},
    {":quantified-preconditions", {Feature::existential_preconditions, Feature::universal_preconditions}},
    {":fluents", {Feature::action_costs}},
    {":numeric-fluents", {Feature::action_costs}},
    {":object-fluents", {Feature::action_costs}},
    {":axioms", {Feature::derived_predicates}},
    {":domain-axioms", {Feature::derived_predicates}},
    {":constants", {}},
    {":strips", {}},
    {":durative-actions", {}},
    {":duration-inequalities", {}},
    {":continuous-effects", {}},
    {":timed-initial-literals", {}},
    {":timed-effects", {}},
    {":time", {}},
    {":preferences", {}},
    {":constraints", {}},
    {":goal-utilities", {}},
    {":existential-quantification", {Feature::existential_preconditions}},
    {":safety-constraints", {}},
    {":contingent", {}},
    {":partial-observability", {}},
    {":open-world", {}},
    {":translation", {}},
}};

void announce(Context& context, const syntax::Tree& tree, const syntax::Name& flag,
              std::array<bool, kFeatures>& announced) {
    const std::string_view text = context.symbols.text(flag.symbol);
    bool known = false;
    for (std::size_t i = 0; i < kFeatures; ++i) {
        if (kFlags[i] == text) known = announced[i] = true;
    }
    for (const Implication& implication : kImplications) {
        if (implication.flag != text) continue;
        known = true;
        for (const Feature feature : implication.features)
            announced[static_cast<std::size_t>(feature)] = true;
    }
    if (known) return;
    Suggestion suggestion(text);
    for (const std::string_view candidate : kFlags) suggestion.consider(candidate);
    for (const Implication& implication : kImplications) suggestion.consider(implication.flag);
    context.reporter.warning(tree.where(flag), "unknown requirement " + quote(tree.spelled(flag)),
                             suggestion.hint());
}

}  // namespace

void check_requirements(Context& context, const syntax::Tree& domain, const syntax::Tree& problem) {
    std::array<bool, kFeatures> announced{};
    for (const syntax::Name& flag : domain.requirements) announce(context, domain, flag, announced);
    for (const syntax::Name& flag : problem.requirements) announce(context, problem, flag, announced);
    for (std::size_t i = 0; i < kFeatures; ++i) {
        if (announced[i] || !context.features[i]) continue;
        context.reporter.warning(*context.features[i],
                                 "this needs " + quote(kFlags[i]) + ", which is missing in :requirements");
    }
}

}  // namespace praxis::check
