// The variables of one action, axiom or goal while it is checked.
#pragma once

#include <utility>
#include <vector>

#include "parser/check/context.hpp"

namespace praxis::check {

/// Numbers variables as they come and knows which are visible. One at a time may exist for a context.
class ScopeBuilder {
  public:
    ScopeBuilder(Context& context, const syntax::Tree& tree, Scope& scope)
        : context_(context), tree_(tree), scope_(scope) {}
    ~ScopeBuilder() { unbind(0); }
    ScopeBuilder(const ScopeBuilder&) = delete;
    ScopeBuilder& operator=(const ScopeBuilder&) = delete;

    /// Parameters come first; a type of `fallback` stands in where none is written.
    void bind_parameters(syntax::Range variables, const std::vector<TypeId>* fallback = nullptr);

    /// Makes the variables of a quantifier visible; returns their numbers.
    std::vector<std::uint32_t> bind_quantified(syntax::Range variables);

    /// Hides all but the first `visible` variables again.
    std::size_t visible() const { return bound_.size(); }
    void unbind(std::size_t visible);

    /// The object or variable that a word stands for; a mistake is reported.
    std::optional<Term> resolve(const syntax::Name& word);

    TypeId type_of(Term term) const {
        return term.is_variable() ? scope_.variable_types[term.variable_index()]
                                  : context_.task.objects[term.object_id().index()].type;
    }

    Context& context() { return context_; }
    const syntax::Tree& tree() const { return tree_; }

  private:
    void bind(const syntax::TypedName& variable, TypeId type);
    void report_unbound(const syntax::Name& word);
    void report_unknown_object(const syntax::Name& word);

    Context& context_;
    const syntax::Tree& tree_;
    Scope& scope_;
    std::vector<std::pair<syntax::Name, VariableSlot>> bound_;  ///< and what the name stood for before
};

}  // namespace praxis::check
