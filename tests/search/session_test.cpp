// Sessions: planning again from other states to other goals, budgets, threads.
#include "search/session.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "search/validate.hpp"

namespace praxis {
namespace {

const char* const kDelivery =
    "(define (domain delivery) (:requirements :strips :typing :negative-preconditions)\n"
    "  (:types place parcel)\n"
    "  (:predicates (at ?p - place) (road ?a ?b - place) (in ?x - parcel ?p - place) (held ?x - parcel)\n"
    "    (broken) (lamp ?p - place))\n"
    "  (:action drive :parameters (?a ?b - place) :precondition (and (at ?a) (road ?a ?b) (not (broken)))\n"
    "    :effect (and (not (at ?a)) (at ?b)))\n"
    "  (:action take :parameters (?x - parcel ?p - place) :precondition (and (at ?p) (in ?x ?p))\n"
    "    :effect (and (not (in ?x ?p)) (held ?x)))\n"
    "  (:action drop :parameters (?x - parcel ?p - place) :precondition (and (at ?p) (held ?x))\n"
    "    :effect (and (not (held ?x)) (in ?x ?p)))\n"
    "  (:action light :parameters (?p - place) :precondition (and (at ?p) (not (lamp ?p))) :effect (lamp "
    "?p))\n"
    "  (:action dim :parameters (?p - place) :precondition (and (at ?p) (lamp ?p)) :effect (not (lamp ?p)))\n"
    "  (:action crash :parameters () :precondition () :effect (broken)))\n";

const char* const kDeliveryProblem =
    "(define (problem d1) (:domain delivery) (:objects a b c d - place x y - parcel)\n"
    "  (:init (at a) (road a b) (road b a) (road b c) (road c b) (in x b) (in y c))\n"
    "  (:goal (and (in x a) (in y a))))\n";

Task task_of(const char* domain, const char* problem) {
    return parse_task({"domain.pddl", domain}, {"problem.pddl", problem}).task;
}

Task delivery() {
    return task_of(kDelivery, kDeliveryProblem);
}

Configuration optimal() {
    return configuration("astar(blind())");
}

/// Atoms by their names: "at a".
Atom atom(const LiftedTask& task, const std::string& words) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (start < words.size()) {
        const std::size_t end = std::min(words.find(' ', start), words.size());
        parts.push_back(words.substr(start, end - start));
        start = end + 1;
    }
    const auto index = [](const auto& items, const std::string& name) {
        const auto found =
            std::find_if(items.begin(), items.end(), [&](const auto& i) { return i.name == name; });
        EXPECT_NE(found, items.end()) << name;
        return static_cast<std::size_t>(found - items.begin());
    };
    Atom result{PredicateId(index(task.predicates, parts[0])), {}};
    for (std::size_t i = 1; i < parts.size(); ++i)
        result.arguments.push_back(ObjectId(index(task.objects, parts[i])));
    return result;
}

std::vector<Atom> atoms(const LiftedTask& task, const std::vector<std::string>& names) {
    std::vector<Atom> result;
    for (const std::string& name : names) result.push_back(atom(task, name));
    return result;
}

/// Plans, and checks what comes out against a new session on the present task.
Result plan_and_compare(Session& session) {
    Result result = session.plan(optimal());
    const Task copy = std::make_shared<LiftedTask>(session.task());
    Session fresh(copy);
    const Result expected = fresh.plan(optimal());
    EXPECT_EQ(result.plan.has_value(), expected.plan.has_value());
    if (result.plan && expected.plan) {
        EXPECT_EQ(result.plan->cost, expected.plan->cost);
        const Verdict verdict = validate(session.task(), *result.plan);
        EXPECT_TRUE(verdict.valid) << verdict.reason;
    }
    return result;
}

TEST(Session, PlansTheTaskAsLoaded) {
    Session session(delivery());
    const Result result = plan_and_compare(session);
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.optimal);
    EXPECT_EQ(result.plan->cost, Rational(8));
    EXPECT_EQ(session.groundings(), 1);
    EXPECT_FALSE(session.phases().empty());
    EXPECT_GT(result.statistics.expanded, 0u);
}

TEST(Session, ChangedStatesNeedNoGrounding) {
    Session session(delivery());
    const LiftedTask& task = session.task();
    session.set_initial_state(atoms(task, {"at c", "held x", "in y b", "lamp b"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 5u);
    session.set_initial_state(atoms(task, {"at a", "in x a", "in y a"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 0u);
    session.set_initial_state(atoms(task, {"at b", "held x", "held y", "road a b"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 3u);
    session.set_initial_state(atoms(task, {"at b", "held x", "held y", "broken"}));
    EXPECT_EQ(plan_and_compare(session).plan, std::nullopt);
    EXPECT_EQ(session.groundings(), 1);
}

TEST(Session, RepeatedAtomsAreOne) {
    Session session(delivery());
    session.set_initial_state(atoms(session.task(), {"at c", "at c", "held x", "held x", "in y b"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 5u);
}

TEST(Session, StatesBeyondTheGroundTaskAreGroundOnce) {
    Session session(delivery());
    const LiftedTask& task = session.task();
    session.set_initial_state(atoms(task, {"at a", "in x d", "in y a"}));
    EXPECT_EQ(plan_and_compare(session).plan, std::nullopt);
    EXPECT_EQ(session.groundings(), 2);
    // Two places at once: no state of the variable.
    session.set_initial_state(atoms(session.task(), {"at a", "at b", "in x b", "in y a"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 2u);
    // Nowhere at all.
    session.set_initial_state(atoms(session.task(), {"in x b", "in y a"}));
    EXPECT_EQ(plan_and_compare(session).plan, std::nullopt);
}

TEST(Session, NewStaticAtomsStay) {
    Session session(delivery());
    session.set_initial_state(atoms(session.task(), {"at d", "road d a", "in x b", "held y"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 6u);
    const int groundings = session.groundings();
    session.set_initial_state(atoms(session.task(), {"at d", "in x a", "held y"}));
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 2u);
    EXPECT_EQ(session.groundings(), groundings);
}

TEST(Session, ChangedGoalsNeedNoGrounding) {
    Session session(delivery());
    const LiftedTask& task = session.task();
    session.set_goal({{atom(task, "at c"), false}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 2u);
    session.set_goal({{atom(task, "at c"), false}, {atom(task, "lamp b"), false}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 3u);
    session.set_goal({});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 0u);
    session.set_goal({{atom(task, "lamp a"), true}, {atom(task, "held x"), false}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 2u);
    session.set_goal({{atom(task, "road a b"), false}, {atom(task, "road a d"), true}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 0u);
    EXPECT_EQ(session.groundings(), 1);
}

TEST(Session, ImpossibleGoalsAreProved) {
    Session session(delivery());
    const LiftedTask& task = session.task();
    for (const auto& goal :
         std::vector<std::vector<GoalLiteral>>{{{atom(task, "at d"), false}},
                                               {{atom(task, "road a d"), false}},
                                               {{atom(task, "road a b"), true}},
                                               {{atom(task, "at a"), false}, {atom(task, "at b"), false}}}) {
        session.set_goal(goal);
        EXPECT_EQ(session.plan(optimal()).status, Status::unsolvable_early);
    }
    EXPECT_EQ(session.groundings(), 1);
}

TEST(Session, NegatedGoalsOfManyValuedVariables) {
    Session session(delivery());
    session.set_goal({{atom(session.task(), "at a"), true}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 1u);
    session.set_goal({{atom(session.task(), "in x b"), true}, {atom(session.task(), "at b"), true}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 3u);
}

TEST(Session, WrongUseIsRefused) {
    Session session(delivery());
    const LiftedTask& task = session.task();
    Atom wrong_arity = atom(task, "at a");
    wrong_arity.arguments.clear();
    EXPECT_THROW(session.set_initial_state({wrong_arity}), std::invalid_argument);
    EXPECT_THROW(session.set_goal({{wrong_arity, false}}), std::invalid_argument);
    EXPECT_THROW(session.set_initial_state({{PredicateId(99), {}}}), std::invalid_argument);
    EXPECT_THROW(session.set_initial_state({{PredicateId(), {}}}), std::invalid_argument);
    EXPECT_THROW(session.set_initial_state({{atom(task, "at a").predicate, {ObjectId(99)}}}),
                 std::invalid_argument);
    const Atom wrong_type{atom(task, "at a").predicate, {atom(task, "held x").arguments[0]}};
    EXPECT_THROW(session.set_goal({{wrong_type, false}}), std::invalid_argument);
    EXPECT_THROW(session.plan({.expression = "no_such_engine()"}), std::invalid_argument);
    // Nothing of that has changed the session.
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 8u);
}

TEST(Session, DerivedAtomsAreGoalsButNoStates) {
    const Task task = task_of(
        "(define (domain lamps) (:requirements :strips :derived-predicates)\n"
        "  (:predicates (switch ?l) (on ?l) (bright) (never))\n"
        "  (:derived (bright) (and (on l1) (on l2)))\n"
        "  (:constants l1 l2)\n"
        "  (:action press :parameters (?l) :precondition (switch ?l) :effect (on ?l))\n"
        "  (:action cut :parameters (?l) :precondition (on ?l) :effect (not (on ?l))))\n",
        "(define (problem p) (:domain lamps) (:init (switch l1) (switch l2)) (:goal (on l1)))\n");
    Session session(task);
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 1u);
    session.set_goal({{atom(*task, "bright"), false}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 2u);
    session.set_initial_state(atoms(*task, {"on l1", "on l2"}));
    session.set_goal({{atom(*task, "bright"), true}});
    EXPECT_EQ(plan_and_compare(session).plan->steps.size(), 1u);
    EXPECT_THROW(session.set_initial_state({atom(*task, "bright")}), std::invalid_argument);
}

TEST(Session, BudgetAndStopTokenEndAPlan) {
    Session session(delivery());
    Budget spent;
    spent.limit_wall_time(0);
    EXPECT_EQ(session.plan(optimal(), spent).status, Status::out_of_time);
    std::stop_source source;
    source.request_stop();
    Budget stopped;
    stopped.stop_with(source.get_token());
    EXPECT_EQ(session.plan(optimal(), stopped).status, Status::interrupted);
    EXPECT_EQ(session.plan(optimal()).status, Status::solved);
}

TEST(Session, BudgetEndsGroundingAndTheNextPlanTriesAgain) {
    Budget spent;
    spent.limit_wall_time(0);
    Session session(delivery(), {}, spent);
    EXPECT_EQ(session.ground_task(), nullptr);
    EXPECT_EQ(session.plan(optimal(), spent).status, Status::out_of_time);
    EXPECT_EQ(session.plan(optimal()).status, Status::solved);
}

/// Twelve parameters over forty objects: more ground actions than any memory holds.
Task huge() {
    std::string parameters, objects, conditions, init;
    for (int i = 0; i < 12; ++i) parameters += " ?x" + std::to_string(i);
    for (int i = 0; i < 11; ++i)
        conditions += " (link ?x" + std::to_string(i) + " ?x" + std::to_string(i + 1) + ")";
    for (int i = 0; i < 40; ++i) objects += " o" + std::to_string(i);
    for (int i = 0; i < 10; ++i) init += "(link o" + std::to_string(i) + " o" + std::to_string(i + 1) + ")";
    const std::string domain =
        "(define (domain huge) (:predicates (link ?x ?y) (cut ?x))"
        " (:action tie :parameters (?x ?y) :precondition (not (= ?x ?y)) :effect (link ?x ?y))"
        " (:action cut :parameters (" +
        parameters + ") :precondition (and" + conditions + ") :effect (cut ?x11)))";
    const std::string problem = "(define (problem h) (:domain huge) (:objects" + objects + ") (:init " +
                                init + ") (:goal (cut o39)))";
    return task_of(domain.c_str(), problem.c_str());
}

TEST(Session, TasksTooLargeToGroundArePlannedWithout) {
    const Task task = huge();
    Budget budget;
    budget.limit_wall_time(4);
    Session session(task, {}, budget);
    EXPECT_EQ(session.ground_task(), nullptr);
    EXPECT_TRUE(session.lifted());
    int plans = 0;
    Callbacks callbacks;
    callbacks.on_plan = [&](const Plan&) { ++plans; };
    const Result result = session.plan(alias("agile"), {}, callbacks);
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.lifted);
    EXPECT_FALSE(result.optimal);
    EXPECT_EQ(plans, 1);
    EXPECT_TRUE(validate(*task, *result.plan).valid);
    session.set_goal({{atom(*task, "link o3 o1")}});
    EXPECT_EQ(session.plan(alias("agile")).plan->steps.size(), 1u) << "and so are other goals";
    EXPECT_EQ(session.groundings(), 1);
}

TEST(Session, NothingIsPlannedLiftedUnwanted) {
    SessionOptions options;
    options.lifted_fallback = false;
    Budget budget;
    budget.limit_wall_time(0.3);
    Session session(huge(), options, budget);
    EXPECT_FALSE(session.lifted());
    EXPECT_EQ(session.plan(alias("agile"), budget).status, Status::out_of_time);
}

TEST(Session, CallbacksSeeThePlan) {
    Session session(delivery());
    std::vector<Plan> plans;
    Callbacks callbacks;
    callbacks.on_plan = [&](const Plan& plan) { plans.push_back(plan); };
    const Result result = session.plan(optimal(), {}, callbacks);
    ASSERT_FALSE(plans.empty());
    EXPECT_EQ(plans.back().steps, result.plan->steps);
}

TEST(Session, SameSeedSamePlan) {
    Configuration random = configuration("lazy_greedy([ff()],randomize_successors=true)");
    random.seed = 11;
    Session one(delivery());
    Session two(delivery());
    const Result first = one.plan(random);
    EXPECT_EQ(first.plan->steps, two.plan(random).plan->steps);
    EXPECT_EQ(first.plan->steps, one.plan(random).plan->steps);
}

TEST(Session, ThreadsHaveSessionsOfTheirOwn) {
    const Task task = delivery();
    std::vector<Result> results(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < results.size(); ++i)
        threads.emplace_back([&, i] {
            Session session(task);
            for (int round = 0; round < 20; ++round) {
                session.set_goal({{atom(*task, round % 2 ? "at c" : "in y a"), false}});
                results[i] = session.plan(configuration("lazy_greedy([ff()],preferred=[ff()])"));
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const Result& result : results) {
        ASSERT_TRUE(result.plan);
        EXPECT_EQ(result.plan->steps, results[0].plan->steps);
    }
}

TEST(Session, OneTokenStopsManyThreads) {
    const Task task = delivery();
    std::stop_source source;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&] {
            Session session(task);
            Budget budget;
            budget.stop_with(source.get_token());
            while (session.plan(optimal(), budget).status != Status::interrupted) {
            }
        });
    source.request_stop();
    for (std::thread& thread : threads) thread.join();
}

/// Every ground atom of a fluent predicate.
std::vector<Atom> fluent_atoms(const LiftedTask& task) {
    std::vector<Atom> result;
    for (std::size_t p = 0; p < task.predicates.size(); ++p) {
        const Predicate& predicate = task.predicates[p];
        if (!predicate.fluent) continue;
        std::vector<Atom> partial{{PredicateId(p), {}}};
        for (TypeId type : predicate.parameters) {
            std::vector<Atom> longer;
            for (const Atom& prefix : partial)
                for (ObjectId object : task.types[type.index()].objects) {
                    longer.push_back(prefix);
                    longer.back().arguments.push_back(object);
                }
            partial = std::move(longer);
        }
        result.insert(result.end(), partial.begin(), partial.end());
    }
    return result;
}

RC_GTEST_PROP(SessionProperty, ReplanningEqualsPlanningAnew, ()) {
    Session session(delivery());
    const std::vector<Atom> all = fluent_atoms(session.task());
    for (int round = 0; round < 4; ++round) {
        if (*rc::gen::arbitrary<bool>()) {
            // Mostly proper states (one place for the van and each parcel), sometimes any set of atoms.
            std::vector<Atom> state;
            if (*rc::gen::inRange(0, 4) == 0) {
                for (const Atom& candidate : all)
                    if (*rc::gen::inRange(0, 4) == 0) state.push_back(candidate);
            } else {
                const auto place = [] { return std::string(1, "abcd"[*rc::gen::inRange(0, 4)]); };
                state.push_back(atom(session.task(), "at " + place()));
                for (const char* parcel : {"x", "y"})
                    state.push_back(*rc::gen::inRange(0, 3) == 0
                                        ? atom(session.task(), std::string("held ") + parcel)
                                        : atom(session.task(), std::string("in ") + parcel + " " + place()));
                if (*rc::gen::inRange(0, 4) == 0) state.push_back(atom(session.task(), "broken"));
            }
            session.set_initial_state(state);
        } else {
            std::vector<GoalLiteral> goal;
            const int count = *rc::gen::inRange(0, 4);
            for (int i = 0; i < count; ++i)
                goal.push_back({*rc::gen::elementOf(all), *rc::gen::inRange(0, 3) == 0});
            session.set_goal(goal);
        }
        const Result result = session.plan(optimal());
        Session fresh(std::make_shared<LiftedTask>(session.task()));
        const Result expected = fresh.plan(optimal());
        RC_ASSERT(result.plan.has_value() == expected.plan.has_value());
        if (!result.plan) continue;
        RC_ASSERT(result.plan->cost == expected.plan->cost);
        RC_ASSERT(validate(session.task(), *result.plan).valid);
    }
}

}  // namespace
}  // namespace praxis
