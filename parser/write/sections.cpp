#include "parser/write/sections.hpp"

#include "parser/write/scope_text.hpp"

namespace praxis::write {
namespace {

void types(const LiftedTask& task, std::string& out) {
    std::string text;
    for (std::size_t i = 1; i < task.types.size(); ++i) {
        const Type& type = task.types[i];
        if (type.name.starts_with('(')) continue;
        text += ' ' + type.name + " - ";
        if (type.parents.size() == 1) {
            text += task.types[type.parents.front().index()].name;
        } else if (type.parents.empty()) {
            text += "object";
        } else {
            text += "(either";
            for (const TypeId parent : type.parents) text += ' ' + task.types[parent.index()].name;
            text += ')';
        }
    }
    if (!text.empty()) out += "  (:types" + text + ")\n";
}

void signature(const LiftedTask& task, const std::string& name, const std::vector<TypeId>& parameters,
               std::string& out) {
    out += '(' + name;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        out += " ?x" + std::to_string(i + 1) + " - " + task.types[parameters[i].index()].name;
    }
    out += ')';
}

}  // namespace

void domain_head(const LiftedTask& task, const std::string& flags, std::string& out) {
    out += "(define (domain " + task.domain_name + ")\n  (:requirements :adl";
    if (!task.axioms.empty()) out += " :derived-predicates";
    if (!task.functions.empty()) out += " :action-costs";
    out += flags + ")\n";
    types(task, out);
    objects(task, ":constants", constants(task), out);
    out += "  (:predicates";
    for (const Predicate& predicate : task.predicates) {
        out += "\n    ";
        signature(task, predicate.name, predicate.parameters, out);
    }
    out += ")\n";
    if (task.functions.empty()) return;
    out += "  (:functions";
    for (const Function& function : task.functions) {
        out += "\n    ";
        signature(task, function.name, function.parameters, out);
        out += " - number";
    }
    out += ")\n";
}

void axioms(const LiftedTask& task, std::string& out) {
    for (const Axiom& axiom : task.axioms) {
        ScopeText text(task, axiom.scope, out);
        out += "  (:derived (" + task.predicates[axiom.predicate.index()].name;
        text.parameters(" ");
        out += ")\n    ";
        text.formula(axiom.body);
        out += ")\n";
    }
}

void schema(const LiftedTask& task, const Schema& schema, const SchemaExtras& extras, std::string& out) {
    ScopeText text(task, schema.scope, out);
    out += "  (:action " + schema.name + "\n    :parameters (";
    text.parameters("");
    out += ')';
    if (schema.precondition.kind != Connective::truth) {
        out += "\n    :precondition ";
        text.formula(schema.precondition);
    }
    if (!schema.effects.empty() || schema.cost || extras.effects) {
        out += "\n    :effect (and";
        for (const Effect& effect : schema.effects) {
            out += "\n      ";
            text.guarded(effect.variables, effect.condition, [&] {
                if (!effect.add) out += "(not ";
                text.atom(effect.predicate, effect.terms);
                if (!effect.add) out += ')';
            });
        }
        if (extras.effects) extras.effects(text);
        if (schema.cost) {
            out += "\n      (increase (total-cost) ";
            text.expression(*schema.cost);
            out += ')';
        }
        out += ')';
    }
    if (extras.parts) extras.parts(text);
    out += ")\n";
}

void objects(const LiftedTask& task, const char* head, const std::vector<bool>& chosen, std::string& out) {
    bool any = false;
    for (std::size_t i = 0; i < task.objects.size(); ++i) {
        if (!chosen[i]) continue;
        const Object& object = task.objects[i];
        if (!any) out += std::string("  (") + head;
        out += (any ? " " : "\n    ") + object.name;
        any = true;
        std::size_t next = i + 1;
        while (next < task.objects.size() && !chosen[next]) ++next;
        if (next < task.objects.size() && task.objects[next].type == object.type) continue;
        out += " - " + task.types[object.type.index()].name;
    }
    if (any) out += ")\n";
}

std::vector<bool> constants(const LiftedTask& task) {
    std::vector<bool> result(task.objects.size());
    for (std::size_t i = 0; i < task.objects.size(); ++i) result[i] = task.objects[i].where.file == 0;
    return result;
}

void initial_facts(const LiftedTask& task, std::string& out) {
    for (std::size_t i = 0; i < task.initial_atoms.size(); ++i) {
        for (std::size_t j = 0; j < task.initial_atoms[i].count; ++j) {
            out += "    ";
            ground_atom(task, PredicateId(i), task.initial_atoms[i].tuple(j), out);
            out += '\n';
        }
    }
    for (std::size_t i = 0; i < task.initial_values.size(); ++i) {
        const FunctionTable& table = task.initial_values[i];
        for (std::size_t j = 0; j < table.tuples.count; ++j) {
            out += "    (= (" + task.functions[i].name;
            for (const ObjectId object : table.tuples.tuple(j))
                out += ' ' + task.objects[object.index()].name;
            out += ") " + table.values[j].to_string() + ")\n";
        }
    }
}

void ground_atom(const LiftedTask& task, PredicateId predicate, std::span<const ObjectId> arguments,
                 std::string& out) {
    out += '(';
    out += task.predicates[predicate.index()].name;
    for (const ObjectId object : arguments) {
        out += ' ';
        out += task.objects[object.index()].name;
    }
    out += ')';
}

void goal(const LiftedTask& task, std::string& out) {
    out += "  (:goal ";
    ScopeText(task, task.goal_scope, out).formula(task.goal);
    out += ")\n";
    if (task.minimize_cost) out += "  (:metric minimize (total-cost))\n";
}

}  // namespace praxis::write
