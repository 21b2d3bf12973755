#include "parser/check/contingent/contingent.hpp"

#include <charconv>

#include "parser/check/atoms.hpp"
#include "parser/check/check.hpp"
#include "parser/check/contingent/sensing.hpp"
#include "parser/check/contingent/uncertainty.hpp"
#include "parser/check/contingent/variables.hpp"
#include "parser/check/goal.hpp"
#include "parser/check/initial.hpp"
#include "parser/check/requirements.hpp"
#include "parser/check/schemas.hpp"
#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

using syntax::Name;
using syntax::Node;
using syntax::NodeIndex;
using syntax::Word;

/// Objects in a domain and constants in a problem are accepted here: benchmarks have them.
void note_misplaced(Context& context, const syntax::Tree& tree) {
    for (const Name& section : tree.misplaced) {
        const bool domain = section.symbol == Word::k_objects;
        context.reporter.warning(tree.where(section), quote(tree.spelled(section)) + " belongs into the " +
                                                          (domain ? "problem" : "domain"));
    }
}

void collect_hidden_objects(Context& context, const syntax::Tree& problem) {
    for (const syntax::Range section : problem.contingent.hidden_objects) {
        for (std::uint32_t i = section.begin; i < section.end; ++i) {
            const ObjectId object = context.objects[problem.typed_names[i].name.symbol];
            if (object.valid()) context.contingent->hidden_objects.push_back(object);
        }
    }
}

PredicateId named_predicate(Context& context, const syntax::Tree& tree, const Name& name) {
    const PredicateId id = context.predicates[name.symbol];
    if (!id.valid()) context.report_unknown("predicate", tree, name, context.task.predicates);
    return id;
}

class PredicateMarks {
  public:
    PredicateMarks(Context& context, const syntax::Tree& domain) : context_(context), tree_(domain) {
        const std::size_t count = context.task.predicates.size();
        context.contingent->open_world.assign(count, false);
        context.contingent->declared_observable.assign(count, false);
        context.contingent->sticky.assign(count, false);
    }

    void check(const syntax::PredicateList& list) {
        ContingentTask& task = *context_.contingent;
        std::vector<bool>& marks = list.keyword.symbol == Word::k_open_world   ? task.open_world
                                   : list.keyword.symbol == Word::k_observable ? task.declared_observable
                                                                               : task.sticky;
        for (const Name& word : list.words) mark(word, marks);
        for (const NodeIndex node : list.nodes) mark(node, marks);
    }

  private:
    void mark(NodeIndex index, std::vector<bool>& marks) {
        const Node& node = tree_.nodes[index];
        if (node.kind == syntax::NodeKind::universal || node.kind == syntax::NodeKind::conjunction) {
            tree_.for_each_child(index, [&](NodeIndex child) { mark(child, marks); });
        } else if (node.kind != syntax::NodeKind::atom) {
            context_.reporter.error(tree_.where(node), "expected a predicate");
        } else {
            mark(node.head, marks);
            for (std::uint32_t i = node.arguments.begin; i < node.arguments.end; ++i) {
                const Name& argument = tree_.names[i];
                if (tree_.text[argument.offset] == '?') continue;
                context_.reporter.warning(tree_.where(argument), "an argument here is ignored",
                                          "all atoms of the predicate are meant");
            }
        }
    }

    void mark(const Name& name, std::vector<bool>& marks) {
        const PredicateId id = named_predicate(context_, tree_, name);
        if (!id.valid()) return;
        if (context_.task.predicates[id.index()].derived && &marks == &context_.contingent->open_world) {
            context_.reporter.error(
                tree_.where(name), "the derived predicate " + quote(tree_.spelled(name)) + " cannot be open");
        }
        marks[id.index()] = true;
    }

    Context& context_;
    const syntax::Tree& tree_;
};

void check_decay(Context& context, const syntax::Tree& domain, const syntax::DecayDeclaration& declaration) {
    const PredicateId id = named_predicate(context, domain, declaration.predicate);
    const std::string_view text = domain.spelled(declaration.steps);
    std::int64_t steps = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), steps);
    if (failed != std::errc() || end != text.data() + text.size() || steps < 1) {
        context.reporter.error(domain.where(declaration.steps),
                               "expected a number of steps, at least 1, found " + quote(text));
        return;
    }
    for (const Decay& decay : context.contingent->decays) {
        if (decay.predicate != id) continue;
        context.reporter.error(domain.where(declaration.predicate),
                               "a second ':decay' of " + quote(domain.spelled(declaration.predicate)));
    }
    context.contingent->decays.push_back({id, steps, domain.where(declaration.predicate)});
}

}  // namespace

CheckedContingentTask check_contingent(const syntax::Tree& domain, const syntax::Tree& problem,
                                       const std::vector<syntax::Tree>& worlds,
                                       const syntax::SymbolTable& symbols, Reporter& reporter) {
    CheckedContingentTask result;
    Context context(symbols, reporter, result.lifted);
    context.contingent = &result.contingent;
    context.types_by_use = domain.types.empty();
    note_misplaced(context, domain);
    note_misplaced(context, problem);
    check_head(context, domain, problem);
    declare_objects(context, problem, problem.contingent.hidden_objects);
    check_declarations(context, domain, problem);
    collect_hidden_objects(context, problem);
    PredicateMarks marks(context, domain);
    for (const syntax::PredicateList& list : domain.contingent.predicates) marks.check(list);
    for (const syntax::DecayDeclaration& decay : domain.contingent.decays)
        check_decay(context, domain, decay);
    collect_readings(context, domain);
    collect_readings(context, problem);
    check_schemas(context, domain);
    check_axioms(context, domain);
    check_sensors(context, domain);
    check_default_model(context, domain);
    const std::vector<TupleIndex> initial_atoms = check_initial_state(context, problem);
    check_uncertainty(context, problem);
    check_variables(context, domain, initial_atoms);
    check_variables(context, problem, initial_atoms);
    settle_rules(context);
    Certainty certainty(context, initial_atoms);
    check_hidden_worlds(context, problem, certainty);
    for (const syntax::Tree& world : worlds) {
        check_world_file(context, world);
        check_hidden_worlds(context, world, certainty);
    }
    check_goal(context, problem);
    check_metric(context, problem);
    check_requirements(context, domain, problem);
    return result;
}

}  // namespace praxis::check
