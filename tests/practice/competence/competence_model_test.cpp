// What holds for every model.
#include "practice/competence/competence_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

const std::vector<std::string> kModels{"beta", "optimistic", "latent"};

CompetenceOptions options_of(const std::string& model, Beta prior = {1, 1}) {
    CompetenceOptions options;
    options.model = model;
    options.prior = prior;
    return options;
}

/// 0: failure, 1: success, 2: the end of a cycle.
std::vector<int> random_history() {
    return *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3));
}

void replay(CompetenceModel& model, const std::vector<int>& history) {
    for (const int event : history)
        if (event == 2)
            model.advance_cycle();
        else
            model.observe(event == 1);
}

TEST(MakeCompetenceModel, NamesTheModelsThereAre) {
    try {
        make_competence_model(options_of("psychic"));
        FAIL() << "made a model that there is not";
    } catch (const std::invalid_argument& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("psychic"), std::string::npos);
        for (const std::string& name : kModels) EXPECT_NE(text.find(name), std::string::npos);
    }
}

TEST(MakeCompetenceModel, RefusesOptionsOutOfRange) {
    const auto refuses = [](auto change) {
        CompetenceOptions options;
        change(options);
        EXPECT_THROW(make_competence_model(options), std::invalid_argument);
    };
    refuses([](auto& options) { options.window = 0; });
    refuses([](auto& options) { options.recency = -3; });
    refuses([](auto& options) { options.bonus = -0.1; });
    refuses([](auto& options) { options.bonus = 1.1; });
    refuses([](auto& options) { options.bonus = std::nan(""); });
    refuses([](auto& options) { options.prior = {0, 1}; });
}

TEST(CompetenceModel, StartsFromThePriorAndTheBonus) {
    for (const std::string& name : kModels) {
        CompetenceOptions options = options_of(name, {2, 6});
        options.bonus = 0.3;
        const auto model = make_competence_model(options);
        EXPECT_DOUBLE_EQ(model->competence(), 0.25) << name;
        EXPECT_DOUBLE_EQ(model->predict(7, 1), 0.55) << name;
        EXPECT_EQ(model->evidence(), Counts{}) << name;
    }
}

TEST(CompetenceModel, RefusesAPriorThatIsNone) {
    for (const std::string& name : kModels)
        EXPECT_THROW(make_competence_model(options_of(name))->set_prior({1, -1}), std::invalid_argument);
}

TEST(CompetenceModel, StaysInRangeForExtremePriorsAndLongHistories) {
    for (const std::string& name : kModels)
        for (const Beta prior : {Beta{1e-9, 1e9}, Beta{1e9, 1e-9}, Beta{1e-9, 1e-9}, Beta{1e12, 1e12}}) {
            const auto model = make_competence_model(options_of(name, prior));
            for (int i = 0; i < 4; ++i) {
                cycle(*model, i % 2 == 0 ? 1000 : 0, i % 2 == 0 ? 0 : 1000);
                EXPECT_GE(model->competence(), 1e-6) << name;
                EXPECT_LE(model->competence(), 1) << name;
                EXPECT_GE(model->predict(1000000000, 1000000000), 1e-6) << name;
                EXPECT_LE(model->predict(1000000000, 1000000000), 1) << name;
            }
        }
}

RC_GTEST_PROP(CompetenceModel, AnswersAreProbabilitiesAndPracticeNeverHurts, ()) {
    const auto model = make_competence_model(options_of(*rc::gen::elementOf(kModels)));
    replay(*model, random_history());
    const double now = model->competence();
    RC_ASSERT(now >= 1e-6 && now <= 1);
    RC_ASSERT(model->posterior().variance() > 0);
    double previous = now;
    for (const int more : {0, 1, 5, 100}) {
        const double then = model->predict(more, more);
        RC_ASSERT(then >= previous - 1e-12 && then <= 1);
        previous = then;
    }
}

RC_GTEST_PROP(CompetenceModel, ASuccessRaisesAndAFailureLowersCompetence, ()) {
    const std::string name = *rc::gen::elementOf(kModels);
    const std::vector<int> history = random_history();
    const auto same = make_competence_model(options_of(name));
    const auto better = make_competence_model(options_of(name));
    const auto worse = make_competence_model(options_of(name));
    for (CompetenceModel* model : {same.get(), better.get(), worse.get()}) replay(*model, history);
    // A new cycle of `optimistic` may push an old one out of its window.
    if (name == "optimistic" && (history.empty() || history.back() == 2)) return;
    better->observe(true);
    worse->observe(false);
    RC_ASSERT(better->competence() >= same->competence());
    RC_ASSERT(worse->competence() <= same->competence());
}

RC_GTEST_PROP(CompetenceModel, CyclesWithoutOutcomesChangeNothing, ()) {
    const std::string name = *rc::gen::elementOf(kModels);
    const auto sparse = make_competence_model(options_of(name));
    const auto dense = make_competence_model(options_of(name));
    for (const int event : random_history()) {
        replay(*dense, {event});
        replay(*sparse, {event});
        if (event == 2) replay(*sparse, {2, 2, 2});
    }
    RC_ASSERT(sparse->posterior() == dense->posterior());
    RC_ASSERT(sparse->predict(3, 1) == dense->predict(3, 1));
}

RC_GTEST_PROP(CompetenceModel, TheSameHistoryGivesTheSameAnswers, ()) {
    const std::string name = *rc::gen::elementOf(kModels);
    const std::vector<int> history = random_history();
    const auto one = make_competence_model(options_of(name)), two = make_competence_model(options_of(name));
    replay(*one, history);
    replay(*two, history);
    RC_ASSERT(one->posterior() == two->posterior());
    RC_ASSERT(one->predict(3, 2) == two->predict(3, 2));
}

TEST(CompetenceModel, KeepsOutcomesUnderAnotherPrior) {
    for (const std::string name : {"beta", "optimistic"}) {
        const auto model = make_competence_model(options_of(name));
        cycle(*model, 2, 1);
        model->set_prior({4, 3});
        EXPECT_EQ(model->posterior(), (Beta{6, 4})) << name;
        EXPECT_EQ(model->evidence(), (Counts{2, 1})) << name;
    }
}

}  // namespace
}  // namespace praxis::practice
