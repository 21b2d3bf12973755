#include "tests/belief/random_contingent.hpp"

#include <array>

#include "search/engines/random.hpp"

namespace praxis::belief::test {
namespace {

constexpr std::array<const char*, 6> kAtoms{"(a x)", "(a y)", "(a z)", "(b)", "(c)", "(e)"};

class Author {
  public:
    Author(std::uint64_t seed, const Constructs& constructs) : random_(seed), constructs_(constructs) {
        constructs_.forgetting = constructs_.forgetting && constructs_.uncertain && chance(30);
        constructs_.derived = constructs_.derived && chance(40);
        constructs_.conditional = constructs_.conditional && chance(70);
        constructs_.sensors = constructs_.sensors && chance(40);
    }

    Texts write() {
        Texts texts;
        texts.domain =
            "(define (domain d) (:types thing) (:constants x y z - thing)\n"
            " (:predicates (a ?t - thing) (b) (c) (e) (d ?t - thing)" +
            std::string(constructs_.models ? " (m ?t - thing) (next ?t ?u - thing) (o) (s ?t - thing)" : "") +
            ")\n";
        if (constructs_.uncertain && chance(10)) texts.domain += " (:open-world c)\n";
        if (constructs_.derived)
            texts.domain += " (:derived (d ?t - thing) " + conjunction("?t", 1, 2, false) + ")\n";
        if (constructs_.models) texts.domain += models();
        const std::size_t actions = 2 + random_.below(4);
        for (std::size_t i = 0; i < actions; ++i) texts.domain += action(i);
        const std::size_t looks = 1 + random_.below(3);
        for (std::size_t i = 0; i < looks; ++i) {
            const bool lifted = chance(50);
            texts.domain += " (:action look" + number(i) + parameters(lifted) + " :precondition " +
                            conjunction(term(lifted), 0, 1, true) + readings(term(lifted)) + ")\n";
        }
        const std::size_t sensors = constructs_.sensors ? 1 + random_.below(2) : 0;
        for (std::size_t i = 0; i < sensors; ++i)
            texts.domain += " (:sensor smell" + number(i) + parameters(true) + " :condition " +
                            conjunction("?t", 1, 2, true) + " :sense " + atom("?t", false) + ")\n";
        texts.domain += ")";
        texts.problem =
            "(define (problem p) (:domain d)\n (:init" + initial() + ")\n (:goal " + goal() + "))";
        return texts;
    }

  private:
    bool chance(std::size_t percent) { return random_.below(100) < percent; }
    static std::string number(std::size_t i) { return std::to_string(i); }
    static std::string parameters(bool lifted) {
        return lifted ? " :parameters (?t - thing)" : " :parameters ()";
    }
    /// The parameter, or an object.
    std::string term(bool lifted) {
        static constexpr std::array<const char*, 3> kObjects{"x", "y", "z"};
        return lifted ? "?t" : kObjects[random_.below(3)];
    }

    std::string atom(const std::string& term, bool also_derived) {
        switch (random_.below(also_derived && constructs_.derived ? 8 : 6)) {
            case 0:
            case 1:
                return "(a " + term + ")";
            case 2:
                return "(a " + this->term(false) + ")";
            case 3:
                return "(b)";
            case 4:
                return "(c)";
            case 5:
                return "(e)";
            default:
                return "(d " + term + ")";
        }
    }
    std::string literal(const std::string& term, bool also_derived) {
        const std::string positive = atom(term, also_derived);
        return chance(35) ? "(not " + positive + ")" : positive;
    }
    std::string conjunction(const std::string& term, std::size_t least, std::size_t most, bool also_derived) {
        std::string text = "(and";
        for (std::size_t i = least + random_.below(most - least + 1); i > 0; --i)
            text += " " + literal(term, also_derived);
        return text + ")";
    }

    std::string effect(const std::string& term) {
        if (constructs_.forgetting && chance(15)) return " (unknown " + atom(term, false) + ")";
        if (constructs_.conditional && chance(10))
            return " (forall (?u - thing) (when " + conjunction("?u", 1, 2, constructs_.derived_in_effects) +
                   " " + literal("?u", false) + "))";
        if (constructs_.conditional && chance(50))
            return " (when " + conjunction(term, 1, 2, constructs_.derived_in_effects) + " " +
                   literal(term, false) + ")";
        return " " + literal(term, false);
    }

    std::string readings(const std::string& term) {
        if (chance(10)) return " :observe (forall (?u - thing) (a ?u))";
        std::string text = " :observe (and";
        for (std::size_t i = 1 + random_.below(2); i > 0; --i) text += " " + atom(term, false);
        return text + ")";
    }

    std::string action(std::size_t i) {
        const bool lifted = chance(50);
        const std::string own = term(lifted);
        std::string text = " (:action do" + number(i) + parameters(lifted) + " :precondition " +
                           conjunction(own, 0, 2, true) + " :effect (and";
        for (std::size_t e = 1 + random_.below(3); e > 0; --e) text += effect(own);
        text += ")";
        if (chance(25)) text += readings(own);
        return text + ")\n";
    }

    /// A variable of three values that is moved, left open and shown; atoms that models show.
    std::string models() {
        std::string text =
            " (:variable place (forall (?t - thing) (m ?t)))\n (:obs-variable light (o))\n"
            " (:obs-variable (sound ?t - thing) (s ?t))\n"
            " (:action step :parameters (?t ?u - thing) :precondition (and (m ?t) (next ?t ?u))"
            " :effect (and (not (m ?t)) (m ?u)))\n"
            " (:action roll :parameters () :effect (forall (?t ?u - thing)"
            " (when (and (m ?t) (next ?t ?u)" +
            std::string(chance(50) ? " (b)" : "") + ") (and (not (m ?t)) (m ?u)))))\n";
        if (constructs_.forgetting)
            text += " (:action lose :parameters () :effect (unknown (m " + term(false) + ")))\n";
        if (chance(70)) {
            text += " (:default-sensing-model (and " + rule("(o)", "x") + " " + rule("(o)", "y") + "))\n";
            if (chance(60))
                text += " (:action use :parameters () :precondition " +
                        std::string(chance(50) ? "(o)" : "(not (o))") + " :effect " + literal("x", false) +
                        ")\n";
        }
        text += " (:action listen :parameters (?t - thing) :precondition " + conjunction("?t", 0, 1, false) +
                " :sensing-model (and " + rule(chance(70) ? "(s ?t)" : "(not (s ?t))", "?t");
        if (chance(50)) text += " (forall (?u - thing) " + rule("(s ?u)", "?u") + ")";
        if (chance(20)) text += " (m ?t)";
        return text + "))\n";
    }
    std::string rule(const std::string& head, const std::string& term) {
        return "(when " + model_condition(term, 2) + " " + head + ")";
    }
    std::string model_condition(const std::string& term, std::size_t depth) {
        if (depth == 0 || chance(30)) {
            const std::string atom = chance(40) ? "(m " + term + ")" : this->atom(term, false);
            return chance(30) ? "(not " + atom + ")" : atom;
        }
        if (chance(15))
            return "(exists (?v - thing) (and (next ?v " + term + ") " + model_condition("?v", 0) + "))";
        return std::string(chance(50) ? "(and " : "(or ") + model_condition(term, depth - 1) + " " +
               model_condition(term, depth - 1) + ")";
    }

    std::string initial() {
        std::string text;
        if (constructs_.models) {
            text = " (next x y) (next y z) (next z x)";
            if (chance(30))
                text += " (m " + term(false) + ")";
            else if (chance(30))
                text += " (not (m " + term(false) + "))";
        }
        for (const char* atom : kAtoms) {
            const std::string name = atom;
            const std::size_t kind = random_.below(10);
            if (kind < 4 && constructs_.uncertain)
                text += " (unknown " + name + ")";
            else if (kind < 6)
                text += " " + name;
            else if (kind == 6)
                text += " (not " + name + ")";
        }
        static constexpr std::array<const char*, 6> kKinds{"or",          "oneof",        "invariant",
                                                           "at-most-one", "at-least-one", "exactly-one"};
        for (std::size_t i = constructs_.uncertain ? random_.below(4) : 0; i > 0; --i)
            text += clause(kKinds[random_.below(6)]);
        return text;
    }

    std::string clause(const std::string& kind) {
        std::vector<std::size_t> places{0, 1, 2, 3, 4, 5};
        random_.shuffle(places);
        places.resize(2 + random_.below(2));
        std::string text = " (" + kind;
        for (std::size_t place : places) {
            const std::string atom = kAtoms[place];
            text += chance(30) ? " (not " + atom + ")" : " " + atom;
        }
        return text + ")";
    }

    std::string goal() { return conjunction(term(false), chance(95) ? 1 : 0, 2, true); }

    Random random_;
    Constructs constructs_;
};

}  // namespace

Texts random_contingent(std::uint64_t seed, const Constructs& constructs) {
    return Author(seed, constructs).write();
}

}  // namespace praxis::belief::test
