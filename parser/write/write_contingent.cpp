#include <charconv>
#include <span>

#include "parser/contingent.hpp"
#include "parser/write/scope_text.hpp"
#include "parser/write/sections.hpp"

namespace praxis {
namespace {

std::string number_text(double value) {
    char buffer[32];
    const auto [end, failed] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, failed == std::errc() ? end : buffer};
}

class ContingentWriter {
  public:
    explicit ContingentWriter(const ContingentTask& task) : task_(task), lifted_(*task.task) {}

    std::string domain() {
        write::domain_head(lifted_, " :contingent", out_);
        marks(":open-world", task_.open_world);
        marks(":observable", task_.declared_observable);
        marks(":sticky", task_.sticky);
        for (const Decay& decay : task_.decays) {
            out_ += "  (:decay " + lifted_.predicates[decay.predicate.index()].name + ' ' +
                    std::to_string(decay.steps) + ")\n";
        }
        write::axioms(lifted_, out_);
        for (std::size_t i = 0; i < lifted_.schemas.size(); ++i) schema(i);
        for (const Sensor& one : task_.sensors) sensor(one);
        default_model();
        return out_ + ")\n";
    }

    std::string problem() {
        out_ = "(define (problem " + lifted_.problem_name + ")\n  (:domain " + lifted_.domain_name + ")\n";
        std::vector<bool> hidden(lifted_.objects.size(), false);
        for (const ObjectId object : task_.hidden_objects) hidden[object.index()] = true;
        std::vector<bool> own = write::constants(lifted_);
        own.flip();
        for (std::size_t i = 0; i < own.size(); ++i) own[i] = own[i] && !hidden[i];
        write::objects(lifted_, ":objects", own, out_);
        write::objects(lifted_, ":hidden-objects", hidden, out_);
        for (const MultiValuedVariable& one : task_.variables) variable(one);
        out_ += "  (:init\n";
        write::initial_facts(lifted_, out_);
        for (const GroundLiteral& one : task_.known_false) lines("    ", {&one, 1}, "\n");
        for (const GroundLiteral& one : task_.unknown) lines("    (unknown ", {&one, 1}, ")\n");
        for (const Clause& one : task_.clauses) {
            lines(std::string("    (") + word_of(one), one.literals, ")\n", " ");
        }
        out_ += "  )\n";
        write::goal(lifted_, out_);
        for (const HiddenWorld& world : task_.hidden) lines("  (:hidden", world.literals, ")\n", " ");
        return out_ + ")\n";
    }

  private:
    static const char* word_of(const Clause& clause) {
        switch (clause.kind) {
            case ClauseKind::at_least_one:
                return clause.invariant ? "invariant" : "or";
            case ClauseKind::at_most_one:
                return "at-most-one";
            case ClauseKind::exactly_one:
                break;
        }
        return clause.invariant ? "exactly-one" : "oneof";
    }

    void lines(const std::string& before, std::span<const GroundLiteral> literals, const char* behind,
               const char* separator = "") {
        out_ += before;
        for (const GroundLiteral& literal : literals) {
            out_ += separator;
            if (literal.negated) out_ += "(not ";
            write::ground_atom(lifted_, literal.predicate, literal.arguments, out_);
            if (literal.negated) out_ += ')';
        }
        out_ += behind;
    }

    void marks(const char* keyword, const std::vector<bool>& marked) {
        std::string names;
        for (std::size_t i = 0; i < marked.size(); ++i) {
            if (marked[i]) names += ' ' + lifted_.predicates[i].name;
        }
        if (!names.empty()) out_ += std::string("  (") + keyword + names + ")\n";
    }

    void variable(const MultiValuedVariable& variable) {
        std::string name = variable.name;
        if (const std::size_t at = name.find('('); at != std::string::npos) {
            name = '(' + name.substr(0, at) + ' ' + name.substr(at + 1);
        }
        lines((variable.observable ? "  (:obs-variable " : "  (:variable ") + name, variable.values, ")\n",
              " ");
    }

    void observations(write::ScopeText& text, const std::vector<Observation>& all, const char* before) {
        for (const Observation& one : all) {
            out_ += before;
            text.guarded(one.variables, one.condition, [&] {
                const bool exact = one.accuracy == 1;
                if (!exact) out_ += "(probabilistic " + number_text(one.accuracy) + ' ';
                text.atom(one.predicate, one.terms);
                if (!exact) out_ += ')';
            });
        }
    }

    void model(write::ScopeText& text, const std::vector<SensingRule>& rules) {
        for (const SensingRule& rule : rules) {
            out_ += "\n      ";
            text.guarded(rule.variables, rule.condition, [&] {
                if (!rule.value) out_ += "(not ";
                text.atom(rule.predicate, rule.terms);
                if (!rule.value) out_ += ')';
            });
        }
    }

    void schema(std::size_t index) {
        const SchemaSensing& sensing = task_.sensing[index];
        write::SchemaExtras extras;
        if (!sensing.forgotten.empty()) {
            extras.effects = [&](write::ScopeText& text) {
                for (const Effect& effect : sensing.forgotten) {
                    out_ += "\n      ";
                    text.guarded(effect.variables, effect.condition, [&] {
                        out_ += "(unknown ";
                        text.atom(effect.predicate, effect.terms);
                        out_ += ')';
                    });
                }
            };
        }
        extras.parts = [&](write::ScopeText& text) {
            if (!sensing.observations.empty()) out_ += "\n    :observe";
            observations(text, sensing.observations, "\n      ");
            if (!sensing.own_model) return;
            out_ += "\n    :sensing-model (and";
            model(text, sensing.model);
            out_ += ')';
        };
        write::schema(lifted_, lifted_.schemas[index], extras, out_);
    }

    void sensor(const Sensor& sensor) {
        write::ScopeText text(lifted_, sensor.scope, out_);
        out_ += "  (:sensor " + sensor.name + "\n    :parameters (";
        text.parameters("");
        out_ += ')';
        if (sensor.condition.kind != Connective::truth) {
            out_ += "\n    :condition ";
            text.formula(sensor.condition);
        }
        out_ += "\n    :sense";
        observations(text, sensor.observations, " ");
        out_ += ")\n";
    }

    void default_model() {
        if (task_.default_model.empty() && task_.default_observations.empty()) return;
        write::ScopeText text(lifted_, task_.default_scope, out_);
        out_ += "  (:default-sensing-model (and";
        model(text, task_.default_model);
        observations(text, task_.default_observations, "\n      ");
        out_ += "))\n";
    }

    const ContingentTask& task_;
    const LiftedTask& lifted_;
    std::string out_;
};

}  // namespace

std::string write_contingent_domain(const ContingentTask& task) {
    return ContingentWriter(task).domain();
}

std::string write_contingent_problem(const ContingentTask& task) {
    return ContingentWriter(task).problem();
}

}  // namespace praxis
