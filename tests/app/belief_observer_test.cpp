// `plan belief --observer` as its users run it: against a service on this machine, and from its records.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"
#ifdef PRAXIS_HAS_PERCEPTION
#include "tests/belief/perception/chat_server.hpp"
#endif

namespace praxis::test {
namespace {

class ObserverCommand : public testing::Test {
  protected:
    Outcome belief(std::vector<std::string> more) const {
        std::vector<std::string> arguments{
            "belief", domain, problem, "--observer", folder / "observer.json", "--accept", "0.9"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return plan(arguments);
    }
    void write(const std::string& service, const std::string& mode,
               const std::string& atom = "(in b2)") const {
        folder.write("observer.json", R"({"service": {"model": "m", "attempts": 1)" + service +
                                          R"(}, "record": {"file": "answers.jsonl", "mode": ")" + mode +
                                          R"("},
            "questions": {"predicates": {"in": {"sentence": "Is the ball in {0}?"}}},
            "scene": {"cameras": [{"name": "top", "side": "above", "centre": [0, 0, 0], "distance": 1,
                                   "visible": 1, "width": 32, "height": 24}],
                      "bodies": [{"name": "ball", "shape": "cylinder", "colour": [250, 10, 10],
                                  "size": [0.1, 0.1, 0.1], "places": [{"if": ")" +
                                          atom + R"(", "at": [0, 0, 0]}]}]}})");
    }

    TemporaryFolder folder;
    std::string domain =
        folder.write("domain.pddl",
                     "(define (domain boxes) (:requirements :typing :contingent) (:types box)\n"
                     "  (:predicates (in ?b - box) (have))\n"
                     "  (:action look :parameters (?b - box) :observe (in ?b))\n"
                     "  (:action take :parameters (?b - box) :precondition (in ?b) :effect (have)))\n");
    std::string problem =
        folder.write("two.pddl",
                     "(define (problem two) (:domain boxes) (:objects b1 b2 - box)\n"
                     "  (:init (oneof (in b1) (in b2))) (:hidden (in b2)) (:goal (have)))\n");
};

#ifdef PRAXIS_HAS_PERCEPTION

TEST_F(ObserverCommand, ReadsPicturesAndReplaysTheAnswersOffline) {
    std::size_t asked = 0;
    {
        ChatServer server([&](const ReceivedRequest& request, std::size_t) {
            ++asked;
            EXPECT_TRUE(contains(request.body, "data:image/png;base64,"));
            const bool second = contains(request.body, "Is the ball in b2?");
            return says(std::string(R"({"answers": [{"question": 1, "answer": ")") +
                        (second ? "true" : "false") + "\"}]}");
        });
        write(R"(, "url": ")" + server.base() + "\"", "cache");
        const Outcome outcome = belief({});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
        EXPECT_TRUE(contains(outcome.out, "(take b2)")) << outcome.out;
        EXPECT_TRUE(contains(outcome.err, "observer: 1 requests")) << outcome.err;
        EXPECT_EQ(asked, 1u);
    }
    write("", "replay");
    const Outcome offline = belief({"--quiet"});
    EXPECT_EQ(offline.exit_code, 0) << offline.out << offline.err;
    EXPECT_TRUE(contains(offline.out, "(take b2)")) << offline.out;
    EXPECT_EQ(asked, 1u);
}

TEST_F(ObserverCommand, AServiceThatFailsEndsTheRunWithItsWords) {
    ChatServer server([](const auto&, std::size_t) { return fails(403, "{\"error\": \"not you\"}"); });
    write(R"(, "url": ")" + server.base() + "\"", "cache");
    const Outcome outcome = belief({"--json", folder / "report.json"});
    EXPECT_EQ(outcome.exit_code, 12) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the observer failed: ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "not you")) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(read_file(folder / "report.json"))["runs"][0]["status"],
              "observer failed");
}

TEST_F(ObserverCommand, WrongSettingsAreWrongInput) {
    folder.write("answers.jsonl", "");
    write("", "replay", "(in b7)");
    const Outcome atom = belief({});
    EXPECT_EQ(atom.exit_code, 31);
    EXPECT_TRUE(contains(atom.err, "observer.json: the task has no atom (in b7)")) << atom.err;
    write(", \"colour\": 3", "replay");
    const Outcome member = belief({});
    EXPECT_EQ(member.exit_code, 31);
    EXPECT_TRUE(contains(member.err, "'colour' is not a setting")) << member.err;
}

#else

TEST_F(ObserverCommand, NeedsPerception) {
    write("", "replay");
    const Outcome outcome = belief({});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "PRAXIS_BUILD_PERCEPTION")) << outcome.err;
}

#endif

}  // namespace
}  // namespace praxis::test
