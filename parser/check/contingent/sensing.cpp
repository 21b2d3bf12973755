#include "parser/check/contingent/sensing.hpp"

#include <charconv>
#include <optional>
#include <unordered_set>
#include <utility>

#include "parser/check/atoms.hpp"
#include "parser/check/conditions.hpp"
#include "parser/check/guards.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

/// Flattens what stands behind `:observe`, `:sense` and `:sensing-model`. A literal of a sensing model over
/// the atoms of an `:obs-variable` is a rule; any other literal is read directly.
class SensingChecker {
  public:
    SensingChecker(ScopeBuilder& scope, std::vector<Observation>& observations,
                   std::vector<SensingRule>* model)
        : scope_(scope),
          context_(scope.context()),
          tree_(scope.tree()),
          guards_(scope),
          observations_(observations),
          model_(model) {}

    void check(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::empty:
                break;
            case NodeKind::atom:
                literal(node, true);
                break;
            case NodeKind::negation:
                if (tree_.nodes[index + 1].kind != NodeKind::atom) {
                    context_.reporter.error(tree_.where(node), "only an atom can be sensed");
                } else {
                    literal(tree_.nodes[index + 1], false);
                }
                break;
            case NodeKind::conjunction:
                tree_.for_each_child(index, [&](NodeIndex child) { check(child); });
                break;
            case NodeKind::universal:
                guards_.universal(index, [this](NodeIndex body) { check(body); });
                break;
            case NodeKind::when:
                guards_.conditional(index, [this](NodeIndex body) { check(body); });
                break;
            case NodeKind::nested:
                if (node.head.symbol == Word::probabilistic &&
                    !context_.predicates[node.head.symbol].valid()) {
                    probabilistic(index);
                } else {
                    refuse_nested(context_, tree_, node);
                }
                break;
            default:
                context_.reporter.error(tree_.where(node.head),
                                        quote(tree_.spelled(node.head)) + " cannot be sensed");
                break;
        }
    }

  private:
    /// `(probabilistic 0.8 (p))`
    void probabilistic(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        const std::vector<syntax::Name> words = tree_.own_words(index);
        if (words.size() != 1 || tree_.nodes[index + 1].end != node.end) {
            context_.reporter.error(tree_.where(node), "expected (probabilistic NUMBER LITERAL)");
            return;
        }
        const syntax::Name& word = words.front();
        const std::string_view text = tree_.spelled(word);
        double value = 0;
        const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (failed != std::errc() || end != text.data() + text.size() || !(value > 0 && value <= 1)) {
            context_.reporter.error(tree_.where(word),
                                    "expected a probability in (0, 1], found " + quote(text));
            return;
        }
        if (model_ != nullptr) {
            context_.reporter.unsupported(tree_.where(node.head), "probabilities in sensing models",
                                          "':observe' and ':sense' can have them");
            return;
        }
        const double outer = std::exchange(accuracy_, value);
        check(index + 1);
        accuracy_ = outer;
    }

    void literal(const Node& node, bool value) {
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return;
        std::optional<std::vector<Term>> terms =
            resolve_arguments(scope_, node, "predicate", context_.task.predicates[id.index()].parameters);
        if (!terms) return;
        Formula condition = guards_.condition(tree_.where(node));
        if (model_ != nullptr && context_.readings[id.index()]) {
            model_->push_back(
                {guards_.variables(), std::move(condition), value, id, std::move(*terms), tree_.where(node)});
        } else {
            observations_.push_back({guards_.variables(), std::move(condition), id, std::move(*terms),
                                     accuracy_, tree_.where(node)});
        }
    }

    ScopeBuilder& scope_;
    Context& context_;
    const syntax::Tree& tree_;
    Guards guards_;
    std::vector<Observation>& observations_;
    std::vector<SensingRule>* model_;
    double accuracy_ = 1;
};

/// Marks the predicates of the values of a variable; conditions of `when` are no values.
void mark_readings(Context& context, const syntax::Tree& tree, NodeIndex index) {
    const Node& node = tree.nodes[index];
    if (node.kind == NodeKind::atom) {
        const PredicateId id = context.predicates[node.head.symbol];
        if (id.valid()) context.readings[id.index()] = true;
    } else if (node.kind == NodeKind::when) {
        mark_readings(context, tree, tree.nodes[index + 1].end);
    } else {
        tree.for_each_child(index, [&](NodeIndex child) { mark_readings(context, tree, child); });
    }
}

void settle(const std::vector<bool>& readings, std::vector<SensingRule>& rules,
            std::vector<Observation>& observations) {
    std::vector<SensingRule> kept;
    for (SensingRule& rule : rules) {
        if (readings[rule.predicate.index()]) {
            kept.push_back(std::move(rule));
        } else {
            observations.push_back({std::move(rule.variables), std::move(rule.condition), rule.predicate,
                                    std::move(rule.terms), 1, rule.where});
        }
    }
    rules = std::move(kept);
}

}  // namespace

void settle_rules(Context& context) {
    ContingentTask& task = *context.contingent;
    context.readings.assign(context.task.predicates.size(), false);
    for (const MultiValuedVariable& variable : task.variables) {
        if (!variable.observable) continue;
        for (const GroundLiteral& value : variable.values) context.readings[value.predicate.index()] = true;
    }
    for (SchemaSensing& sensing : task.sensing) {
        settle(context.readings, sensing.model, sensing.observations);
    }
    settle(context.readings, task.default_model, task.default_observations);
}

void collect_readings(Context& context, const syntax::Tree& tree) {
    context.readings.resize(context.task.predicates.size(), false);
    for (const syntax::VariableDeclaration& variable : tree.contingent.variables) {
        if (variable.keyword.symbol != Word::k_obs_variable) continue;
        for (const NodeIndex value : variable.values) mark_readings(context, tree, value);
    }
}

std::size_t check_action_sensing(ScopeBuilder& scope, std::size_t next) {
    Context& context = scope.context();
    SchemaSensing& sensing = context.contingent->sensing.back();
    const std::size_t action = context.contingent->sensing.size() - 1;
    const std::vector<syntax::ActionSensing>& parts = scope.tree().contingent.actions;
    for (; next < parts.size() && parts[next].action == action; ++next) {
        const bool model = parts[next].keyword.symbol == Word::k_sensing_model;
        SensingChecker checker(scope, sensing.observations, model ? &sensing.model : nullptr);
        sensing.own_model = sensing.own_model || model;
        for (const NodeIndex node : parts[next].nodes) checker.check(node);
    }
    return next;
}

void check_sensors(Context& context, const syntax::Tree& domain) {
    std::unordered_set<std::uint32_t> names;
    for (const syntax::SensorDeclaration& declaration : domain.contingent.sensors) {
        if (!names.insert(syntax::index(declaration.name.symbol)).second) {
            context.reporter.error(domain.where(declaration.name),
                                   "duplicate sensor " + quote(domain.spelled(declaration.name)));
        }
        Sensor& sensor = context.contingent->sensors.emplace_back();
        sensor.name = context.text(declaration.name.symbol);
        sensor.where = domain.where(declaration.name);
        ScopeBuilder scope(context, domain, sensor.scope);
        scope.bind_parameters(declaration.parameters);
        sensor.condition = check_condition(scope, declaration.condition);
        SensingChecker checker(scope, sensor.observations, nullptr);
        for (const NodeIndex node : declaration.sensed) checker.check(node);
        if (declaration.sensed.empty()) {
            context.reporter.error(domain.where(declaration.name), "a sensor without ':sense'");
        }
    }
}

void check_default_model(Context& context, const syntax::Tree& domain) {
    ContingentTask& task = *context.contingent;
    ScopeBuilder scope(context, domain, task.default_scope);
    SensingChecker checker(scope, task.default_observations, &task.default_model);
    for (const NodeIndex node : domain.contingent.default_models) checker.check(node);
}

}  // namespace praxis::check
