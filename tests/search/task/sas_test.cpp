#include "search/task/sas.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "parser/diagnostic.hpp"

namespace praxis {
namespace {

// A lamp behind a derived door, with a conditional effect, a prevail condition and costs.
const char* const kLamp = R"(begin_version
3
end_version
begin_metric
1
end_metric
4
begin_variable
var0
-1
3
Atom at(robot, hall)
Atom at(robot, room)
<none of those>
end_variable
begin_variable
var1
-1
2
Atom lit(lamp)
NegatedAtom lit(lamp)
end_variable
begin_variable
var2
0
2
Atom open()
NegatedAtom open()
end_variable
begin_variable
var3
-1
2
Atom key()
NegatedAtom key()
end_variable
1
begin_mutex_group
2
0 0
1 0
end_mutex_group
begin_state
0
1
1
0
end_state
begin_goal
2
1 0
0 0
end_goal
2
begin_operator
enter hall room
2
3 0
2 0
1
0 0 0 1
7
end_operator
begin_operator
press
0
2
2 3 0 0 1 1 -1 0
0 3 -1 1
0
end_operator
1
begin_rule
2
3 0
0 0
2 1 0
end_rule
)";

FiniteDomainTask read(const std::string& text) {
    return read_sas({"test.sas", text});
}

std::string write(const FiniteDomainTask& task) {
    std::ostringstream out;
    write_sas(task, out);
    return out.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string error_of(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SasReader, ReadsEverySection) {
    const FiniteDomainTask task = read(kLamp);
    EXPECT_FALSE(task.unit_cost);
    EXPECT_EQ(task.domain_sizes, (std::vector<std::int32_t>{3, 2, 2, 2}));
    EXPECT_EQ(task.axiom_layers, (std::vector<std::int32_t>{-1, -1, 0, -1}));
    EXPECT_EQ(task.initial_values, (std::vector<std::int32_t>{0, 1, 1, 0}));
    EXPECT_EQ(task.fact_count(), 9u);
    EXPECT_EQ(task.fact_name({0, 1}), "Atom at(robot, room)");
    EXPECT_EQ(task.fact_name({0, 2}), "<none of those>");
    EXPECT_EQ(task.fact_name({1, 1}), "NegatedAtom lit(lamp)");
    EXPECT_EQ(task.fact_name({3, 0}), "Atom key()");
    EXPECT_EQ(task.fact_names.words(task.fact_number({0, 0})), "at robot hall");
    EXPECT_EQ(task.goal, (std::vector<Fact>{{0, 0}, {1, 0}}));
    ASSERT_EQ(task.mutex_groups.size(), 1u);
    EXPECT_EQ(task.mutex_groups[0][1], (Fact{1, 0}));

    ASSERT_EQ(task.operator_count(), 2u);
    EXPECT_EQ(task.operator_name(OperatorId(0)), "(enter hall room)");
    EXPECT_EQ(task.costs, (std::vector<std::int32_t>{7, 0}));
    ASSERT_EQ(task.preconditions[0].size(), 3u);
    EXPECT_EQ(task.preconditions[0][0], (Fact{0, 0}));
    EXPECT_EQ(task.preconditions[0][2], (Fact{3, 0}));
    EXPECT_TRUE(task.preconditions[1].empty());
    ASSERT_EQ(task.effects[1].size(), 2u);
    const auto condition = task.conditions[task.effects[1][0].condition];
    ASSERT_EQ(condition.size(), 2u);
    EXPECT_EQ(condition[0], (Fact{0, 1}));
    EXPECT_EQ(condition[1], (Fact{3, 0}));
    EXPECT_EQ(task.effects[1][1].condition, 0u);

    ASSERT_EQ(task.axioms.size(), 1u);
    EXPECT_EQ(task.axioms[0].head, (Fact{2, 0}));
    EXPECT_EQ(task.axiom_bodies[0][0], (Fact{0, 0}));
    EXPECT_GT(task.memory(), 9 * sizeof(std::uint32_t));
}

TEST(SasReader, WithoutMetricEveryOperatorCostsOne) {
    const FiniteDomainTask task = read(replaced(kLamp, "begin_metric\n1", "begin_metric\n0"));
    EXPECT_TRUE(task.unit_cost);
    EXPECT_EQ(task.costs, (std::vector<std::int32_t>{1, 1}));
}

TEST(SasWriter, WritingWhatWasReadIsStable) {
    const std::string once = write(read(kLamp));
    EXPECT_EQ(write(read(once)), once);
    EXPECT_NE(once.find("enter hall room\n2\n2 0\n3 0\n1\n0 0 0 1\n7\n"), std::string::npos) << once;
    EXPECT_NE(once.find("2 0 1 3 0 1 -1 0\n"), std::string::npos) << once;
    EXPECT_NE(once.find("begin_rule\n2\n0 0\n3 0\n2 1 0\nend_rule\n"), std::string::npos) << once;
}

TEST(SasWriter, GivesTasksWithoutGoalOne) {
    FiniteDomainTask task = read(kLamp);
    task.goal.clear();
    const FiniteDomainTask solved = read(write(task));
    EXPECT_EQ(solved.goal, (std::vector<Fact>{{4, 0}}));
    EXPECT_EQ(solved.initial_values.back(), 0);
    task.proved_unsolvable = true;
    const FiniteDomainTask unsolvable = read(write(task));
    EXPECT_EQ(unsolvable.goal, (std::vector<Fact>{{4, 1}}));
    EXPECT_EQ(unsolvable.operator_count(), 2u);
}

TEST(SasWriter, WritesATaskWithNothingInIt) {
    FiniteDomainTask task;
    task.first_fact = {0};
    const FiniteDomainTask again = read(write(task));
    EXPECT_EQ(again.variable_count(), 1u);
    EXPECT_EQ(again.goal.size(), 1u);
}

TEST(SasReader, AcceptsOtherNamesAndWindowsLines) {
    std::string text = replaced(kLamp, "Atom at(robot, room)", "my own name");
    text = replaced(text, "Atom open()", "Atom open");
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    const FiniteDomainTask task = read(text);
    EXPECT_EQ(task.fact_name({0, 1}), "Atom my own name()");
    EXPECT_EQ(task.fact_name({2, 0}), "Atom open()");
    EXPECT_EQ(write(read(write(task))), write(task));
}

TEST(SasReader, NamesThePlaceOfAMistake) {
    const std::string error = error_of(replaced(kLamp, "0 0 0 1\n7", "0 0 0 9\n7"));
    EXPECT_NE(error.find("test.sas:61:7"), std::string::npos) << error;
    EXPECT_NE(error.find("the value must be from 0 to 2"), std::string::npos) << error;
}

TEST(SasReader, RefusesWhatIsWrong) {
    const auto expect = [](const std::string& from, const std::string& to, const std::string& message) {
        const std::string error = error_of(replaced(kLamp, from, to));
        EXPECT_NE(error.find(message), std::string::npos) << from << " -> " << to << ": " << error;
    };
    expect("begin_version\n3", "begin_version\n2", "the version of the format must be");
    expect("begin_metric\n1", "begin_metric\ntrue", "expected a number: the metric");
    expect("4\nbegin_variable", "2000000000\nbegin_variable", "more than the rest of the file can hold");
    expect("4\nbegin_variable", "99999999999999999999\nbegin_variable", "must be from 0");
    expect("4\nbegin_variable", "5\nbegin_variable", "expected 'begin_variable'");
    expect("4\nbegin_variable", "4 4\nbegin_variable", "unexpected text at the end of the line");
    expect("-1\n3\nAtom", "-2\n3\nAtom", "the axiom layer must be");
    expect("-1\n3\nAtom", "-1\n0\nAtom", "the domain size must be");
    expect("-1\n3\nAtom", "0\n3\nAtom", "a derived variable must have domain size 2");
    expect("begin_state\n0", "begin_state\n3", "the initial value must be");
    expect("2\n1 0\n0 0\nend_goal", "2\n1 0\n1 1\nend_goal", "two values of variable 1");
    expect("2\n1 0\n0 0\nend_goal", "3\n1 0\n0 0\nend_goal", "expected a number: the variable");
    expect("0 3 -1 1", "0 2 -1 1", "an operator cannot set a derived variable");
    expect("0 3 -1 1", "0 4 -1 1", "the variable must be from 0 to 3");
    expect("0 3 -1 1\n0\n", "0 3 -1 1\n-4\n", "the cost must be");
    expect("2 0\n1\n0 0 0 1", "0 1\n1\n0 0 0 1", "two values of variable 0");
    expect("2 1 0\nend_rule", "3 1 0\nend_rule", "an axiom must set a derived variable");
    expect("2 1 0\nend_rule", "2 0 0\nend_rule", "an axiom must change the default value");
    expect("2 1 0\nend_rule", "2 1 1\nend_rule", "another than the default value");
    expect("begin_rule\n2\n3 0", "begin_rule\n2\n2 1", "breaks the order of the axiom layers");
    expect("end_rule\n", "end_rule\nmore\n", "unexpected text after the last axiom");
}

TEST(SasReader, RefusesEveryTruncation) {
    const std::string text = kLamp;
    for (std::size_t length = 0; length + 1 < text.size(); ++length) {
        EXPECT_THROW(read(text.substr(0, length)), InputError) << length;
    }
}

}  // namespace
}  // namespace praxis
