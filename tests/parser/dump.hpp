// Tasks as canonical text: names instead of numbers, no places, variables by the order in which they are
// bound. Two tasks that say the same have the same text; it shares no code with the writer of PDDL.
#pragma once

#include <string>
#include <vector>

#include "parser/contingent.hpp"
#include "parser/task.hpp"

namespace praxis::test {

class Dump {
  public:
    explicit Dump(const LiftedTask& task) : task_(task) {}

    std::string task() {
        text_ += task_.domain_name + ' ' + task_.problem_name + '\n';
        for (std::size_t i = 0; i < task_.types.size(); ++i) type(TypeId(i));
        for (const Object& object : task_.objects) line("object " + object.name + ' ' + name(object.type));
        for (std::size_t i = 0; i < task_.predicates.size(); ++i) predicate(i);
        for (std::size_t i = 0; i < task_.functions.size(); ++i) function(i);
        for (const Axiom& axiom : task_.axioms) {
            scope("axiom " + task_.predicates[axiom.predicate.index()].name, axiom.scope);
            formula(axiom.body);
        }
        for (const Schema& schema : task_.schemas) {
            scope("action " + schema.name, schema.scope);
            formula(schema.precondition);
            for (const Effect& one : schema.effects) effect(one.add ? "\n  add" : "\n  delete", one);
            if (schema.cost) expression(*schema.cost);
        }
        scope("goal", task_.goal_scope);
        formula(task_.goal);
        line(task_.minimize_cost ? "minimize" : "");
        return text_;
    }

    std::string contingent(const ContingentTask& task) {
        for (std::size_t i = 0; i < task_.schemas.size(); ++i) {
            scope("senses " + task_.schemas[i].name, task_.schemas[i].scope);
            for (const Observation& one : task.sensing[i].observations) observation(one);
            for (const SensingRule& one : task.sensing[i].model) rule(one);
            for (const Effect& one : task.sensing[i].forgotten) effect("\n  forget", one);
            if (task.sensing[i].own_model) text_ += " model";
        }
        for (const Sensor& sensor : task.sensors) {
            scope("sensor " + sensor.name, sensor.scope);
            formula(sensor.condition);
            for (const Observation& one : sensor.observations) observation(one);
        }
        scope("default", task.default_scope);
        for (const SensingRule& one : task.default_model) rule(one);
        for (const Observation& one : task.default_observations) observation(one);
        for (const MultiValuedVariable& one : task.variables) {
            literals((one.observable ? "readable " : "variable ") + one.name, one.values);
        }
        literals("unknown", task.unknown);
        literals("false", task.known_false);
        for (const Clause& one : task.clauses) {
            literals("clause " + std::to_string(static_cast<int>(one.kind)) + (one.invariant ? "!" : ""),
                     one.literals);
        }
        for (const HiddenWorld& one : task.hidden) literals("world", one.literals);
        marks("open", task.open_world);
        marks("observable", task.declared_observable);
        marks("sticky", task.sticky);
        for (const Decay& one : task.decays) {
            line("decay " + task_.predicates[one.predicate.index()].name + ' ' + std::to_string(one.steps));
        }
        for (const ObjectId one : task.hidden_objects) line("hidden " + task_.objects[one.index()].name);
        return text_;
    }

  private:
    void line(const std::string& text) { text_ += '\n' + text; }
    const std::string& name(TypeId type) const { return task_.types[type.index()].name; }

    /// Either types are made when they are used, so that their order means nothing.
    void type(TypeId id) {
        const Type& one = task_.types[id.index()];
        if (one.name.starts_with('(')) return;
        line("type " + one.name);
        for (const TypeId parent : one.parents) text_ += ' ' + name(parent);
        text_ += ':';
        for (const ObjectId object : one.objects) text_ += ' ' + task_.objects[object.index()].name;
    }

    void tuples(const Relation& relation) {
        for (std::size_t j = 0; j < relation.count; ++j) {
            text_ += '/';
            for (const ObjectId object : relation.tuple(j)) text_ += ' ' + task_.objects[object.index()].name;
        }
    }

    void predicate(std::size_t i) {
        const Predicate& one = task_.predicates[i];
        line("predicate " + one.name + (one.fluent ? " fluent" : "") + (one.derived ? " derived" : ""));
        for (const TypeId parameter : one.parameters) text_ += ' ' + name(parameter);
        if (i < task_.initial_atoms.size()) tuples(task_.initial_atoms[i]);
    }

    void function(std::size_t i) {
        line("function " + task_.functions[i].name);
        for (const TypeId parameter : task_.functions[i].parameters) text_ += ' ' + name(parameter);
        tuples(task_.initial_values[i].tuples);
        for (const Rational& value : task_.initial_values[i].values) text_ += ' ' + value.to_string();
    }

    void scope(const std::string& head, const Scope& one) {
        line(head);
        scope_ = &one;
        order_.assign(one.variable_types.size(), 0);
        bound_ = 0;
        for (std::uint32_t i = 0; i < one.parameter_count; ++i) {
            bind(i);
            text_ += one.variable_names[i];
        }
    }

    void bind(std::uint32_t variable) {
        order_[variable] = bound_++;
        text_ += " ?" + std::to_string(order_[variable]) + ':' + name(scope_->variable_types[variable]);
    }

    void bind(const std::vector<std::uint32_t>& variables) {
        for (const std::uint32_t variable : variables) bind(variable);
    }

    void terms(const std::vector<Term>& all) {
        for (const Term term : all) {
            text_ += term.is_variable() ? " ?" + std::to_string(order_[term.variable_index()])
                                        : ' ' + task_.objects[term.object_id().index()].name;
        }
    }

    void atom(PredicateId predicate, const std::vector<Term>& all) {
        text_ += '[' + task_.predicates[predicate.index()].name;
        terms(all);
        text_ += ']';
    }

    void formula(const Formula& one) {
        const std::size_t outer = bound_;
        text_ += " (" + std::to_string(static_cast<int>(one.kind));
        bind(one.variables);
        if (one.kind == Connective::atom) atom(one.predicate, one.terms);
        if (one.kind == Connective::equality) terms(one.terms);
        for (const Formula& child : one.children) formula(child);
        text_ += ')';
        bound_ = outer;
    }

    template <class Guarded>
    void guarded(const std::string& head, const Guarded& one) {
        const std::size_t outer = bound_;
        text_ += head;
        bind(one.variables);
        formula(one.condition);
        atom(one.predicate, one.terms);
        bound_ = outer;
    }

    void effect(const std::string& head, const Effect& one) { guarded(head, one); }
    void rule(const SensingRule& one) { guarded(one.value ? "\n  reads" : "\n  reads not", one); }
    void observation(const Observation& one) {
        guarded("\n  observes", one);
        text_ += std::to_string(one.accuracy);
    }

    void expression(const Expression& one) {
        text_ += " {" + std::to_string(static_cast<int>(one.kind)) + ' ';
        if (one.kind == Expression::Kind::constant) text_ += one.value.to_string();
        if (one.kind == Expression::Kind::function) text_ += task_.functions[one.function.index()].name;
        terms(one.terms);
        for (const Expression& child : one.children) expression(child);
        text_ += '}';
    }

    void literals(const std::string& head, const std::vector<GroundLiteral>& all) {
        line(head);
        for (const GroundLiteral& one : all) {
            text_ += (one.negated ? " -" : " +") + task_.predicates[one.predicate.index()].name;
            for (const ObjectId object : one.arguments) text_ += ',' + task_.objects[object.index()].name;
        }
    }

    void marks(const std::string& head, const std::vector<bool>& marked) {
        line(head);
        for (std::size_t i = 0; i < marked.size(); ++i) {
            if (marked[i]) text_ += ' ' + task_.predicates[i].name;
        }
    }

    const LiftedTask& task_;
    const Scope* scope_ = nullptr;
    std::vector<std::size_t> order_;  ///< by variable: how many were bound around it
    std::size_t bound_ = 0;
    std::string text_;
};

inline std::string dump(const LiftedTask& task) {
    return Dump(task).task();
}

inline std::string dump(const ContingentTask& task) {
    return Dump(*task.task).task() + Dump(*task.task).contingent(task);
}

}  // namespace praxis::test
