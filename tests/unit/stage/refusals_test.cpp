// Files that are no machines are refused by line, column and rule.
#include "tests/unit/stage/stage_world.h"

namespace
{

const std::string head = "machine = \"m\"\n[variables]\nn = 0\nopen = false\n[events]\ngo = 0\n";  // six lines

struct Wrong {
    std::string text, place, rule;
};

void expect_refused(const std::vector<Wrong> &all)
{
    StageWorld world;
    for (const Wrong &wrong : all) {
        const std::string said = world.refusal(head + wrong.text);
        EXPECT_NE(said.find("m.toml, " + wrong.place + ":"), std::string::npos) << said << "\n" << wrong.text;
        EXPECT_NE(said.find(wrong.rule), std::string::npos) << said << "\n" << wrong.text;
    }
    EXPECT_EQ(world.info().machines, 0u);
}

TEST(MachineFile, WithoutItsStatesInOrderIsRefused)
{
    expect_refused({
        {"[states.a]\ninitial = true\ntransitions = [ { on = \"go\", to = \"b\" } ]\n", "line 9, column 35",
         "there is no state 'b'"},
        {"[states.a]\n[states.b]\ninitial = true\n", "line 7, column 1", "nothing leads to the state 'a'"},
        {"[states.a]\ninitial = true\n[states.b]\ninitial = true\n", "line 10, column 11",
         "two initial states beside each other: 'a' and 'b'"},
        {"[states.a]\n[states.b]\n", "line 7, column 1", "the machine has no initial state among its 2"},
        {"[states.a.states.x]\n[states.a.states.y]\n", "line 7, column 1", "state 'a' has no initial state"},
        {"[states.a]\ninitial = true\n[states.a.states.a]\n", "line 9, column 18",
         "two states are called 'a': the other is in line 7"},
        {"[states.a]\ninitial = true\n[states.a.states.b]\n[states.a.states.b.states.c]\n[states.d]\n"
         "transitions = [ { on = \"go\", to = \"c\" } ]\n",
         "line 11, column 1", "nothing leads to the state 'd'"},
        {"[states]\n", "line 7, column 1", "'states' holds no state"},
        {"[states.a]\nentre = []\n", "line 8, column 1", "'entre' is not known here: 'enter' is near"},
        {"[states.a\n", "line 7, column 10", "not TOML"},
    });
}

TEST(MachineFile, WithTransitionsThatCannotBeIsRefused)
{
    const std::string a = "[states.a]\ninitial = true\ntransitions = [\n";
    expect_refused({
        {a + "{ on = \"went\", to = \"a\" } ]\n", "line 10, column 8", "there is no event 'went' in [events]"},
        {a + "{ on = \"go\", after = 1, to = \"a\" } ]\n", "line 10, column 22", "one of on, after, end and marker"},
        {a + "{ on = \"go\" } ]\n", "line 10, column 1", "neither 'to' nor 'do'"},
        {a + "{ on = \"go\", before = 1, to = \"a\" } ]\n", "line 10, column 23", "'before' belongs to 'end'"},
        {a + "{ on = \"go\", to = \"a\", history = \"deep\" } ]\n", "line 10, column 34", "no states within"},
        {a + "{ on = \"go\", to = [\"a\", \"a\"], weights = [1] } ]\n", "line 10, column 41", "1 weights for 2 states"},
        {a + "{ after = [3, 1], to = \"a\" } ]\n", "line 10, column 11", "its greatest number first"},
        {a + "{ after = -1, to = \"a\" } ]\n", "line 10, column 11", "'after' is -1"},
        {a + "{ after = nan, to = \"a\" } ]\n", "line 10, column 11", "not finite"},
        {a + "{ after = 9007199254740993, to = \"a\" } ]\n", "line 10, column 11",
         "'after' is 9007199254740993, a whole"},
        {a + "{ marker = \"up\", to = \"a\" } ]\nenter = [ { play = \"slow\" } ]\n", "line 10, column 12",
         "no clip that the machine plays has a marker 'up' in the template 'strip'"},
    });
}

TEST(MachineFile, WithInstantTransitionsWithoutEndIsRefused)
{
    const std::string a = "[states.a]\ninitial = true\ntransitions = [\n";
    expect_refused({
        {a + "{ to = \"a\" } ]\n", "line 10, column 1", "again and again without time passing"},
        {a + "{ do = [ { set = \"n\", to = 1 } ] } ]\n", "line 10, column 1", "again and again"},
        {a + "{ if = \"true\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ to = \"a\" } ]\n", "line 10, column 1",
         "those in line 13 would be taken in turn for ever"},
        {a + "{ if = \"n > 0 and open\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ if = \"n < 5\", to = \"a\" } "
             "]\n",
         "line 10, column 1", "in turn for ever"},
        {a + "{ on = \"go\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ if = \"open\", to = \"c\" } ]\n"
             "[states.b.states.c]\n",
         "line 13, column 1", "again and again"},
    });
    StageWorld world;
    const auto accepted = [&](const std::string &rest) { EXPECT_EQ(world.refusal(head + a + rest), "") << rest; };
    accepted("{ if = \"n > 0\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ if = \"n < 0\", to = \"a\" } ]\n");
    accepted("{ if = \"n >= 1\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ if = \"n < 1\", to = \"a\" } ]\n");
    accepted("{ if = \"open\", to = \"b\" } ]\n[states.b]\ntransitions = [\n{ if = \"not open\", to = \"a\" } ]\n");
    accepted(
        "{ if = \"n > 0\", to = \"b\", do = [ { set = \"n\", to = \"n - 1\" } ] } ]\n[states.b]\n"
        "transitions = [ { to = \"a\" } ]\n");
    accepted(
        "{ if = \"n > 0\", to = \"b\" } ]\n[states.b]\nenter = [ { set = \"n\", to = 0 } ]\n"
        "transitions = [ { to = \"a\" } ]\n");
}

TEST(MachineFile, WithActionsThatCannotBeIsRefused)
{
    const std::string a = "[states.a]\nenter = [\n";
    expect_refused({
        {a + "{ play = \"slwo\" } ]\n", "line 9, column 10", "the template 'strip' has no clip 'slwo'"},
        {a + "{ call = \"ring\" } ]\n", "line 9, column 10", "there is no action 'ring' of the host"},
        {a + "{ set = \"m\", to = 1 } ]\n", "line 9, column 9", "there is no variable 'm' to set"},
        {a + "{ set = \"crowd.n\", to = 1 } ]\n", "line 9, column 9", "there is no variable 'crowd.n' to set"},
        {a + "{ set = \"open\", to = 1 } ]\n", "line 9, column 22", "'open' is true or false"},
        {a + "{ set = \"open\", to = \"n\" } ]\n", "line 9, column 23", "a condition is wanted"},
        {a + "{ set = \"n\" } ]\n", "line 9, column 1", "'set' needs 'to'"},
        {a + "{ send = \"come\" } ]\n", "line 9, column 10", "there is no event 'come'"},
        {a + "{ send = \"go\", to = \"self\", radius = 3 } ]\n", "line 9, column 38", "'radius' chooses among all"},
        {a + "{ gesture = \"wave\", mask = \"arms\" } ]\n", "line 9, column 28", "there is no mask 'arms'"},
        {a + "{ go = \"home\" } ]\n", "line 9, column 8", "there is no place 'home'"},
        {a + "{ go = [1, 2] } ]\n", "line 9, column 8", "'go' has 2 numbers"},
        {a + "{ go = [1, 2, 3], settle = true } ]\n", "line 9, column 28", "'settle' needs 'heading'"},
        {a + "{ play = \"slow\", set = \"n\" } ]\n", "line 9, column 24", "does one thing"},
        {a + "{ fade = 1 } ]\n", "line 9, column 1", "one of play, gesture"},
        {a + "{ play = \"slow\", speed = 0 } ]\n", "line 9, column 26", "'speed' is 0: 0.01 to 100 is wanted"},
        {a + "{ play = \"slow\", curve = \"round\" } ]\n", "line 9, column 26", "linear, smooth or inertial"},
        {"[states.a]\n[masks]\nm = { nodes = [\"elbow\", \"knee\"] }\n", "line 9, column 25", "has no node 'knee'"},
    });
}

TEST(MachineFile, WithConditionsThatCannotBeIsRefusedAtTheCharacter)
{
    const auto wrong = [](const std::string &condition, int offset, const std::string &rule) {
        return Wrong{"[states.a]\ntransitions = [\n{ on = \"go\", if = '" + condition + "', to = \"a\" } ]\n",
                     "line 9, column " + std::to_string(20 + offset), rule};
    };
    expect_refused({
        wrong("m > 3", 0, "'m' is not known; there are: n, open, time"),
        wrong("n > ", 4, "ends where a value is expected"),
        wrong("n > 3 )", 6, "')' does not continue the expression"),
        wrong("(n > 3", 6, "')' is missing"),
        wrong("n + 1", 0, "a condition is wanted"),
        wrong("n and open", 0, "'and' needs a truth, and this is a number"),
        wrong("open > 1", 0, "'>' needs a number, and this is a truth"),
        wrong("n > open", 4, "'>' needs a number, and this is a truth"),
        wrong("sin(n) > 0", 0, "'sin' is no function"),
        wrong("n > 1e999", 4, "this is no number"),
        wrong("n # 3", 2, "'#' does not continue"),
        wrong("near(owl) < 3", 5, "'\"' is missing"),
        wrong(std::string(40, '(') + "n" + std::string(40, ')'), 33, "inside each other"),
    });
}

TEST(MachineFile, OfVariablesThatMachinesShareMustAgree)
{
    StageWorld world;
    const std::string one = "machine = \"m\"\n[crowd]\nmood = 1\n[events]\nrun = 2\n[states.a]\n";
    EXPECT_EQ(world.refusal(one), "");
    EXPECT_EQ(world.refusal(one), "");
    EXPECT_NE(world.refusal("machine = \"m\"\n[crowd]\nmood = 2\n[states.a]\n").find("line 3, column 8"),
              std::string::npos);
    EXPECT_NE(world.refusal("machine = \"m\"\n[events]\nrun = 1\n[states.a]\n").find("priority class 2"),
              std::string::npos);
    EXPECT_NE(world.refusal("machine = \"m\"\n[events]\nseen = 1\n[states.a]\n").find("of the stage itself"),
              std::string::npos);
}

TEST(MachineFile, BeyondItsLimitsIsRefused)
{
    StageWorld world;
    std::string deep = "[states.s0", text = head;
    for (int i = 1; i < 9; ++i) deep += ".states.s" + std::to_string(i);
    EXPECT_NE(world.refusal(head + deep + "]\n").find("more than 16 parts"), std::string::npos);
    EXPECT_NE(world.refusal(head + "[states.\u00DF]\n").find("line 7: not TOML: a letter outside of strings"),
              std::string::npos);
    for (int i = 0; i <= 1000; ++i) text += "[states.s" + std::to_string(i) + "]\n";
    EXPECT_NE(world.refusal(text).find("line 1007, column 9: more than 1000 states"), std::string::npos);
    EXPECT_NE(world.refusal(std::string((4u << 20) + 1, ' ')).find("bytes"), std::string::npos);
}

}  // namespace
