// What all checks share: the task being made, what names mean, and which features of the language were used.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/contingent.hpp"
#include "parser/reporter.hpp"
#include "parser/suggest.hpp"
#include "parser/syntax/tree.hpp"
#include "parser/task.hpp"

namespace praxis::check {

/// What a symbol means as a name of one kind.
template <class IdType>
class Lookup {
  public:
    explicit Lookup(std::size_t symbols) : ids_(symbols) {}
    IdType operator[](syntax::Symbol symbol) const { return ids_[syntax::index(symbol)]; }
    void set(syntax::Symbol symbol, IdType id) { ids_[syntax::index(symbol)] = id; }

  private:
    std::vector<IdType> ids_;
};

using VariableSlot = Id<struct VariableSlotTag>;

/// Features that a domain should announce in its :requirements.
enum class Feature : std::uint8_t {
    typing,
    equality,
    negative_preconditions,
    disjunctive_preconditions,
    existential_preconditions,
    universal_preconditions,
    conditional_effects,
    derived_predicates,
    action_costs,
    count
};

struct Context {
    Context(const syntax::SymbolTable& table, Reporter& errors, LiftedTask& target)
        : symbols(table),
          reporter(errors),
          task(target),
          types(table.size()),
          predicates(table.size()),
          functions(table.size()),
          objects(table.size()),
          schemas(table.size()),
          variables(table.size()),
          object_functions(table.size(), false) {}

    const syntax::SymbolTable& symbols;
    Reporter& reporter;
    LiftedTask& task;

    Lookup<TypeId> types;
    Lookup<PredicateId> predicates;
    Lookup<FunctionId> functions;
    Lookup<ObjectId> objects;
    Lookup<SchemaId> schemas;
    Lookup<VariableSlot> variables;      ///< of the scope that is being checked
    std::vector<bool> object_functions;  ///< by symbol: functions with objects as values

    std::vector<std::vector<TypeId>> either_members;  ///< by type; empty for declared types
    std::map<std::vector<TypeId>, TypeId> either_types;
    bool types_missing = false;  ///< an unknown type was reported; its users count as `object`
    bool types_by_use = false;   ///< a contingent domain without `:types`: types are declared by their use
    bool objects_known = false;  ///< from then on every type knows its objects

    std::array<std::optional<Location>, static_cast<std::size_t>(Feature::count)> features;
    std::size_t copied_formulas = 0;  ///< nodes of conditions copied into effects

    ContingentTask* contingent = nullptr;  ///< null: the task is classical
    std::vector<bool> readings;            ///< by predicate: an `:obs-variable` has its atoms

    void use(Feature feature, Location where) {
        auto& first = features[static_cast<std::size_t>(feature)];
        if (!first) first = where;
    }

    std::string text(syntax::Symbol symbol) const { return std::string(symbols.text(symbol)); }

    /// "unknown KIND 'NAME'", with the nearest of the named things as a hint.
    template <class Named>
    void report_unknown(std::string_view kind, const syntax::Tree& tree, const syntax::Name& name,
                        const std::vector<Named>& candidates) const {
        reporter.error(tree.where(name), "unknown " + std::string(kind) + " " + quote(tree.spelled(name)),
                       nearest(name, candidates).hint());
    }

    template <class Named>
    Suggestion nearest(const syntax::Name& name, const std::vector<Named>& candidates) const {
        Suggestion suggestion(symbols.text(name.symbol));
        if (!reporter.wants_hints()) return suggestion;
        for (const Named& candidate : candidates) suggestion.consider(candidate.name);
        return suggestion;
    }
};

}  // namespace praxis::check
