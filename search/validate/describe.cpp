#include "search/validate/describe.hpp"

#include <algorithm>

namespace praxis::validation {

namespace {

constexpr std::size_t kLongest = 240;

class Writer {
  public:
    Writer(const Scope& scope, const LiftedTask& task, const Binding& binding)
        : scope_(scope), task_(task), binding_(binding) {}

    void write(const Formula& formula) {
        if (text_.size() > kLongest) return;
        switch (formula.kind) {
            case Connective::truth:
                return put("(and)");
            case Connective::falsity:
                return put("(or)");
            case Connective::atom:
                return list(task_.predicates[formula.predicate.index()].name, formula);
            case Connective::equality:
                return list("=", formula);
            case Connective::negation:
                return list("not", formula);
            case Connective::conjunction:
                return list("and", formula);
            case Connective::disjunction:
                return list("or", formula);
            case Connective::implication:
                return list("imply", formula);
            case Connective::existential:
                return list("exists", formula);
            case Connective::universal:
                return list("forall", formula);
        }
    }

    std::string take() {
        if (text_.size() > kLongest) text_.replace(kLongest, std::string::npos, "...");
        return std::move(text_);
    }

  private:
    void put(const std::string& text) { text_ += text; }

    void list(const std::string& head, const Formula& formula) {
        put("(" + head);
        if (!formula.variables.empty()) variables(formula.variables);
        for (const Term term : formula.terms) {
            if (text_.size() > kLongest) return;
            put(" " + name(term));
        }
        for (const Formula& child : formula.children) {
            if (text_.size() > kLongest) return;
            put(" ");
            write(child);
        }
        put(")");
    }

    void variables(const std::vector<std::uint32_t>& bound) {
        put(" (");
        for (std::size_t i = 0; i < bound.size() && text_.size() <= kLongest; ++i) {
            const Type& type = task_.types[scope_.variable_types[bound[i]].index()];
            put((i == 0 ? "" : " ") + scope_.variable_names[bound[i]] + " - " + type.name);
        }
        put(")");
    }

    std::string name(Term term) const {
        if (!term.is_variable()) return task_.objects[term.object_id().index()].name;
        const ObjectId object = binding_(term.variable_index());
        return object.valid() ? task_.objects[object.index()].name
                              : scope_.variable_names[term.variable_index()];
    }

    const Scope& scope_;
    const LiftedTask& task_;
    const Binding& binding_;
    std::string text_;
};

}  // namespace

std::string describe(const Formula& formula, const Scope& scope, const LiftedTask& task,
                     const Binding& binding) {
    Writer writer(scope, task, binding);
    writer.write(formula);
    return writer.take();
}

std::string describe(const Location& where, const LiftedTask& task) {
    if (!task.sources || where.file >= task.sources->files.size()) return "";
    const Source& source = task.sources->files[where.file];
    const std::size_t offset = std::min<std::size_t>(where.offset, source.text.size());
    const std::string_view before(source.text.data(), offset);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t start = before.rfind('\n');
    const std::size_t column = offset - (start == std::string_view::npos ? 0 : start + 1) + 1;
    return " (" + source.name + ":" + std::to_string(line) + ":" + std::to_string(column) + ")";
}

std::string describe(const std::string& name, std::span<const ObjectId> arguments, const LiftedTask& task) {
    std::string text = "(" + name;
    for (const ObjectId object : arguments) {
        text += " ";
        text += object.index() < task.objects.size() ? task.objects[object.index()].name : "?";
    }
    return text + ")";
}

}  // namespace praxis::validation
