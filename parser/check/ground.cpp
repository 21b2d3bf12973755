#include "parser/check/ground.hpp"

#include "parser/check/atoms.hpp"

namespace praxis::check {

void GroundArguments::report(const syntax::Node& node, std::string_view kind,
                             const std::vector<TypeId>& parameters) {
    resolve_arguments(scope_, node, kind, parameters);
}

}  // namespace praxis::check
