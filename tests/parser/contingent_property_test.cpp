// Random contingent tasks: what is written of a task reads back as the same task.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/parser/contingent_texts.hpp"

namespace praxis {
namespace {

std::size_t below(std::size_t limit) {
    return *rc::gen::inRange<std::size_t>(0, limit);
}

/// Writes random tasks over the types t0 and t1 (below t0), predicates p0 .. p3 with as many parameters as
/// their number says (at most two), and the variables that are visible.
class Author {
  public:
    std::string domain() {
        std::string text =
            "(define (domain d) (:types t0 - object t1 - t0 t2) (:constants k0 - t1 k1 - (either t1 t2))"
            "(:predicates (p0) (p1 ?x) (p2 ?x - object ?y) (p3 ?x) (d ?x)) (:functions (f ?x) (total-cost))"
            "(:derived (d ?x) " +
            scoped({"?x"}, [&] { return condition(2); }) + ")";
        for (const char* mark : {":open-world", ":observable", ":sticky"}) {
            if (below(2) == 0) text += std::string("(") + mark + " p" + std::to_string(below(4)) + " p1)";
        }
        if (below(2) == 0)
            text += "(:decay p" + std::to_string(below(4)) + ' ' + std::to_string(1 + below(9)) + ")";
        for (std::size_t i = below(3); i > 0; --i) {
            text += scoped({"?x"}, [&] {
                return (below(2) == 0 ? "(:variable (v" : "(:obs-variable (v") + std::to_string(i) +
                       " ?x - t0) " + value(2) + ")";
            });
        }
        for (std::size_t i = 0; i < 3; ++i) {
            text += "(:action a" + std::to_string(i) + " :parameters (?x ?y - t0)";
            text += scoped({"?x", "?y"}, [&] { return action_parts(); }) + ")";
        }
        for (std::size_t i = below(3); i > 0; --i) {
            text += "(:sensor s" + std::to_string(i) + " :parameters (?x - t1)";
            text += scoped({"?x"},
                           [&] {
                               return " :condition " + condition(2) + " :sense " + reading(1, true) +
                                      reading(1, true);
                           }) +
                    ")";
        }
        if (below(2) == 0) text += "(:default-sensing-model " + reading(2, false) + ")";
        return text + ")";
    }

    std::string problem() {
        std::string text =
            "(define (problem p) (:domain d) (:objects o0 o1 - t0 o2 - t1 o3) (:hidden-objects h - t1)"
            "(:init (= (f o0) 2.5) (= (total-cost) 0)";
        for (std::size_t i = below(8); i > 0; --i) text += ' ' + uncertain();
        text += ") (:goal " + condition(2) + ")";
        for (std::size_t i = below(3); i > 0; --i) text += "(:hidden" + literals(below(4)) + ")";
        if (below(2) == 0) text += "(:obs-variable (w o0 h)" + atoms(1 + below(3)) + ")";
        return text + "(:metric minimize (total-cost)))";
    }

  private:
    template <class Inside>
    std::string scoped(std::vector<std::string> names, Inside inside) {
        const std::vector<std::string> outer = visible_;
        visible_.insert(visible_.end(), names.begin(), names.end());
        std::string text = inside();
        visible_ = outer;
        return text;
    }

    std::string action_parts() {
        std::string text;
        if (below(3) > 0) text += " :precondition " + condition(3);
        if (below(3) > 0) {
            text += " :effect (and " + effect(3) + effect(3) +
                    (below(2) == 0 ? "(increase (total-cost) (+ 1 (f ?x)))" : "") + ")";
        }
        if (below(2) == 0) text += " :observe " + reading(2, true) + (below(2) == 0 ? reading(1, true) : "");
        if (below(2) == 0) text += " :sensing-model " + reading(3, false);
        return text;
    }

    std::string term() {
        static const char* const kConstants[] = {"k0", "k1"};
        if (visible_.empty() || below(4) == 0) return kConstants[below(2)];
        return visible_[below(visible_.size())];
    }

    std::string atom() {
        switch (below(4)) {
            case 0:
                return "(p0)";
            case 1:
                return "(p1 " + term() + ")";
            case 2:
                return "(p2 " + term() + ' ' + term() + ")";
            default:
                return "(p3 " + term() + ")";
        }
    }

    /// A name that may be in use further out.
    static std::string fresh() { return "?" + std::string(1, "xyz"[below(3)]); }

    template <class Inside>
    std::string quantified(const char* head, Inside inside) {
        const std::string name = fresh();
        return "(" + std::string(head) + " (" + name + (below(2) == 0 ? " - t0) " : " - (either t1 t2)) ") +
               scoped({name}, inside) + ")";
    }

    std::string condition(std::size_t depth) {
        if (depth == 0) return below(4) == 0 ? "(= " + term() + ' ' + term() + ")" : atom();
        const auto inner = [&] { return condition(depth - 1); };
        switch (below(7)) {
            case 0:
                return "(and " + inner() + inner() + ")";
            case 1:
                return "(or " + inner() + inner() + ")";
            case 2:
                return "(not " + inner() + ")";
            case 3:
                return "(imply " + inner() + inner() + ")";
            case 4:
                return quantified("forall", inner);
            case 5:
                return quantified("exists", inner);
            default:
                return below(2) == 0 ? "(and)" : "(or)";
        }
    }

    std::string effect(std::size_t depth) {
        if (depth == 0) {
            const std::size_t kind = below(3);
            return kind == 0 ? atom() : (kind == 1 ? "(not " : "(unknown ") + atom() + ")";
        }
        const auto inner = [&] { return effect(depth - 1); };
        switch (below(3)) {
            case 0:
                return "(and " + inner() + inner() + ")";
            case 1:
                return quantified("forall", inner);
            default:
                return "(when " + condition(1) + inner() + ")";
        }
    }

    /// What an observation, a sensor or (not `observation`) a sensing model says.
    std::string reading(std::size_t depth, bool observation) {
        if (depth == 0) {
            if (observation && below(3) == 0)
                return "(probabilistic 0." + std::to_string(1 + below(999)) + atom() + ")";
            return below(3) == 0 ? "(not " + atom() + ")" : atom();
        }
        const auto inner = [&] { return reading(depth - 1, observation); };
        switch (below(3)) {
            case 0:
                return "(and " + inner() + inner() + ")";
            case 1:
                return quantified("forall", inner);
            default:
                return "(when " + condition(1) + inner() + ")";
        }
    }

    /// A value of a variable; its condition is static.
    std::string value(std::size_t depth) {
        if (depth == 0) return atom();
        const auto inner = [&] { return value(depth - 1); };
        switch (below(3)) {
            case 0:
                return inner() + inner();
            case 1:
                return quantified("forall", [&] { return value(0); });
            default:
                return "(when (or (= " + term() + ' ' + term() + ") (not (= " + term() + " k0)))" + value(0) +
                       ")";
        }
    }

    std::string ground_atom() {
        static const std::vector<std::string> kObjects = {"o0", "o1", "o2", "o3", "h", "k0", "k1"};
        const std::vector<std::string> outer = std::exchange(visible_, kObjects);
        std::string text = atom();
        visible_ = outer;
        return text;
    }

    std::string atoms(std::size_t count) {
        std::string text;
        for (; count > 0; --count) text += ' ' + ground_atom();
        return text;
    }

    std::string literals(std::size_t count) {
        std::string text;
        for (; count > 0; --count)
            text += below(3) == 0 ? "(not " + ground_atom() + ")" : ' ' + ground_atom();
        return text;
    }

    std::string uncertain() {
        static const char* const kClauses[] = {"oneof",       "or",          "invariant",
                                               "at-most-one", "exactly-one", "at-least-one"};
        const std::size_t kind = below(8);
        if (kind < 6) return std::string("(") + kClauses[kind] + literals(1 + below(3)) + ")";
        return kind == 6 ? "(unknown" + literals(1) + ")" : ground_atom();
    }

    std::vector<std::string> visible_;
};

RC_GTEST_PROP(ContingentProperties, WhatIsWrittenReadsBackAsTheSame, ()) {
    Author author;
    const std::string domain = author.domain();
    const std::string problem = author.problem();
    RC_LOG() << domain << '\n' << problem << '\n';
    const ContingentLoadResult first = test::parse_belief(domain, problem);
    const std::string domain_text = write_contingent_domain(*first.task);
    const std::string problem_text = write_contingent_problem(*first.task);
    RC_LOG() << domain_text << '\n' << problem_text << '\n';
    const ContingentLoadResult second = test::parse_belief(domain_text, problem_text);
    RC_ASSERT(test::dump(*first.task) == test::dump(*second.task));
    RC_ASSERT(write_contingent_domain(*second.task) == domain_text);
    RC_ASSERT(write_contingent_problem(*second.task) == problem_text);
}

RC_GTEST_PROP(ContingentProperties, DamagedTextIsATaskOrAnInputError, ()) {
    Author author;
    std::string texts[] = {author.domain(), author.problem()};
    std::string& text = texts[below(2)];
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
    const std::string error = test::belief_error(texts[0], texts[1]);
    RC_ASSERT(error.empty() || error.ends_with('\n'));
}

}  // namespace
}  // namespace praxis
