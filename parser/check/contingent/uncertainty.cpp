#include "parser/check/contingent/uncertainty.hpp"

#include <optional>
#include <utility>

#include "parser/check/atoms.hpp"
#include "parser/check/ground.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

class UncertaintyChecker {
  public:
    UncertaintyChecker(Context& context, const syntax::Tree& tree)
        : context_(context), task_(*context.contingent), tree_(tree), ground_(context, tree) {}

    void check_initial(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        if (node.kind == NodeKind::conjunction) {
            tree_.for_each_child(index, [&](NodeIndex child) { check_initial(child); });
        } else if (node.kind == NodeKind::negation && tree_.nodes[index + 1].kind == NodeKind::atom) {
            if (std::optional<GroundLiteral> found = literal(index)) {
                task_.known_false.push_back(std::move(*found));
            }
        } else if (states_uncertainty(context_, node)) {
            if (node.head.symbol == Word::unknown) {
                check_unknown(index);
            } else {
                check_clause(index);
            }
        }
    }

    void check_world(const syntax::HiddenSection& section, Certainty& certainty) {
        HiddenWorld world;
        world.where = tree_.where(section.keyword);
        for (const NodeIndex index : section.literals) add_literals(index, world.literals);
        for (const GroundLiteral& one : world.literals) certainty.check(one);
        task_.hidden.push_back(std::move(world));
    }

  private:
    void check_unknown(NodeIndex index) {
        if (report_words(index)) return;
        tree_.for_each_child(index, [&](NodeIndex child) {
            if (std::optional<GroundLiteral> found = literal(child)) {
                found->negated = false;
                task_.unknown.push_back(std::move(*found));
            }
        });
    }

    void check_clause(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        const syntax::Symbol head = node.head.symbol;
        Clause clause;
        clause.where = tree_.where(node);
        clause.invariant = head != Word::disjunction && head != Word::oneof;
        if (head == Word::oneof || head == Word::exactly_one) clause.kind = ClauseKind::exactly_one;
        if (head == Word::at_most_one) clause.kind = ClauseKind::at_most_one;
        bool right = true;
        tree_.for_each_child(index, [&](NodeIndex child) {
            std::optional<GroundLiteral> found = literal(child);
            right = right && found.has_value();
            if (found) clause.literals.push_back(std::move(*found));
        });
        if (report_words(index)) return;
        if (right && clause.literals.empty() && clause.kind != ClauseKind::at_most_one) {
            context_.reporter.error(tree_.where(node),
                                    "an empty " + quote(tree_.spelled(node.head)) + " cannot hold");
        }
        task_.clauses.push_back(std::move(clause));
    }

    /// Words where only literals can stand.
    bool report_words(NodeIndex index) {
        if (tree_.nodes[index].kind == NodeKind::disjunction) return false;
        const std::vector<syntax::Name> words = tree_.own_words(index);
        for (const syntax::Name& word : words) {
            context_.reporter.error(tree_.where(word),
                                    "expected a literal, found " + quote(tree_.spelled(word)));
        }
        return !words.empty();
    }

    void add_literals(NodeIndex index, std::vector<GroundLiteral>& literals) {
        if (tree_.nodes[index].kind == NodeKind::conjunction) {
            tree_.for_each_child(index, [&](NodeIndex child) { add_literals(child, literals); });
        } else if (std::optional<GroundLiteral> found = literal(index)) {
            literals.push_back(std::move(*found));
        }
    }

    std::optional<GroundLiteral> literal(NodeIndex index) {
        const bool negated = tree_.nodes[index].kind == NodeKind::negation;
        const Node& node = tree_.nodes[negated ? index + 1 : index];
        if (node.kind == NodeKind::nested) {
            refuse_nested(context_, tree_, node);
            return std::nullopt;
        }
        if (node.kind != NodeKind::atom) {
            context_.reporter.error(tree_.where(node), "expected a literal: (p a) or (not (p a))");
            return std::nullopt;
        }
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return std::nullopt;
        const Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.derived) {
            context_.reporter.error(tree_.where(node), "the derived predicate " + quote(predicate.name) +
                                                           " cannot stand in the initial state");
        }
        if (!ground_.resolve(node, "predicate", predicate.parameters)) return std::nullopt;
        return GroundLiteral{id, ground_.tuple(), negated, tree_.where(tree_.nodes[index])};
    }

    Context& context_;
    ContingentTask& task_;
    const syntax::Tree& tree_;
    GroundArguments ground_;
};

}  // namespace

void check_uncertainty(Context& context, const syntax::Tree& problem) {
    UncertaintyChecker checker(context, problem);
    for (const NodeIndex index : problem.init) checker.check_initial(index);
}

void check_hidden_worlds(Context& context, const syntax::Tree& tree, Certainty& certainty) {
    UncertaintyChecker checker(context, tree);
    for (const syntax::HiddenSection& section : tree.contingent.hidden)
        checker.check_world(section, certainty);
}

void check_world_file(Context& context, const syntax::Tree& world) {
    const auto ignored = [&](const syntax::Name& section) {
        context.reporter.warning(world.where(section), "a world file has only ':hidden' sections",
                                 "this one is ignored");
    };
    for (const syntax::Name& section : world.init_sections) ignored(section);
    for (const syntax::Name& section : world.misplaced) ignored(section);
    for (const syntax::Name& section : world.refused) ignored(section);
    for (const syntax::Name& section : world.contingent.keywords) {
        if (section.symbol != Word::k_hidden) ignored(section);
    }
    if (world.contingent.hidden.empty() && world.name) {
        context.reporter.warning(world.where(*world.name),
                                 "there is no ':hidden' section in this world file");
    }
}

}  // namespace praxis::check
