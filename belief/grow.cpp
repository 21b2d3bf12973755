#include "belief/grow.hpp"

#include <algorithm>
#include <set>

#include "belief/atom_names.hpp"

namespace praxis::belief {
namespace {

bool any_hidden(const std::vector<ObjectId>& arguments, const std::vector<bool>& hidden) {
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](ObjectId object) { return static_cast<bool>(hidden[object.index()]); });
}
bool any_hidden(const GroundLiteral& literal, const std::vector<bool>& hidden) {
    return any_hidden(literal.arguments, hidden);
}
bool any_hidden(const Clause& clause, const std::vector<bool>& hidden) {
    return std::any_of(clause.literals.begin(), clause.literals.end(),
                       [&](const GroundLiteral& literal) { return any_hidden(literal, hidden); });
}

void remove_tuples(Relation& relation, const std::vector<bool>& hidden) {
    Relation kept{relation.arity, 0, {}};
    for (std::size_t i = 0; i < relation.count; ++i) {
        const auto tuple = relation.tuple(i);
        if (any_hidden({tuple.begin(), tuple.end()}, hidden)) continue;
        kept.arguments.insert(kept.arguments.end(), tuple.begin(), tuple.end());
        ++kept.count;
    }
    relation = std::move(kept);
}

/// Adds the object to its type and all types above.
void add_to_types(LiftedTask& task, TypeId type) {
    const ObjectId object(task.objects.size() - 1);
    std::set<std::size_t> above{type.index()};
    std::vector<std::size_t> queue{type.index()};
    while (!queue.empty()) {
        const std::size_t next = queue.back();
        queue.pop_back();
        for (TypeId parent : task.types[next].parents)
            if (above.insert(parent.index()).second) queue.push_back(parent.index());
    }
    above.insert(0);
    for (std::size_t t = 0; t < task.types.size(); ++t) {
        task.types[t].contains.push_back(above.contains(t));
        if (above.contains(t)) task.types[t].objects.push_back(object);
    }
}

bool add_object(LiftedTask& task, const Detection& detection) {
    for (std::size_t t = 0; t < task.types.size(); ++t) {
        if (task.types[t].name != detection.type) continue;
        Object object;
        object.name = detection.object;
        object.type = TypeId(t);
        task.objects.push_back(std::move(object));
        add_to_types(task, TypeId(t));
        return true;
    }
    return false;
}

/// Puts what is known now in the place of what was known at first.
class Present {
  public:
    Present(ContingentTask& task, LiftedTask& lifted, const Belief& belief)
        : task_(task), lifted_(lifted), belief_(belief), names_(belief.compilation().belief()) {}

    void write() {
        const BeliefTask& ground = belief_.compilation().belief();
        drop_changed_clauses();
        for (std::size_t v = 0; v < ground.physical->variable_count(); ++v) {
            const auto variable = static_cast<std::int32_t>(v);
            if (ground.physical->derived(variable)) continue;
            for (std::int32_t value = 0; value < ground.physical->domain_sizes[v]; ++value)
                write({variable, value});
        }
    }

  private:
    void write(Fact fact) {
        const auto atom = names_.literal(fact);
        if (!atom || atom->negated) return;
        GroundLiteral literal = *atom;
        forget(literal);
        switch (truth(fact)) {
            case Truth::known_true: {
                Relation& relation = lifted_.initial_atoms[literal.predicate.index()];
                relation.arguments.insert(relation.arguments.end(), literal.arguments.begin(),
                                          literal.arguments.end());
                ++relation.count;
                break;
            }
            case Truth::known_false:
                literal.negated = true;
                task_.known_false.push_back(literal);
                break;
            case Truth::unknown:
                task_.unknown.push_back(literal);
                break;
        }
    }

    /// What is in doubt counts as supposed: certain variables stay certain.
    Truth truth(Fact fact) const {
        if (belief_.compilation().belief().uncertain[index(fact.variable)]) return belief_.truth(fact);
        return belief_.supposes(fact) ? Truth::known_true : Truth::known_false;
    }

    /// What the initial description says of the atom alone.
    void forget(const GroundLiteral& literal) {
        const auto same = [&](const GroundLiteral& other) {
            return other.predicate == literal.predicate && other.arguments == literal.arguments;
        };
        std::erase_if(task_.known_false, same);
        std::erase_if(task_.unknown, same);
        Relation& relation = lifted_.initial_atoms[literal.predicate.index()];
        for (std::size_t i = 0; i < relation.count; ++i) {
            if (!std::ranges::equal(relation.tuple(i), literal.arguments)) continue;
            const auto begin = relation.arguments.begin() + static_cast<std::ptrdiff_t>(i * relation.arity);
            relation.arguments.erase(begin, begin + relation.arity);
            --relation.count;
            return;
        }
    }

    /// Clauses are about the first state: where an action may have changed something, they say nothing now.
    void drop_changed_clauses() {
        const FiniteDomainTask& physical = *belief_.compilation().belief().physical;
        std::erase_if(task_.clauses, [&](const Clause& clause) {
            return std::any_of(
                clause.literals.begin(), clause.literals.end(), [&](const GroundLiteral& literal) {
                    const auto fact = names_.fact(literal);
                    return fact && !physical.derived(fact->variable) && belief_.touched(fact->variable);
                });
        });
    }

    ContingentTask& task_;
    LiftedTask& lifted_;
    const Belief& belief_;
    AtomNames names_;
};

}  // namespace

std::shared_ptr<const ContingentTask> visible_part(const ContingentTask& full) {
    auto result = std::make_shared<ContingentTask>(full);
    if (full.hidden_objects.empty()) return result;
    auto lifted = std::make_shared<LiftedTask>(*full.task);
    std::vector<bool> hidden(lifted->objects.size(), false);
    for (ObjectId object : full.hidden_objects) hidden[object.index()] = true;
    for (Type& type : lifted->types) {
        std::erase_if(type.objects,
                      [&](ObjectId object) { return static_cast<bool>(hidden[object.index()]); });
        for (std::size_t o = 0; o < hidden.size(); ++o)
            if (hidden[o]) type.contains[o] = false;
    }
    for (Relation& relation : lifted->initial_atoms) remove_tuples(relation, hidden);
    for (FunctionTable& table : lifted->initial_values) {
        FunctionTable kept{{table.tuples.arity, 0, {}}, {}};
        for (std::size_t i = 0; i < table.tuples.count; ++i) {
            const auto tuple = table.tuples.tuple(i);
            if (any_hidden({tuple.begin(), tuple.end()}, hidden)) continue;
            kept.tuples.arguments.insert(kept.tuples.arguments.end(), tuple.begin(), tuple.end());
            ++kept.tuples.count;
            kept.values.push_back(table.values[i]);
        }
        table = std::move(kept);
    }
    const auto is_hidden = [&](const auto& item) { return any_hidden(item, hidden); };
    std::erase_if(result->unknown, is_hidden);
    std::erase_if(result->known_false, is_hidden);
    std::erase_if(result->clauses, is_hidden);
    for (HiddenWorld& world : result->hidden) std::erase_if(world.literals, is_hidden);
    result->task = std::move(lifted);
    return result;
}

std::shared_ptr<const ContingentTask> grow(const ContingentTask& full, const Belief& belief,
                                           const std::vector<Detection>& found,
                                           std::vector<std::string>& refused) {
    auto result = std::make_shared<ContingentTask>(full);
    auto lifted = std::make_shared<LiftedTask>(*full.task);
    Present(*result, *lifted, belief).write();
    for (const Detection& detection : found) {
        const auto is_it = [&](ObjectId object) {
            return lifted->objects[object.index()].name == detection.object;
        };
        if (std::erase_if(result->hidden_objects, is_it) > 0) continue;
        if (!add_object(*lifted, detection)) refused.push_back(detection.object);
    }
    result->task = std::move(lifted);
    return result;
}

}  // namespace praxis::belief
