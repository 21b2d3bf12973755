// Callbacks that are missing or break the rules, and calls that end early.
#include <gtest/gtest.h>

#include <limits>
#include <stop_token>

#include "tests/tamp/support/line_world.hpp"

namespace praxis::tamp {
namespace {

using test::LineWorld;

class Callbacks : public ::testing::Test {
  protected:
    std::string error_of(const StreamLibrary& with) {
        try {
            refine({&task, &with, test::tight_values(), {}});
        } catch (const StreamError& error) {
            return error.what();
        }
        return "no error";
    }

    StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "tight");
    StreamLibrary library = LineWorld{}.library();
};

TEST_F(Callbacks, ThatThrowAreNamed) {
    library.bind("inverse-kinematics",
                 [](StreamCall&) -> StreamResult { throw std::runtime_error("the solver is broken"); });
    const std::string error = error_of(library);
    EXPECT_NE(error.find("stream 'inverse-kinematics' of ("), std::string::npos) << error;
    EXPECT_NE(error.find("the solver is broken"), std::string::npos) << error;
    library.bind("inverse-kinematics", [](StreamCall&) -> StreamResult { throw 7; });
    EXPECT_NE(error_of(library).find("unknown kind"), std::string::npos);
    library.bind("inverse-kinematics", [](StreamCall& call) {
        return StreamResult::sample({Value::of(call.inputs[1].get<int>())});
    });
    EXPECT_NE(error_of(library).find("has type double; int is wanted"), std::string::npos)
        << error_of(library);
}

TEST_F(Callbacks, MustGiveWhatIsDeclared) {
    StreamLibrary wrong = library;
    wrong.bind("sample-grasp", [](StreamCall&) { return StreamResult::pass(); });
    EXPECT_NE(error_of(wrong).find("gave 0 outputs; 1 are declared"), std::string::npos) << error_of(wrong);
    wrong = library;
    wrong.bind("inverse-kinematics", [](StreamCall&) { return StreamResult::reject({.fluents = {0}}); });
    EXPECT_NE(error_of(wrong).find("blames a fluent that it did not get"), std::string::npos);
    wrong = library;
    wrong.bind("inverse-kinematics", [](StreamCall&) { return StreamResult::reject({.inputs = {3}}); });
    EXPECT_NE(error_of(wrong).find("blames an input that it did not get"), std::string::npos);
}

TEST_F(Callbacks, CostsAreFiniteAndNotNegative) {
    for (const double cost :
         {std::numeric_limits<double>::quiet_NaN(), -1.0, std::numeric_limits<double>::infinity()}) {
        library.bind_function("distance", [cost](std::span<const Value>) { return cost; });
        EXPECT_NE(error_of(library).find("which is no cost"), std::string::npos) << cost;
    }
}

TEST_F(Callbacks, MustBeBound) {
    StreamLibrary few;
    few.bind("sample-poses", [](StreamCall&) { return StreamResult::exhausted(); });
    try {
        refine({&task, &few, {}, {}});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()),
                  "nothing is bound to stream 'sample-pose'; did you mean 'sample-poses'?");
    }
    EXPECT_THROW(few.bind("x", StreamCallback()), std::invalid_argument);
    EXPECT_THROW(few.bind("x", [](StreamCall&) { return StreamResult::pass(); }, {.max_samples = 0}),
                 std::invalid_argument);
    EXPECT_THROW(few.bind("x", [](StreamCall&) { return StreamResult::pass(); }, {.effort = NAN}),
                 std::invalid_argument);
    EXPECT_THROW(few.bind_function(
                     "x", [](std::span<const Value>) { return 0.0; }, -1),
                 std::invalid_argument);
}

TEST_F(Callbacks, ValuesAreOfObjects) {
    RefinementProblem problem{&task, &library, test::tight_values(), {}};
    problem.values["pz"] = Value::of(1.0);
    EXPECT_THROW(refine(problem), std::invalid_argument);
    EXPECT_THROW(refine({}), std::invalid_argument);
}

TEST_F(Callbacks, BudgetAndStopTokenEndTheWork) {
    library.bind("test-apart", [](StreamCall&) { return StreamResult::reject({.definite = false}); });
    const RefinementProblem problem{&task, &library, test::tight_values(), {}};
    Budget spent;
    spent.limit_wall_time(0);
    EXPECT_EQ(refine(problem, spent).status, RefineStatus::out_of_budget);
    std::stop_source source;
    Budget stopped;
    stopped.stop_with(source.get_token());
    std::uint64_t skeletons = 0;
    RefineCallbacks callbacks;
    callbacks.on_progress = [&](const RefineStatistics& statistics) {
        skeletons = statistics.skeletons;
        source.request_stop();
    };
    EXPECT_EQ(refine(problem, stopped, callbacks).status, RefineStatus::cancelled);
    EXPECT_EQ(skeletons, 1u);
}

TEST_F(Callbacks, TheSameSeedGivesTheSamePlan) {
    const auto text = [&](std::uint64_t seed) {
        RefinementProblem problem{&task, &library, test::tight_values(), {}};
        problem.options.seed = seed;
        const Refinement result = refine(problem);
        std::string plan;
        for (std::size_t i = 0; i < result.plan->steps.size(); ++i) plan += result.plan->action(i);
        return plan + std::to_string(result.plan->cost);
    };
    EXPECT_EQ(text(3), text(3));
    EXPECT_NE(text(3), text(4));
}

TEST(Values, KeepTheirType) {
    const Value value = Value::of(std::string("here")).named("p");
    EXPECT_EQ(value.get<std::string>(), "here");
    EXPECT_EQ(value.get_if<int>(), nullptr);
    EXPECT_THROW(value.get<int>(), std::invalid_argument);
    EXPECT_THROW(Value().get<int>(), std::invalid_argument);
    EXPECT_EQ(value, value.named("q")) << "the content counts";
    EXPECT_FALSE(value == Value::of(std::string("here")).named("p"));
    EXPECT_FALSE(Value().named("a") == Value().named("b"));
}

}  // namespace
}  // namespace praxis::tamp
