#include "tests/search/ground/moving_task.hpp"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace praxis::test {

namespace {

struct Variable {
    std::string name;
    std::string type;
};
using Variables = std::vector<Variable>;

struct PredicateShape {
    std::string name;
    std::vector<std::string> types;
};

class Maker {
  public:
    explicit Maker(std::uint32_t seed) : random_(seed) {}

    MovingTask make() {
        make_objects();
        MovingTask made;
        made.domain = domain();
        made.problem = problem();
        made.task = parse_task({"domain.pddl", made.domain}, {"problem.pddl", made.problem}).task;
        return made;
    }

  private:
    std::size_t below(std::size_t n) { return random_() % n; }
    bool chance(unsigned percent) { return random_() % 100 < percent; }
    template <class T>
    const T& any(const std::vector<T>& items) {
        return items[below(items.size())];
    }

    void make_objects() {
        const std::size_t things = 1 + below(3);
        for (std::size_t i = 0; i < things; ++i) things_.push_back({"x" + std::to_string(i), "thing"});
        const std::size_t places = 2 + below(2);
        for (std::size_t i = 0; i < places; ++i) places_.push_back({"p" + std::to_string(i), "place"});
        cart_ = chance(40);
        if (cart_) things_.back().type = "cart";
        if (chance(20)) places_.back().type = "dock";
        constants_ = chance(30);
        costs_ = chance(50);
        derived_ = chance(50);
        messy_ = chance(50);
    }

    static bool fits(const std::string& type, const std::string& wanted) {
        if (wanted == "object" || type == wanted) return true;
        if (wanted == "(either thing dock)") return type == "thing" || type == "cart" || type == "dock";
        return (type == "cart" && wanted == "thing") || (type == "dock" && wanted == "place");
    }

    std::string term(const std::string& type, const Variables& scope) {
        std::vector<std::string> possible;
        for (const Variable& variable : scope)
            if (fits(variable.type, type)) possible.push_back(variable.name);
        if (constants_ && (possible.empty() || chance(15))) {
            for (const auto* objects : {&things_, &places_})
                for (const Variable& object : *objects)
                    if (fits(object.type, type)) possible.push_back(object.name);
        }
        return possible.empty() ? std::string() : any(possible);
    }

    /// An atom over the scope, or "" if nothing in it fits.
    std::string atom(const PredicateShape& predicate, const Variables& scope) {
        std::string text = "(" + predicate.name;
        for (const std::string& type : predicate.types) {
            const std::string argument = term(type, scope);
            if (argument.empty()) return "";
            text += " " + argument;
        }
        return text + ")";
    }

    std::string some_atom(const std::vector<PredicateShape>& predicates, const Variables& scope) {
        for (int tries = 0; tries < 10; ++tries) {
            std::string text = atom(any(predicates), scope);
            if (!text.empty()) return text;
        }
        return "(flag)";
    }

    std::string literal(const std::vector<PredicateShape>& predicates, const Variables& scope) {
        const std::string text = some_atom(predicates, scope);
        return chance(35) ? "(not " + text + ")" : text;
    }

    std::string formula(int depth, const Variables& scope) {
        const std::size_t kind = depth == 0 ? 0 : below(9);
        switch (kind) {
            case 3:
                return "(and " + formula(depth - 1, scope) + " " + formula(depth - 1, scope) + ")";
            case 4:
            case 5:
                return "(or " + formula(depth - 1, scope) + " " + formula(depth - 1, scope) + ")";
            case 6:
                return "(imply " + formula(depth - 1, scope) + " " + formula(depth - 1, scope) + ")";
            case 7:
                return "(not " + formula(depth - 1, scope) + ")";
            case 8:
                return quantified(depth, scope);
            case 2: {
                const std::string type = chance(50) ? "thing" : "place";
                const std::string a = term(type, scope), b = term(type, scope);
                if (!a.empty()) return "(= " + a + " " + b + ")";
                [[fallthrough]];
            }
            default:
                return literal(usable_, scope);
        }
    }

    std::string quantified(int depth, const Variables& scope) {
        static const std::vector<std::string> types = {"thing", "place", "dock", "(either thing dock)"};
        Variables inner = scope;
        inner.push_back({"?q" + std::to_string(scope.size()), any(types)});
        return std::string(chance(50) ? "(exists (" : "(forall (") + inner.back().name + " - " +
               inner.back().type + ") " + formula(depth - 1, inner) + ")";
    }

    /// In messy tasks, leaves a part out now and then, so that things are not always where they seem.
    std::string often(const std::string& text) { return messy_ && chance(15) ? std::string() : text; }

    std::string extra_condition(const Variables& scope) {
        std::string text;
        for (std::size_t i = below(3); i > 0; --i) text += " " + formula(2, scope);
        return text;
    }

    std::string extra_effect(const Variables& scope) {
        if (chance(45)) return "";
        Variables inner = scope;
        std::string text;
        const bool universal = chance(35);
        if (universal) inner.push_back({"?e", chance(50) ? "thing" : "place"});
        text = literal(messy_ ? fluents_ : marks_, inner);
        if (chance(60)) text = "(when " + formula(1, inner) + " " + text + ")";
        if (universal) text = "(forall (?e - " + inner.back().type + ") " + text + ")";
        return " " + text;
    }

    std::string action(const std::string& name, const Variables& parameters, const std::string& condition,
                       const std::string& effect) {
        std::string text = " (:action " + name + " :parameters (";
        for (const Variable& variable : parameters) text += variable.name + " - " + variable.type + " ";
        text += ")\n  :precondition (and " + condition + extra_condition(parameters) + ")\n  :effect (and " +
                effect + extra_effect(parameters) + extra_effect(parameters) + cost(parameters) + "))\n";
        return text;
    }

    std::string cost(const Variables& parameters) {
        if (!costs_ || chance(20)) return "";
        std::string text;
        switch (below(4)) {
            case 0:
                text = "1.5";
                break;
            case 1:
                text = "0";
                break;
            default:
                text = parameters.size() > 2 ? "(distance ?p ?r)" : "2";
        }
        return " (increase (total-cost) " + text + ")";
    }

    std::string domain() {
        fluents_ = {{"at", {"thing", "place"}},
                    {"held", {"thing"}},
                    {"marked", {"object"}},
                    {"free", {"place"}},
                    {"flag", {}}};
        marks_.assign(fluents_.begin() + 2, fluents_.end());
        usable_ = fluents_;
        usable_.push_back({"road", {"place", "place"}});
        if (derived_) {
            usable_.push_back({"near", {"place", "place"}});
            usable_.push_back({"lost", {"thing"}});
            usable_.push_back({"fixed", {"place"}});
        }
        std::string text =
            "(define (domain moving)\n (:requirements :adl :derived-predicates :action-costs)\n"
            " (:types thing place - object cart - thing dock - place)\n";
        if (constants_) text += " (:constants" + names(things_) + names(places_) + ")\n";
        text +=
            " (:predicates (at ?x - thing ?p - place) (held ?x - thing) (marked ?o - object)\n"
            "  (free ?p - place) (flag) (road ?p ?r - place) (near ?p ?r - place) (lost ?x - thing)\n"
            "  (fixed ?p - place))\n (:functions (distance ?p ?r - place) - number (total-cost) - number)\n";
        if (derived_) text += axioms();
        text += actions();
        return text + ")";
    }

    std::string axioms() {
        const auto all = std::exchange(usable_, fluents_);
        const Variables pair = {{"?p", "place"}, {"?r", "place"}};
        std::string text = " (:derived (near ?p ?r - place) (or (road ?p ?r) " + formula(1, pair) +
                           " (exists (?m - place) (and (near ?p ?m) (near ?m ?r) " +
                           (chance(50) ? "(free ?m)" : "(road ?m ?r)") + "))))\n";
        usable_.push_back({"near", {"place", "place"}});
        text += " (:derived (lost ?x - thing) (and (not (exists (?p ?r - place) (and (at ?x ?p) (" +
                std::string(chance(50) ? "near" : "road") + " ?p ?r)))) " + formula(2, {{"?x", "thing"}}) +
                "))\n";
        usable_.push_back({"lost", {"thing"}});
        if (chance(70))
            text += " (:derived (fixed ?p - " + std::string(chance(50) ? "place" : "dock") + ") " +
                    (chance(50) ? "(exists (?r - place) (and (road ?p ?r) (not (= ?p ?r))))"
                                : formula(2, {{"?p", "place"}})) +
                    ")\n";
        usable_ = all;
        return text;
    }

    /// Mostly both for sure; sometimes under conditions, the same or not.
    std::string leave_and_enter() {
        static const std::vector<std::string> conditions = {"(marked ?x)", "(and (flag) (marked ?x))",
                                                            "(not (free ?p))"};
        if (chance(75)) return often("(not (at ?x ?p))") + "(at ?x ?r)";
        const std::string& leave = any(conditions);
        const std::string& enter = chance(60) ? leave : any(conditions);
        return "(when " + leave + " (not (at ?x ?p))) " +
               (chance(80) ? "(when " + enter + " (at ?x ?r))" : std::string("(at ?x ?r)"));
    }

    std::string actions() {
        const Variable thing{"?x", cart_ && chance(30) ? "cart" : "thing"};
        const Variables move = {thing, {"?p", "place"}, {"?r", "place"}};
        std::string text = action("move", move,
                                  often("(at ?x ?p)") + often("(road ?p ?r)") +
                                      (chance(50) ? "(free ?r)" : "") + (chance(30) ? "(not (= ?p ?r))" : ""),
                                  leave_and_enter() + (chance(50) ? "(not (free ?r)) (free ?p)" : ""));
        const Variables pick = {thing, {"?p", "place"}};
        if (chance(60)) {
            text += action("pick", pick, often("(at ?x ?p)") + (chance(50) ? "(not (held ?x))" : ""),
                           "(held ?x)" + often("(not (at ?x ?p))"));
            text += action("put", pick, often("(held ?x)") + (messy_ && chance(40) ? "(not (at ?x ?p))" : ""),
                           "(at ?x ?p)" + often("(not (held ?x))"));
        }
        if (chance(40)) {
            const Variables swap = {{"?x", "thing"}, {"?y", "thing"}, {"?p", "place"}, {"?r", "place"}};
            text +=
                action("swap", swap, "(at ?x ?p)" + often("(at ?y ?r)") + often("(not (= ?x ?y))"),
                       often("(not (at ?x ?p))") + "(at ?x ?r)" + often("(not (at ?y ?r))") + "(at ?y ?p)");
        }
        if (chance(messy_ ? 40 : 20)) {
            // Two places at once: excused by an invariant only where it holds.
            const Variables both = {{"?x", "thing"}, {"?y", "thing"}, {"?p", "place"}, {"?r", "place"}};
            text += action("both", both, "(at ?x ?p) (at ?x ?r)" + often("(not (= ?p ?r))"),
                           chance(50) ? "(at ?y ?r)" : "(at ?y ?r) (not (at ?x ?r))");
        }
        if (chance(50))
            text += action("toggle", {{"?o", "object"}}, "",
                           chance(50) ? "(forall (?e - place) (and (when (free ?e) (not (free ?e))) "
                                        "(when (not (free ?e)) (free ?e))))"
                                      : "(when (marked ?o) (not (marked ?o))) (when (not (marked ?o)) "
                                        "(marked ?o))");
        if (chance(50)) text += action("signal", {}, "", literal(messy_ ? fluents_ : marks_, {}));
        return text;
    }

    static std::string names(const Variables& objects) {
        std::string text;
        for (const Variable& object : objects) text += " " + object.name + " - " + object.type;
        return text;
    }

    std::string problem() {
        std::string text = "(define (problem p) (:domain moving)\n (:objects" +
                           (constants_ ? std::string() : names(things_) + names(places_)) + ")\n (:init";
        for (const Variable& thing : things_) {
            // Mostly one place each, but some are in two or in none.
            const std::size_t first = below(places_.size());
            const std::size_t count = chance(15) ? 2 : chance(15) ? 0 : 1;
            for (std::size_t i = 0; i < count; ++i)
                text += " (at " + thing.name + " " + places_[(first + i) % places_.size()].name + ")";
            if (chance(15)) text += " (held " + thing.name + ")";
            if (chance(30)) text += " (marked " + thing.name + ")";
        }
        for (const Variable& place : places_) {
            if (chance(60)) text += " (free " + place.name + ")";
            if (chance(30)) text += " (marked " + place.name + ")";
            for (const Variable& other : places_) {
                if (chance(60)) text += " (road " + place.name + " " + other.name + ")";
                if (costs_ && chance(90))
                    text += " (= (distance " + place.name + " " + other.name + ") " +
                            (chance(30) ? "0.25" : std::to_string(1 + below(4))) + ")";
            }
        }
        if (costs_) text += " (= (total-cost) 0)";
        text += ")\n (:goal (and";
        constants_ = true;
        for (std::size_t i = 1 + below(3); i > 0; --i)
            text += " " + (chance(70) ? literal(fluents_, {}) : formula(2, {}));
        text += "))";
        return text + (costs_ && chance(80) ? "\n (:metric minimize (total-cost))" : "") + ")";
    }

    std::mt19937 random_;
    Variables things_, places_;
    bool cart_ = false, constants_ = false, costs_ = false, derived_ = false, messy_ = false;
    std::vector<PredicateShape> fluents_, marks_, usable_;
};

}  // namespace

MovingTask moving_task(std::uint32_t seed) {
    return Maker(seed).make();
}

}  // namespace praxis::test
