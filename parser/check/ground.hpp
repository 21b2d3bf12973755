// Arguments of ground atoms and ground function values: the fast way for what is right.
#pragma once

#include <string_view>
#include <vector>

#include "parser/check/scope.hpp"

namespace praxis::check {

class GroundArguments {
  public:
    GroundArguments(Context& context, const syntax::Tree& tree)
        : context_(context), tree_(tree), scope_(context, tree, no_variables_) {}

    /// Looks up the objects of a node of kind atom or word. A mistake is reported and gives false.
    bool resolve(const syntax::Node& node, std::string_view kind, const std::vector<TypeId>& parameters) {
        tuple_.clear();
        const std::size_t given = node.arguments.end - node.arguments.begin;
        bool right = given == parameters.size();
        for (std::size_t i = 0; right && i < given; ++i) {
            const ObjectId object = context_.objects[tree_.names[node.arguments.begin + i].symbol];
            right = object.valid() && context_.task.types[parameters[i].index()].contains[object.index()];
            tuple_.push_back(object);
        }
        if (!right) report(node, kind, parameters);
        return right;
    }

    /// What resolve found.
    const std::vector<ObjectId>& tuple() const { return tuple_; }

  private:
    void report(const syntax::Node& node, std::string_view kind, const std::vector<TypeId>& parameters);

    Context& context_;
    const syntax::Tree& tree_;
    Scope no_variables_;
    ScopeBuilder scope_;
    std::vector<ObjectId> tuple_;
};

}  // namespace praxis::check
