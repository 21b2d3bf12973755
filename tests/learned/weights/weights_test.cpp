#include "learned/weights/weights_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "learned/maps/navigation.hpp"
#include "learned/weights/planner_json.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

PlannerOptions options_of(const std::string& model, const std::string& group) {
    PlannerOptions options;
    options.model = model;
    options.group = group;
    options.fields = 3;
    options.iterations = 4;
    return options;
}

class WeightsFile : public testing::Test {
  protected:
    WeightsFile()
        : name((std::filesystem::temp_directory_path() /
                (std::string("praxis_weights_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name()))
                   .string()) {
        write_planner(name, *planner, {{"command", "a test"}});
        std::ifstream stream(name, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(stream), {});
    }
    ~WeightsFile() override { std::filesystem::remove(name); }

    /// The file with other contents, and a checksum that agrees.
    void expect_refused(ArrayFile contents, const std::string& reason) const {
        write_array_file(name, contents);
        expect_refused_as_it_is(reason);
    }
    void expect_refused_as_it_is(const std::string& reason) const {
        try {
            read_planner(name);
            FAIL() << "accepted, though: " << reason;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find(name), 0u);
        }
    }

    const std::unique_ptr<Planner<float>> planner = make_planner<float>(options_of("vin", "d4"), 1);
    const std::string name;
    std::string bytes;
};

TEST_F(WeightsFile, GivesThePlannerBack) {
    for (const auto& [model, group] : std::initializer_list<std::pair<const char*, const char*>>{
             {"vin", "c1"}, {"vin", "d4"}, {"gru", "c4"}, {"lstm", "c1"}}) {
        PlannerOptions options = options_of(model, group);
        options.padding = Padding::circular;
        options.contraction = 0.1 + 0.2;
        if (options.model == "gru") options.differentiation = Differentiation::implicit;
        const auto written = make_planner<float>(options, 7);
        EXPECT_EQ(written->parameters().size(), parameter_count(options));
        write_planner(name, *written, {{"seed", 7}});
        const ReadPlanner read = read_planner(name);
        EXPECT_EQ(read.planner->options(), options);
        EXPECT_TRUE(std::ranges::equal(read.planner->parameters(), written->parameters()));
        EXPECT_EQ(read.origin["seed"], 7);
    }
}

TEST_F(WeightsFile, CutOffAnywhereIsRefused) {
    for (std::size_t length = 0; length < bytes.size(); length += length < 64 ? 1 : 37)
        EXPECT_THROW(parse_array_file(bytes.substr(0, length), "x"), InputError) << length;
    EXPECT_THROW(parse_array_file(bytes + "x", "x"), InputError);
    EXPECT_NO_THROW(parse_array_file(bytes, "x"));
}

TEST_F(WeightsFile, WithAnyByteChangedIsRefused) {
    Random random(1);
    for (std::size_t at = 0; at < bytes.size(); at += at < 600 ? 1 : 13) {
        std::string other = bytes;
        other[at] = static_cast<char>(other[at] ^ (1 << random.below(8)));
        EXPECT_THROW(parse_array_file(other, "x"), InputError) << at;
    }
}

TEST_F(WeightsFile, OfNoiseIsRefused) {
    Random random(2);
    for (int k = 0; k < 500; ++k) {
        std::string noise = random.below(2) ? bytes.substr(0, 16) : std::string();
        for (std::size_t i = random.below(300); i-- > 0;) noise += static_cast<char>(random.next());
        EXPECT_THROW(parse_array_file(noise, "x"), InputError);
    }
}

TEST_F(WeightsFile, IsRefusedWithTheReason) {
    std::ofstream(name, std::ios::binary) << "PK something else";
    expect_refused_as_it_is("does not start with PRAXISNN");
    std::string later = bytes;
    later[8] = 2;
    std::ofstream(name, std::ios::binary) << later;
    expect_refused_as_it_is("version 2");
    std::string changed = bytes;
    changed[changed.size() - 100] = static_cast<char>(changed[changed.size() - 100] ^ 1);
    std::ofstream(name, std::ios::binary) << changed;
    expect_refused_as_it_is("checksum");
    std::filesystem::remove(name);
    expect_refused_as_it_is("cannot be opened");
}

TEST_F(WeightsFile, ThatDoesNotFitItsHeaderIsRefusedWithTheReason) {
    const ArrayFile good = planner_contents(*planner, {});
    const auto with = [&](const char* option, const nlohmann::json& value) {
        ArrayFile other = good;
        other.header["planner"][option] = value;
        return other;
    };
    expect_refused(with("fields", 4), "the planner that the header describes has");
    expect_refused(with("fields", 0), "fields must be");
    expect_refused(with("fields", -1), "'fields' has no sensible value");
    expect_refused(with("fields", 1e300), "'fields' has no sensible value");
    expect_refused(with("fields", "many"), "'fields' has no sensible value");
    expect_refused(with("model", "oracle"), "unknown model");
    expect_refused(with("group", "d8"), "unknown symmetry group");
    expect_refused(with("padding", "reflect"), "'padding' has no sensible value");
    expect_refused(with("colour", 1), "does not know");
    expect_refused(with("iterations", 1), "self-test of these weights fails");
    expect_refused(with("radius", 2), "the planner that the header describes has");
    ArrayFile other = good;
    other.header["planner"].erase("group");
    expect_refused(other, "'group' is missing");
    other = good;
    other.header.erase("planner");
    expect_refused(other, "nothing about a planner");
    other = good;
    other.arrays[0].second[0] = std::numeric_limits<float>::infinity();
    expect_refused(other, "not finite");
    other = good;
    other.arrays[0].second[0] += 1;
    expect_refused(other, "self-test of these weights fails:");
    other = good;
    other.arrays[1].second.pop_back();
    expect_refused(other, "has another size");
    other = good;
    other.arrays.pop_back();
    expect_refused(other, "'self-test' is missing");
}

TEST_F(WeightsFile, ThatCannotBeWrittenIsAnError) {
    EXPECT_THROW(write_planner("/no/such/folder/weights", *planner, {}), InputError);
}

TEST(PlannerJson, IsReadBackExactly) {
    PlannerOptions options = options_of("gru", "c4");
    options.tolerance = 1.0 / 3;
    options.differentiation = Differentiation::implicit;
    EXPECT_EQ(planner_options(nlohmann::json::parse(to_json(options).dump())), options);
}

TEST(ParameterCount, AgreesWithThePlanner) {
    for (const char* model : {"vin", "gru", "lstm"})
        for (const char* group : {"c1", "c4", "d4"})
            for (const int radius : {1, 2}) {
                PlannerOptions options = options_of(model, group);
                options.radius = radius;
                options.input_radius = 3 - radius;
                EXPECT_EQ(parameter_count(options), make_planner<double>(options, 1)->layout().size());
            }
}

}  // namespace
}  // namespace praxis::learned
