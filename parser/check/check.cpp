#include "parser/check/check.hpp"

#include <utility>

#include "parser/check/contingent/refuse.hpp"
#include "parser/check/declarations.hpp"
#include "parser/check/goal.hpp"
#include "parser/check/initial.hpp"
#include "parser/check/requirements.hpp"
#include "parser/check/schemas.hpp"
#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

std::string_view refused_construct(syntax::Symbol section) {
    using syntax::Word;
    static constexpr std::pair<Word, std::string_view> kConstructs[] = {
        {Word::k_durative_action, "durative actions"},
        {Word::k_constraints, "trajectory constraints"},
        {Word::k_process, "processes"},
        {Word::k_event, "events"},
        {Word::k_task, "hierarchical tasks"},
        {Word::k_method, "hierarchical methods"},
        {Word::k_htn, "hierarchical goals"},
    };
    for (const auto& [word, construct] : kConstructs) {
        if (section == word) return construct;
    }
    return "classes";
}

void check_sections(Context& context, const syntax::Tree& tree) {
    for (const syntax::Name& section : tree.refused) {
        context.reporter.unsupported(tree.where(section), std::string(refused_construct(section.symbol)));
    }
    for (std::size_t i = 1; i < tree.init_sections.size(); ++i) {
        context.reporter.warning(tree.where(tree.init_sections[i]), "a second ':init'; both count");
    }
}

void check_names(Context& context, const syntax::Tree& domain, const syntax::Tree& problem) {
    if (domain.name) context.task.domain_name = context.text(domain.name->symbol);
    if (problem.name) context.task.problem_name = context.text(problem.name->symbol);
    if (domain.name && problem.domain && problem.domain->symbol != domain.name->symbol) {
        context.reporter.warning(problem.where(*problem.domain),
                                 "the problem is for the domain " + quote(problem.spelled(*problem.domain)) +
                                     ", not for " + quote(domain.spelled(*domain.name)));
    }
}

}  // namespace

void check_head(Context& context, const syntax::Tree& domain, const syntax::Tree& problem) {
    check_sections(context, domain);
    check_sections(context, problem);
    check_names(context, domain, problem);
    declare_types(context, domain);
    declare_objects(context, domain, domain.objects);
    declare_objects(context, problem, problem.objects);
}

void check_declarations(Context& context, const syntax::Tree& domain, const syntax::Tree& problem) {
    collect_objects(context);
    declare_predicates(context, domain);
    declare_functions(context, domain);
    declare_total_cost(context, domain);
    declare_total_cost(context, problem);
    mark_derived(context, domain);
}

std::vector<TupleIndex> check_task(Context& context, const syntax::Tree& domain,
                                   const syntax::Tree& problem) {
    refuse_contingent(context, domain);
    refuse_contingent(context, problem);
    check_head(context, domain, problem);
    check_declarations(context, domain, problem);
    check_schemas(context, domain);
    check_axioms(context, domain);
    std::vector<TupleIndex> initial_atoms = check_initial_state(context, problem);
    check_goal(context, problem);
    check_metric(context, problem);
    check_requirements(context, domain, problem);
    return initial_atoms;
}

LiftedTask check(const syntax::Tree& domain, const syntax::Tree& problem, const syntax::SymbolTable& symbols,
                 Reporter& reporter) {
    LiftedTask task;
    Context context(symbols, reporter, task);
    check_static_goals(context, check_task(context, domain, problem));
    return task;
}

}  // namespace praxis::check
