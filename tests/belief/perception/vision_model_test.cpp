// The client against a server that answers rightly, wrongly, late, or not at all.
#include "belief/perception/vision_model.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/belief/perception/chat_server.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using namespace std::chrono_literals;
using test::ChatServer;
using test::contains;
using test::fails;
using test::perception_error;
using test::Reaction;
using test::says;

VisionModelOptions options_for(const std::string& base) {
    VisionModelOptions options;
    options.base = base;
    options.model = "eye-1";
    options.first_pause = 5ms;
    options.longest_pause = 2000ms;
    options.limits.timeout = 5000ms;
    return options;
}

const std::vector<Message> kQuestion = {{Role::system, "Be brief.", {}},
                                        {Role::user, "What is this?", {test::kPngHead + "pixels"}}};

template <class Action>
double seconds_of(Action action) {
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(VisionModel, SpeaksTheProtocol) {
    ChatServer server([](const auto&, auto) { return says("a cup", 1000, 200); });
    ::setenv("PRAXIS_TEST_KEY", "secret-key", 1);
    VisionModelOptions options = options_for(server.base() + "/");
    options.key_variable = "PRAXIS_TEST_KEY";
    options.more = R"({"max_tokens": 77})";
    options.prompt_price = 2.5;
    options.completion_price = 10;
    VisionModel model(options);
    const ChatAnswer answer = model.ask(kQuestion, {});
    EXPECT_EQ(answer.text, "a cup");
    EXPECT_FALSE(answer.cut_off);

    const auto requests = server.requests();
    ASSERT_EQ(requests.size(), 1U);
    EXPECT_EQ(requests[0].target, "/v1/chat/completions");
    EXPECT_EQ(requests[0].headers.at("authorization"), "Bearer secret-key");
    EXPECT_EQ(requests[0].headers.at("content-type"), "application/json");
    const auto body = nlohmann::json::parse(requests[0].body);
    EXPECT_EQ(body["model"], "eye-1");
    EXPECT_EQ(body["max_tokens"], 77);
    EXPECT_EQ(body["temperature"], 0);
    EXPECT_EQ(body["response_format"]["type"], "json_object");
    ASSERT_EQ(body["messages"].size(), 2U);
    EXPECT_EQ(body["messages"][0]["role"], "system");
    EXPECT_EQ(body["messages"][0]["content"], "Be brief.");
    EXPECT_EQ(body["messages"][1]["content"][0]["text"], "What is this?");
    EXPECT_EQ(body["messages"][1]["content"][1]["image_url"]["url"],
              "data:image/png;base64,iVBORw0KGgpwaXhlbHM=");

    const VisionModelCounters counters = model.counters();
    EXPECT_EQ(counters.requests, 1);
    EXPECT_EQ(counters.retries, 0);
    EXPECT_EQ(counters.answers, 1);
    EXPECT_EQ(counters.prompt_tokens, 1000);
    EXPECT_EQ(counters.completion_tokens, 200);
    EXPECT_NEAR(counters.cost, 0.0045, 1e-12);
    EXPECT_GT(counters.seconds, 0);
}

TEST(VisionModel, AsksAgainAfterPassingFailures) {
    ChatServer server([](const auto&, std::size_t number) {
        switch (number) {
            case 0:
                return fails(500, "oops");
            case 1:
                return fails(429, R"({"error":{"message":"slow down"}})", {{"Retry-After", "0"}});
            case 2:
                return fails(200, "<html>gateway</html>");
            default:
                return says("here");
        }
    });
    VisionModel model(options_for(server.base()));
    EXPECT_EQ(model.ask(kQuestion, {}).text, "here");
    EXPECT_EQ(model.counters().requests, 4);
    EXPECT_EQ(model.counters().retries, 3);
    EXPECT_EQ(model.counters().answers, 1);
}

TEST(VisionModel, WaitsAsLongAsTheServerAsks) {
    ChatServer server([](const auto&, std::size_t number) {
        return number == 0 ? fails(429, "", {{"Retry-After", "1"}}) : says("here");
    });
    VisionModel model(options_for(server.base()));
    EXPECT_GE(seconds_of([&] { model.ask(kQuestion, {}); }), 1.0);
}

TEST(VisionModel, DoesNotWaitForEver) {
    ChatServer server([](const auto&, auto) { return fails(503, "down", {{"Retry-After", "86400"}}); });
    VisionModel model(options_for(server.base()));
    const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(error, "status 503: down")) << error;
    EXPECT_TRUE(contains(error, "86400 s")) << error;
    EXPECT_EQ(server.requests().size(), 1U);
}

TEST(VisionModel, GivesUpAfterItsAttempts) {
    ChatServer server([](const auto&, auto) { return fails(500, R"({"error":"broken"})"); });
    VisionModelOptions options = options_for(server.base());
    options.attempts = 3;
    VisionModel model(options);
    const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(error, "status 500: broken (after 3 attempts)")) << error;
    EXPECT_EQ(server.requests().size(), 3U);
    EXPECT_EQ(model.counters().answers, 0);
}

TEST(VisionModel, TellsLastingFailuresAtOnceAndWithoutTheKey) {
    ChatServer server([](const auto& request, auto) {
        return fails(401,
                     R"({"error":{"message":"bad key )" + request.headers.at("authorization") + R"("}})");
    });
    ::setenv("PRAXIS_TEST_KEY", "secret-key", 1);
    VisionModelOptions options = options_for(server.base());
    options.key_variable = "PRAXIS_TEST_KEY";
    VisionModel model(options);
    const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(error, "status 401: bad key Bearer ***")) << error;
    EXPECT_FALSE(contains(error, "secret-key")) << error;
    EXPECT_EQ(server.requests().size(), 1U);
}

TEST(VisionModel, TimesOutOnSlowAnswers) {
    for (const bool trickle : {false, true}) {
        ChatServer server([&](const auto&, auto) {
            Reaction reaction = says("late");
            (trickle ? reaction.trickle : reaction.delay) = trickle ? 20ms : 10000ms;
            return reaction;
        });
        VisionModelOptions options = options_for(server.base());
        options.limits.timeout = 150ms;
        options.attempts = 2;
        VisionModel model(options);
        std::string error;
        EXPECT_LT(seconds_of([&] { error = perception_error([&] { model.ask(kQuestion, {}); }); }), 5.0);
        EXPECT_TRUE(contains(error, "no answer in time (after 2 attempts)")) << error;
    }
}

TEST(VisionModel, SurvivesCutOffConnections) {
    // Cut before the first byte, in the status line, in the headers, in the body.
    const std::size_t whole = 400;
    for (const std::size_t cut : {std::size_t{0}, std::size_t{7}, std::size_t{40}, whole - 100}) {
        ChatServer server([&](const auto&, std::size_t number) {
            Reaction reaction = says(std::string(whole, 'x'));
            if (number < 2) reaction.cut_at = cut;
            return reaction;
        });
        VisionModel model(options_for(server.base()));
        EXPECT_EQ(model.ask(kQuestion, {}).text, std::string(whole, 'x')) << cut;
        EXPECT_EQ(model.counters().retries, 2);
    }
}

TEST(VisionModel, TellsThatNothingListens) {
    VisionModel model(options_for("http://127.0.0.1:" + std::to_string(test::closed_port()) + "/v1"));
    const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(error, "connecting to '127.0.0.1:")) << error;
    EXPECT_TRUE(contains(error, "after 4 attempts")) << error;
}

TEST(VisionModel, RefusesHugeAnswers) {
    ChatServer server([](const auto&, std::size_t number) {
        Reaction reaction = says(std::string(300000, 'x'));
        if (number == 1) {  // a length that is a lie
            reaction.raw = "HTTP/1.1 200 OK\r\nContent-Length: 99999999999\r\n\r\n" + std::string(1000, 'x');
        } else if (number == 2) {  // no length at all
            reaction.raw = "HTTP/1.1 200 OK\r\n\r\n" + std::string(300000, 'x');
        } else if (number == 3) {
            reaction.raw = "HTTP/1.1 200 OK\r\nX: " + std::string(300000, 'x') + "\r\n\r\n";
        }
        return reaction;
    });
    VisionModelOptions options = options_for(server.base());
    options.limits.answer_bytes = 100000;
    VisionModel model(options);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
        EXPECT_TRUE(contains(error, "is larger than 100000 bytes")) << i << ": " << error;
        EXPECT_EQ(server.requests().size(), i + 1);
    }
}

TEST(VisionModel, AsksAgainAfterAnswersOfNoProtocol) {
    const std::vector<std::string> bodies = {"",
                                             "null",
                                             "[]",
                                             "{}",
                                             R"({"choices":[]})",
                                             R"({"choices":[7]})",
                                             R"({"choices":[{"message":7}]})",
                                             R"({"choices":[{"message":{}}]})",
                                             R"({"choices":[{"message":{"content":null}}]})",
                                             R"({"choices":[{"message":{"content":[1]}}]})",
                                             R"({"choices":{"0":1}})",
                                             "\xff\xfe",
                                             "{\"choices\":"};
    ChatServer server([&](const auto&, std::size_t number) {
        return number < bodies.size() ? fails(200, bodies[number]) : says("here");
    });
    VisionModelOptions options = options_for(server.base());
    options.attempts = static_cast<int>(bodies.size()) + 1;
    options.longest_pause = 1ms;
    VisionModel model(options);
    EXPECT_EQ(model.ask(kQuestion, {}).text, "here");
    EXPECT_EQ(server.requests().size(), bodies.size() + 1);
}

TEST(VisionModel, ReadsTheVariantsOfAnAnswer) {
    ChatServer server([&](const auto&, std::size_t number) {
        if (number == 0) {
            return fails(200, R"({"choices":[{"finish_reason":"length","message":{"content":[)"
                              R"({"type":"text","text":"in "},{"type":"text","text":"parts"}]}}],)"
                              R"("usage":{"prompt_tokens":-5,"completion_tokens":"many"}})");
        }
        return fails(200, R"({"choices":[{"message":{"content":null,"refusal":"I will not"}}]})");
    });
    VisionModel model(options_for(server.base()));
    const ChatAnswer answer = model.ask(kQuestion, {});
    EXPECT_EQ(answer.text, "in parts");
    EXPECT_TRUE(answer.cut_off);
    EXPECT_EQ(answer.prompt_tokens, 0);
    const std::string error = perception_error([&] { model.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(error, "refuses to answer: I will not")) << error;
}

TEST(VisionModel, StopsAtOnce) {
    ChatServer slow([](const auto&, auto) {
        Reaction reaction = says("late");
        reaction.delay = 30000ms;
        return reaction;
    });
    ChatServer busy([](const auto&, auto) { return fails(429, "", {{"Retry-After", "30"}}); });
    for (ChatServer* server : {&slow, &busy}) {
        VisionModelOptions options = options_for(server->base());
        options.longest_pause = 60000ms;
        options.limits.timeout = 60000ms;
        VisionModel model(options);
        std::stop_source source;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(100ms);
            source.request_stop();
        });
        const double seconds =
            seconds_of([&] { EXPECT_THROW(model.ask(kQuestion, source.get_token()), StoppedError); });
        EXPECT_LT(seconds, 5.0);  // 0.1 and what a loaded machine adds
        const double at_once =
            seconds_of([&] { EXPECT_THROW(model.ask(kQuestion, source.get_token()), StoppedError); });
        EXPECT_LT(at_once, 5.0);
    }
}

TEST(VisionModel, SendsLargeImagesAndHearsThatTheyAreTooLarge) {
    ChatServer server([](const auto&, auto) { return fails(413, "too large"); });
    VisionModel model(options_for(server.base()));
    const std::vector<Message> large = {{Role::user, "look", {test::kPngHead + std::string(9U << 20U, 'p')}}};
    const std::string error = perception_error([&] { model.ask(large, {}); });
    EXPECT_TRUE(contains(error, "status 413: too large")) << error;
    ASSERT_EQ(server.requests().size(), 1U);
    EXPECT_GT(server.requests()[0].body.size(), 12U << 20U);
}

TEST(VisionModel, TrustsOnlyCertifiedServers) {
    ChatServer server([](const auto&, auto) { return says("safe"); }, true);
    ChatServer impostor([](const auto&, auto) { return says("not safe"); }, true, "elsewhere.example");
    const test::TemporaryFile trusted;
    trusted.write(server.certificate() + impostor.certificate());

    VisionModelOptions options = options_for(server.base());
    VisionModel stranger(options);
    const std::string unknown = perception_error([&] { stranger.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(unknown, "TLS handshake")) << unknown;
    EXPECT_EQ(stranger.counters().requests, 1);

    options.limits.certificates = trusted.path();
    VisionModel model(options);
    EXPECT_EQ(model.ask(kQuestion, {}).text, "safe");

    options.base = impostor.base();
    VisionModel deceived(options);
    const std::string other_name = perception_error([&] { deceived.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(other_name, "TLS handshake")) << other_name;
    EXPECT_TRUE(impostor.requests().empty());

    options.limits.certificates = "/does/not/exist.pem";
    VisionModel careless(options);
    const std::string missing = perception_error([&] { careless.ask(kQuestion, {}); });
    EXPECT_TRUE(contains(missing, "cannot read the certificates")) << missing;
}

TEST(VisionModel, FindsHostsByName) {
    ChatServer server([](const auto&, auto) { return says("here"); });
    std::string base = server.base();
    base.replace(base.find("127.0.0.1"), 9, "localhost");
    VisionModel model(options_for(base));
    EXPECT_EQ(model.ask(kQuestion, {}).text, "here");
}

TEST(VisionModel, RefusesOptionsThatMakeNoSense) {
    const auto error_with = [](auto change) {
        VisionModelOptions options = options_for("http://localhost/v1");
        change(options);
        return perception_error([&] { VisionModel{options}; });
    };
    ::unsetenv("PRAXIS_TEST_NO_KEY");
    ::setenv("PRAXIS_TEST_BAD_KEY", "key\r\nX-Header: 1", 1);
    EXPECT_EQ(error_with([](auto&) {}), "");
    EXPECT_EQ(error_with([](auto& o) { o.key_variable = "PRAXIS_TEST_NO_KEY"; }),
              "no key: set the environment variable PRAXIS_TEST_NO_KEY");
    EXPECT_TRUE(contains(error_with([](auto& o) { o.key_variable = "PRAXIS_TEST_BAD_KEY"; }), "unprintable"));
    EXPECT_TRUE(contains(error_with([](auto& o) { o.model = ""; }), "name the model"));
    EXPECT_TRUE(contains(error_with([](auto& o) { o.attempts = 0; }), "attempt"));
    EXPECT_TRUE(contains(error_with([](auto& o) { o.more = "[1]"; }), "JSON object"));
    EXPECT_TRUE(contains(error_with([](auto& o) { o.base = "ftp://x"; }), "http://"));
    EXPECT_TRUE(contains(error_with([](auto& o) { o.limits.timeout = 0ms; }), "positive"));
    VisionModel model(options_for("http://localhost/v1"));
    EXPECT_TRUE(contains(perception_error([&] {
                             model.ask({{Role::user, "", {"GIF89a"}}}, {});
                         }),
                         "neither PNG nor JPEG"));
}

}  // namespace
}  // namespace praxis::belief
