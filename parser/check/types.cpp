#include "parser/check/types.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace praxis::check {
namespace {

const TypeId kObject{0};

TypeId add_type(Context& context, std::string name, Location where) {
    context.task.types.push_back({std::move(name), {}, {}, {}, where});
    context.either_members.emplace_back();
    return TypeId(context.task.types.size() - 1);
}

void add_parent(Type& type, TypeId parent) {
    if (std::find(type.parents.begin(), type.parents.end(), parent) == type.parents.end()) {
        type.parents.push_back(parent);
    }
}

TypeId find_or_declare_supertype(Context& context, const syntax::Tree& tree, const syntax::Name& name) {
    TypeId id = context.types[name.symbol];
    if (id.valid()) return id;
    const Suggestion suggestion = context.nearest(name, context.task.types);
    context.reporter.warning(tree.where(name),
                             "type " + quote(tree.spelled(name)) + " is used but not declared",
                             suggestion.found() ? suggestion.hint() : "taken as a subtype of 'object'");
    id = add_type(context, context.text(name.symbol), tree.where(name));
    context.task.types[id.index()].parents.push_back(kObject);
    context.types.set(name.symbol, id);
    return id;
}

/// Contingent benchmarks use types without declaring them. A name that looks like a declared one is a
/// mistake.
bool is_declared_by_use(const Context& context, const syntax::Name& name) {
    if (context.contingent == nullptr) return false;
    return context.types_by_use || !context.nearest(name, context.task.types).found();
}

TypeId declare_by_use(Context& context, const syntax::Tree& tree, const syntax::Name& name) {
    context.reporter.warning(tree.where(name),
                             "type " + quote(tree.spelled(name)) + " is used but not declared",
                             "taken as a subtype of 'object'");
    const TypeId id = add_type(context, context.text(name.symbol), tree.where(name));
    Type& type = context.task.types[id.index()];
    type.parents.push_back(kObject);
    type.contains.assign(context.task.objects.size(), false);
    context.types.set(name.symbol, id);
    return id;
}

void break_cycles(Context& context) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    std::vector<Type>& types = context.task.types;
    Graph graph(types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        for (const TypeId parent : types[i].parents) boost::add_edge(i, parent.index(), graph);
    }
    std::vector<std::size_t> component(types.size());
    const std::size_t count = boost::strong_components(
        graph, boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
    std::vector<std::vector<std::size_t>> members(count);
    for (std::size_t i = 0; i < types.size(); ++i) members[component[i]].push_back(i);
    for (const std::vector<std::size_t>& cycle : members) {
        const Type& first = types[cycle.front()];
        const bool self = std::find(first.parents.begin(), first.parents.end(), TypeId(cycle.front())) !=
                          first.parents.end();
        if (cycle.size() == 1 && !self) continue;
        std::string names;
        for (const std::size_t member : cycle)
            names += (names.empty() ? "" : ", ") + quote(types[member].name);
        context.reporter.error(
            first.where,
            "cyclic types: " + names +
                (self && cycle.size() == 1 ? " is its own supertype" : " are supertypes of each other"));
        for (const std::size_t member : cycle) types[member].parents = {kObject};
    }
}

/// Calls visit(TypeId) once for `type` and each of its supertypes, as declared.
template <class Visit>
void for_each_supertype(const Context& context, TypeId type, Visit visit) {
    std::vector<TypeId> reached{type};
    for (std::size_t next = 0; next < reached.size(); ++next) {
        visit(reached[next]);
        for (const TypeId parent : context.task.types[reached[next].index()].parents) {
            if (std::find(reached.begin(), reached.end(), parent) == reached.end()) reached.push_back(parent);
        }
    }
}

bool is_declared_subtype(const Context& context, TypeId a, TypeId b) {
    if (a == b || b == kObject) return true;
    bool found = false;
    for_each_supertype(context, a, [&](TypeId type) { found = found || type == b; });
    return found;
}

void collect_either(Context& context, TypeId id) {
    Type& type = context.task.types[id.index()];
    type.contains.resize(context.task.objects.size(), false);
    for (const TypeId member : context.either_members[id.index()]) {
        for (const ObjectId object : context.task.types[member.index()].objects)
            type.contains[object.index()] = true;
    }
    type.objects.clear();
    for (std::size_t i = 0; i < type.contains.size(); ++i) {
        if (type.contains[i]) type.objects.emplace_back(i);
    }
}

/// The most special types that contain all members.
std::vector<TypeId> common_parents(const Context& context, const std::vector<TypeId>& members) {
    std::vector<TypeId> common;
    for_each_supertype(context, members.front(), [&](TypeId type) {
        const bool contains_all = std::all_of(members.begin(), members.end(), [&](TypeId member) {
            return is_declared_subtype(context, member, type);
        });
        if (contains_all) common.push_back(type);
    });
    std::vector<TypeId> parents;
    for (const TypeId type : common) {
        const bool special = std::none_of(common.begin(), common.end(), [&](TypeId other) {
            return other != type && is_declared_subtype(context, other, type);
        });
        if (special) parents.push_back(type);
    }
    return parents;
}

TypeId either_type(Context& context, std::vector<TypeId> members, Location where) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    std::vector<TypeId> kept;
    for (const TypeId member : members) {
        const bool covered = std::any_of(members.begin(), members.end(), [&](TypeId other) {
            return other != member && is_declared_subtype(context, member, other);
        });
        if (!covered) kept.push_back(member);
    }
    if (kept.size() == 1) return kept.front();
    if (const auto known = context.either_types.find(kept); known != context.either_types.end())
        return known->second;
    std::string name = "(either";
    for (const TypeId member : kept) name += ' ' + context.task.types[member.index()].name;
    std::vector<TypeId> parents = common_parents(context, kept);
    const TypeId id = add_type(context, name + ')', where);
    context.task.types[id.index()].parents = std::move(parents);
    context.either_members[id.index()] = kept;
    context.either_types.emplace(std::move(kept), id);
    if (context.objects_known) collect_either(context, id);
    return id;
}

void redeclare_object(Context& context, const syntax::Tree& tree, const syntax::Name& name, TypeId type) {
    Object& object = context.task.objects[context.objects[name.symbol].index()];
    const std::string spelled = quote(tree.spelled(name));
    if (object.where.file == tree.file) {
        context.reporter.error(tree.where(name), "duplicate object " + spelled);
    } else if (is_subtype(context, type, object.type)) {
        object.type = type;
        context.reporter.warning(tree.where(name),
                                 "object " + spelled + " is a constant of the domain already");
    } else if (is_subtype(context, object.type, type)) {
        context.reporter.warning(tree.where(name),
                                 "object " + spelled + " is a constant of the domain already");
    } else {
        context.reporter.error(tree.where(name),
                               "object " + spelled + " is a constant of another type in the domain",
                               "there it is of type " + quote(context.task.types[object.type.index()].name));
    }
}

}  // namespace

void declare_types(Context& context, const syntax::Tree& domain) {
    add_type(context, "object", {});
    context.types.set(syntax::symbol_of(syntax::Word::object), kObject);
    for (const syntax::Range section : domain.types) {
        for (std::uint32_t i = section.begin; i < section.end; ++i) {
            const syntax::Name& name = domain.typed_names[i].name;
            context.use(Feature::typing, domain.where(name));
            if (name.symbol == syntax::Word::object) continue;
            if (context.types[name.symbol].valid()) {
                context.reporter.warning(domain.where(name), "duplicate type " + quote(domain.spelled(name)),
                                         "all its supertypes count");
                continue;
            }
            context.types.set(name.symbol, add_type(context, context.text(name.symbol), domain.where(name)));
        }
    }
    for (const syntax::Range section : domain.types) {
        for (std::uint32_t i = section.begin; i < section.end; ++i) {
            const syntax::TypedName& item = domain.typed_names[i];
            const TypeId id = context.types[item.name.symbol];
            if (id == kObject) continue;
            for (std::uint32_t j = item.types.begin; j < item.types.end; ++j) {
                const TypeId parent = find_or_declare_supertype(context, domain, domain.names[j]);
                add_parent(context.task.types[id.index()], parent);
            }
        }
    }
    for (std::size_t i = 1; i < context.task.types.size(); ++i) {
        std::vector<TypeId>& parents = context.task.types[i].parents;
        if (parents.size() > 1) std::erase(parents, kObject);
        if (parents.empty()) parents.push_back(kObject);
    }
    break_cycles(context);
}

void declare_objects(Context& context, const syntax::Tree& tree, const std::vector<syntax::Range>& sections) {
    for (const syntax::Range section : sections) {
        std::uint32_t types_begin = 0;
        TypeId type;
        for (std::uint32_t i = section.begin; i < section.end; ++i) {
            const syntax::TypedName& item = tree.typed_names[i];
            if (!type.valid() || item.types.begin != types_begin || item.types.empty()) {
                type = resolve_type(context, tree, item.types);
                types_begin = item.types.begin;
            }
            if (context.objects[item.name.symbol].valid()) {
                redeclare_object(context, tree, item.name, type);
                continue;
            }
            context.objects.set(item.name.symbol, ObjectId(context.task.objects.size()));
            context.task.objects.push_back({context.text(item.name.symbol), type, tree.where(item.name)});
        }
    }
}

void collect_objects(Context& context) {
    std::vector<Type>& types = context.task.types;
    for (Type& type : types) type.contains.assign(context.task.objects.size(), false);
    std::vector<std::vector<TypeId>> supertypes(types.size());
    for (std::size_t i = 0; i < context.task.objects.size(); ++i) {
        const TypeId own = context.task.objects[i].type;
        std::vector<TypeId>& above = supertypes[own.index()];
        if (above.empty()) {
            for_each_supertype(context, own, [&](TypeId type) { above.push_back(type); });
            for (const TypeId member : context.either_members[own.index()]) {
                for_each_supertype(context, member, [&](TypeId type) { above.push_back(type); });
            }
            std::sort(above.begin(), above.end());
            above.erase(std::unique(above.begin(), above.end()), above.end());
        }
        for (const TypeId type : above) {
            types[type.index()].objects.emplace_back(i);
            types[type.index()].contains[i] = true;
        }
    }
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (!context.either_members[i].empty()) collect_either(context, TypeId(i));
    }
    context.objects_known = true;
}

TypeId resolve_type(Context& context, const syntax::Tree& tree, syntax::Range names) {
    if (names.empty()) return kObject;
    std::vector<TypeId> members;
    for (std::uint32_t i = names.begin; i < names.end; ++i) {
        const syntax::Name& name = tree.names[i];
        context.use(Feature::typing, tree.where(name));
        const TypeId id = context.types[name.symbol];
        if (id.valid()) {
            members.push_back(id);
        } else if (is_declared_by_use(context, name)) {
            members.push_back(declare_by_use(context, tree, name));
        } else {
            context.types_missing = true;
            context.report_unknown("type", tree, name, context.task.types);
        }
    }
    if (members.empty()) return kObject;
    return either_type(context, std::move(members), tree.where(tree.names[names.begin]));
}

bool is_subtype(const Context& context, TypeId a, TypeId b) {
    if (a == b || b == kObject) return true;
    const std::vector<TypeId>& parts = context.either_members[a.index()];
    if (!parts.empty()) {
        return std::all_of(parts.begin(), parts.end(),
                           [&](TypeId part) { return is_subtype(context, part, b); });
    }
    const std::vector<TypeId>& members = context.either_members[b.index()];
    if (members.empty()) return is_declared_subtype(context, a, b);
    return std::any_of(members.begin(), members.end(),
                       [&](TypeId member) { return is_declared_subtype(context, a, member); });
}

bool overlap(const Context& context, TypeId a, TypeId b) {
    const Type& left = context.task.types[a.index()];
    const Type& right = context.task.types[b.index()];
    const Type& fewer = left.objects.size() < right.objects.size() ? left : right;
    const Type& more = &fewer == &left ? right : left;
    return std::any_of(fewer.objects.begin(), fewer.objects.end(),
                       [&](ObjectId object) { return more.contains[object.index()]; });
}

}  // namespace praxis::check
