// Expressions have the values that arithmetic and logic give them, and those that cannot be are refused.
#include <algorithm>
#include <cmath>
#include <set>

#include "tests/unit/stage/stage_world.h"

namespace
{

// The value of the variable `name`, set to an expression when an agent at 3 s and x = 0 enters its first state. Agents
// of the class "owl" stand at x = 2 and 4.
double value_of(const std::string &expression, const char *name = "n")
{
    StageWorld world;
    const clq_machine still = world.machine(machine_text("[states.a]\ninitial = true\n"));
    world.agent(still, 2, "owl"), world.agent(still, 4, "owl");
    const clq_machine machine = world.machine(machine_text("[states.a]\ninitial = true\nenter = [ { set = \"" +
                                                           std::string(name) + "\", to = '" + expression + "' } ]\n"));
    clq_agent_def def = clq_agent_def_init();
    def.machine = machine, def.tmpl = world.arm.tmpl, def.start_s = 3, def.seed = 8;
    clq_agent agent{};
    EXPECT_EQ(clq_stage_add_agent(world.stage, &def, &agent), CLQ_OK) << clq_last_error();
    world.step(3.2);
    return world.variable(agent, name);
}

TEST(Expression, OfNumbersHasTheValueOfArithmetic)
{
    const struct {
        const char *text;
        double value;
    } all[] = {{"1 + 2 * 3", 7},
               {"(1 + 2) * 3", 9},
               {"7 - 2 - 1", 4},
               {"8 / 4 / 2", 1},
               {"-2 * -3", 6},
               {"- -5", 5},
               {"2 - -1", 3},
               {".5 + 1.25", 1.75},
               {"1e2", 100},
               {"min(3, 2)", 2},
               {"min(2, 3)", 2},
               {"max(3, 2)", 3},
               {"max(2, 3)", 3},
               {"abs(-4)", 4},
               {"abs(4)", 4},
               {"floor(-1.5)", -2},
               {"floor(1.5)", 1},
               {"\tn\t+ 1 ", 1},
               {"crowd.mood + 2", 2},
               {"clock", 3},
               {"time", 0},
               {"count(\"owl\", 3)", 1},
               {"count(\"owl\", 5)", 2},
               {"count(\"cat\", 5)", 0},
               {"near(\"owl\")", 2},
               {"random(4, 4)", 4}};
    for (const auto &one : all) EXPECT_EQ(value_of(one.text), one.value) << one.text;
    const double drawn = value_of("random(10, 20)");
    EXPECT_TRUE(drawn >= 10 && drawn < 20) << drawn;
}

// Weidmann 1993: 1.34 m/s in the mean, with a deviation of 0.26.
TEST(Expression, OwnSpeedIsTheAgentsAndNormal)
{
    StageWorld world;
    const clq_machine machine =
        world.machine(machine_text("[states.a]\ninitial = true\nenter = [ { set = 'n', to = 'own_speed' }, { set = "
                                   "'log', to = 'own_speed' } ]\n"));
    constexpr uint64_t count = 4000;
    std::vector<clq_agent> agents;
    for (uint64_t seed = 1; seed <= count; ++seed) agents.push_back(world.agent(machine, 0, nullptr, seed));
    world.step(0.2);
    double sum = 0, squares = 0, least = 9, most = 0;
    std::set<double> all;
    int within_one = 0;
    for (const clq_agent agent : agents) {
        const double own = world.variable(agent, "n");
        EXPECT_EQ(world.variable(agent, "log"), own) << "it never changes";
        sum += own, squares += own * own;
        least = std::min(least, own), most = std::max(most, own);
        within_one += std::fabs(own - 1.34) < 0.26;
        all.insert(own);
    }
    EXPECT_NEAR(sum / count, 1.34, 0.015);
    EXPECT_NEAR(std::sqrt(squares / count - sum / count * (sum / count)), 0.257, 0.01);
    EXPECT_NEAR(within_one / double(count), 0.683, 0.025);
    EXPECT_NEAR(least, 1.34 - 2.5 * 0.26, 1e-9);
    EXPECT_NEAR(most, 1.34 + 2.5 * 0.26, 1e-9);
    EXPECT_GT(all.size(), count * 95 / 100);
}

TEST(Expression, OfTruthsHasTheValueOfLogic)
{
    const struct {
        const char *text;
        bool value;
    } all[] = {{"true", true},
               {"false", false},
               {"not true", false},
               {"not not true", true},
               {"true and true", true},
               {"true and false", false},
               {"false and true", false},
               {"false or true", true},
               {"true or false", true},
               {"false or false", false},
               {"false and false or true", true},
               {"false and (false or true)", false},
               {"1 < 2", true},
               {"2 < 2", false},
               {"2 <= 2", true},
               {"3 <= 2", false},
               {"3 > 2", true},
               {"2 > 2", false},
               {"2 >= 2", true},
               {"1 >= 2", false},
               {"2 == 2", true},
               {"2 == 3", false},
               {"2 != 3", true},
               {"3 != 2", true},
               {"2 != 2", false},
               {"0 / 0 == 0 / 0", false},
               {"0 / 0 != 0 / 0", false},
               {"true == true", true},
               {"true == false", false},
               {"true != false", true},
               {"in_view", true},
               {"walking", false},
               {"open", false}};
    for (const auto &one : all) EXPECT_EQ(value_of(one.text, "open"), one.value) << one.text;
}

TEST(Expression, ThatCannotBeIsRefusedWithWhatIsWrong)
{
    StageWorld world;
    const auto wrong = [&](const std::string &expression, const std::string &rule) {
        const std::string said = world.refusal(
            machine_text("[states.a]\ninitial = true\nenter = [ { set = \"n\", to = '''" + expression + "''' } ]\n"));
        EXPECT_NE(said.find(rule), std::string::npos) << said << "\n" << expression;
    };
    wrong("", "the expression ends where a value is expected");
    wrong("1 +", "the expression ends where a value is expected");
    wrong("?", "'?' is no value");
    wrong("1 2", "'2' does not continue the expression");
    wrong("n or 1", "'or' needs a truth, and this is a number");
    wrong("not 1", "'not' needs a truth, and this is a number");
    wrong("true + 1", "'+' needs a number, and this is a truth");
    wrong("1 - true", "'-' needs a number, and this is a truth");
    wrong("-true", "'-' needs a number, and this is a truth");
    wrong("true < 1", "'<' needs a number, and this is a truth");
    wrong("true == 1", "'==' needs a truth, and this is a number");
    wrong("min(1)", "',' is missing");
    wrong("min(true, 1)", "'min' needs a number, and this is a truth");
    wrong("abs(1, 2)", "')' is missing");
    wrong("count(\"owl\")", "',' is missing");
    wrong("near('owl)", "''' is missing");
    wrong("near(\"owl", "'\"' is missing");
    wrong("near()", "'\"' is missing");
    wrong("crowd.fame", "'crowd.fame' is not known; there are: n, log, open, crowd.mood, time");
    wrong("fame(1)", "'fame' is no function; there are: min, max, abs");
    wrong("1e999", "this is no number");
    wrong("1 + 9007199254740993", "this whole number would be rounded to 9007199254740992");
    wrong("18446744073709551615", "this whole number would be rounded to 18446744073709551616");
    wrong(".", "this is no number");
    wrong("1 < 2", "'to' is a condition: a number is wanted");
    const std::string open(40, '('), signs(40, '-');
    wrong(open + "1" + std::string(40, ')'), "inside each other");
    wrong(signs + "1", "inside each other");
    std::string many = "1", deep;
    for (int i = 0; i < 300; ++i) many += "+1";
    wrong(many, "the expression has more than 256 operations");
    for (int i = 0; i < 31; ++i) deep += "1+(";
    wrong(deep + "1" + std::string(31, ')'), "the expression holds more than 32 values at once");
}

}  // namespace
