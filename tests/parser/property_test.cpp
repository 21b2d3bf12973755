// Properties over random tasks: how a task is written does not change what it says.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/parser/texts.hpp"

namespace praxis {
namespace {

using Lines = std::vector<std::string>;

std::string numbered(const char* prefix, std::size_t number) {
    return prefix + std::to_string(number);
}

std::size_t below(std::size_t limit) {
    return *rc::gen::inRange<std::size_t>(0, limit);
}

/// A random task as sections of canonical text.
struct RandomTask {
    Lines domain_sections;
    Lines problem_sections;
};

class Author {
  public:
    RandomTask write() {
        RandomTask task;
        types_ = 1 + below(4);
        std::string types = "(:types";
        for (std::size_t i = 0; i < types_; ++i) {
            types += ' ' + numbered("t", i) + " - " + (i == 0 ? "object" : numbered("t", below(i)));
        }
        std::string predicates = "(:predicates";
        for (std::size_t i = 0; i < 3; ++i) {
            arities_.push_back(below(3));
            predicates += " (" + numbered("p", i);
            for (std::size_t j = 0; j < arities_.back(); ++j)
                predicates += ' ' + numbered("?x", j) + " - object";
            predicates += ')';
        }
        task.domain_sections = {types + ')', predicates + ')', "(:functions (total-cost) - number)"};
        for (std::size_t i = 0; i < 3; ++i) {
            task.domain_sections.push_back("(:action " + numbered("a", i) +
                                           " :parameters (?x0 - t0 ?x1 - object)" + " :precondition " +
                                           condition(3) + " :effect (and " + effect(2) +
                                           " (increase (total-cost) " + std::to_string(below(100)) + ".5)))");
        }
        std::string objects = "(:objects";
        for (std::size_t i = 0; i < kObjects; ++i) {
            objects += ' ' + numbered("o", i) + " - " + numbered("t", below(types_));
        }
        std::string init = "(:init (= (total-cost) 0)";
        ground_ = true;
        for (std::size_t i = 0; i < 10; ++i) init += ' ' + atom();
        const std::string goal = "(:goal " + condition(2) + ')';
        task.problem_sections = {"(:domain d)", objects + ')', init + ')', goal,
                                 "(:metric minimize (total-cost))"};
        return task;
    }

  private:
    static constexpr std::size_t kObjects = 4;

    std::string atom() {
        const std::size_t predicate = below(arities_.size());
        std::string text = "(" + numbered("p", predicate);
        for (std::size_t i = 0; i < arities_[predicate]; ++i) {
            text += ground_ || below(3) == 0 ? ' ' + numbered("o", below(kObjects))
                                             : ' ' + numbered("?x", below(2));
        }
        return text + ')';
    }

    std::string condition(std::size_t depth) {
        if (depth == 0) return atom();
        switch (below(7)) {
            case 0:
                return "(and " + condition(depth - 1) + ' ' + condition(depth - 1) + ')';
            case 1:
                return "(or " + condition(depth - 1) + ' ' + atom() + ')';
            case 2:
                return "(not " + condition(depth - 1) + ')';
            case 3:
                return "(imply " + condition(depth - 1) + ' ' + atom() + ')';
            case 4:
                return "(forall (?y - t0) " + condition(depth - 1) + ')';
            case 5:
                return "(exists (?y - object ?z - t0) " + condition(depth - 1) + ')';
            default:
                return "(and)";
        }
    }

    std::string effect(std::size_t depth) {
        if (depth == 0) return below(2) == 0 ? atom() : "(not " + atom() + ')';
        switch (below(3)) {
            case 0:
                return "(and " + effect(depth - 1) + ' ' + effect(depth - 1) + ')';
            case 1:
                return "(forall (?y - t0) " + effect(depth - 1) + ')';
            default:
                return "(when " + condition(1) + ' ' + effect(depth - 1) + ')';
        }
    }

    std::size_t types_ = 0;
    std::vector<std::size_t> arities_;
    bool ground_ = false;
};

/// The same text in other letters, other white space and with comments.
std::string disguised(const std::string& text) {
    static const Lines kGaps = {" ", "\t", "\n", "\r\n", "  ; (not \"this\n", " ;\n\n"};
    std::string result;
    for (const char c : text) {
        if (c == ' ') {
            result += kGaps[below(kGaps.size())];
        } else if (c == '(' || c == ')') {
            if (below(4) == 0) result += kGaps[below(kGaps.size())];
            result += c;
        } else {
            result += below(3) == 0 ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        }
    }
    return result;
}

std::string joined(const std::string& head, const Lines& sections) {
    std::string text = "(define (" + head + ") ";
    for (const std::string& section : sections) text += section + ' ';
    return text + ')';
}

/// A task as text in terms of names, without places.
class Printer {
  public:
    explicit Printer(const LiftedTask& task) : task_(task) {}

    std::string print() {
        Lines lines;
        for (const Type& type : task_.types) {
            std::string line = "type " + type.name;
            for (const ObjectId object : type.objects) line += ' ' + task_.objects[object.index()].name;
            lines.push_back(line);
        }
        for (std::size_t i = 0; i < task_.predicates.size(); ++i) {
            const Predicate& predicate = task_.predicates[i];
            const Relation& relation = task_.initial_atoms[i];
            std::string line = "predicate " + predicate.name + (predicate.fluent ? " fluent" : " static");
            for (std::size_t j = 0; j < relation.count; ++j) {
                line += '/';
                for (const ObjectId object : relation.tuple(j))
                    line += ' ' + task_.objects[object.index()].name;
            }
            lines.push_back(line);
        }
        for (const Schema& schema : task_.schemas) {
            std::string line = "action " + schema.name + formula(schema.precondition);
            for (const Effect& effect : schema.effects) {
                line += effect.add ? " add " : " delete ";
                for (const std::uint32_t variable : effect.variables) line += std::to_string(variable) + ',';
                line += formula(effect.condition) + atom(effect.predicate, effect.terms);
            }
            lines.push_back(line + " cost " + schema.cost->value.to_string());
        }
        std::sort(lines.begin(), lines.end());
        std::string text = formula(task_.goal) + (task_.minimize_cost ? " minimize\n" : "\n");
        for (const std::string& line : lines) text += line + '\n';
        return text;
    }

  private:
    std::string atom(PredicateId predicate, const std::vector<Term>& terms) const {
        std::string text = task_.predicates[predicate.index()].name + '[';
        for (const Term term : terms) {
            text += term.is_variable() ? std::to_string(term.variable_index()) + ' '
                                       : task_.objects[term.object_id().index()].name + ' ';
        }
        return text + ']';
    }

    std::string formula(const Formula& formula_node) const {
        std::string text = " (" + std::to_string(static_cast<int>(formula_node.kind));
        if (formula_node.kind == Connective::atom) text += atom(formula_node.predicate, formula_node.terms);
        for (const std::uint32_t variable : formula_node.variables) text += " v" + std::to_string(variable);
        for (const Formula& child : formula_node.children) text += formula(child);
        return text + ')';
    }

    const LiftedTask& task_;
};

RC_GTEST_PROP(ParserProperties, SpellingAndOrderDoNotMatter, ()) {
    const RandomTask task = Author().write();
    const std::string plain_domain = joined("domain d", task.domain_sections);
    const std::string plain_problem = joined("problem p", task.problem_sections);
    const LoadResult plain = test::parse(plain_domain, plain_problem);
    Lines domain_sections = task.domain_sections;
    Lines problem_sections = task.problem_sections;
    for (Lines* sections : {&domain_sections, &problem_sections}) {
        for (std::size_t i = sections->size(); i > 1; --i)
            std::swap((*sections)[i - 1], (*sections)[below(i)]);
    }
    const LoadResult other = test::parse(disguised(joined("domain d", domain_sections)),
                                         disguised(joined("problem p", problem_sections)));
    RC_ASSERT(Printer(*plain.task).print() == Printer(*other.task).print());
}

RC_GTEST_PROP(ParserProperties, DamagedTextIsATaskOrAnInputError, ()) {
    const RandomTask task = Author().write();
    std::string text = joined("domain d", task.domain_sections);
    for (std::size_t i = 1 + below(3); i > 0; --i) {
        const std::size_t at = below(text.size());
        switch (below(3)) {
            case 0:
                text.erase(at, 1 + below(4));
                break;
            case 1:
                text.insert(at, 1, "() ;?:-=\n\0x"[below(10)]);
                break;
            default:
                std::swap(text[at], text[below(text.size())]);
                break;
        }
    }
    const std::string error = test::error_of(text, joined("problem p", task.problem_sections));
    RC_ASSERT(error.empty() || error.ends_with('\n'));
}

}  // namespace
}  // namespace praxis
