// Words of machines that stand where they cannot, or beyond a limit, are refused by line, column and rule.
#include "tests/unit/stage/stage_world.h"

namespace
{

class MachineRules : public testing::Test
{
protected:
    // `text` begins in line 12 of a machine with the variables n, log and open and the events go, back and slow.
    void refused(const std::string &text, const std::string &place, const std::string &rule)
    {
        const std::string said = world_.refusal(machine_text(text));
        EXPECT_NE(said.find("m.toml, " + place), std::string::npos) << said << "\n" << text;
        EXPECT_NE(said.find(rule), std::string::npos) << said << "\n" << text;
    }
    void alone(const std::string &text, const std::string &rule)
    {
        const std::string said = world_.refusal(text);
        EXPECT_NE(said.find(rule), std::string::npos) << said << "\n" << text;
    }
    void accepted(const std::string &text) { EXPECT_EQ(world_.refusal(machine_text(text)), "") << text; }

    StageWorld world_;
};

TEST_F(MachineRules, OfTheWholeAreHeld)
{
    alone("[states.a]\n", "it has no name: machine = \"...\"");
    alone("machine = 3\n[states.a]\n", "'machine' is not a string");
    alone("machine = \"a\\u0000b\"\n[states.a]\n", "'machine' holds a zero byte");
    alone("machine = \"m\"\n", "it has no [states]");
    alone("machine = \"m\"\nstates = 3\n", "'states' is not a table");
    alone("machine = \"m\"\nstates = { a = 3 }\n", "state 'a' is not a table");
    alone("machine = \"m\"\ncost = 0\n[states.a]\n", "'cost' is 0: 1 to 1e+06 is wanted");
    alone("machine = \"m\"\ncost = 1.5\n[states.a]\n", "'cost' is 1.5: a whole number is wanted");
    alone("machine = \"m\"\nvariables = 3\n[states.a]\n", "'variables' is not a table");
    alone("machine = \"m\"\ncrowd = 3\n[states.a]\n", "'crowd' is not a table");
    alone("machine = \"m\"\nevents = 3\n[states.a]\n", "'events' is not a table");
    alone("machine = \"m\"\nmasks = 3\n[states.a]\n", "'masks' is not a table");
    alone("machine = \"m\"\nplaces = 3\n[states.a]\n", "'places' is not a table");
    alone("machine = \"m\"\n# a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s\nnote = 'a\\'\n", "'note' is not known here");
    alone("machine = \"m\"\nnote = \"a\n", "not TOML");
}

TEST_F(MachineRules, OfNamesAreHeld)
{
    const auto variable = [&](const std::string &line, const std::string &rule) {
        alone("machine = \"m\"\n[variables]\n" + line + "\n[states.a]\n", rule);
    };
    variable("'a-b' = 1", "'a-b' is no name: letters, digits and _ are wanted");
    variable("'' = 1", "'' is no name");
    variable("3d = 1", "'3d' is no name");
    variable("walking = 1", "'walking' has a meaning of its own");
    variable("own_speed = 1", "'own_speed' has a meaning of its own");
    variable("a = \"b\"", "'a' is not a number");
    variable("a = inf", "'a' is not finite");
    const auto mask = [&](const std::string &line, const std::string &rule) {
        refused("[states.a]\n[masks]\n" + line + "\n", "line 14", rule);
    };
    mask("m = 3", "mask 'm' is not a table");
    mask("m = {}", "it lacks 'nodes'");
    mask("m = { nodes = [] }", "'nodes' is neither a string nor a list of some");
    mask("m = { nodes = 3 }", "'nodes' is neither a string nor a list of some");
    mask("m = { nodes = \"hand\", feather = 1001 }", "'feather' is 1001: 0 to 1000 is wanted");
    mask("m = { nodes = \"hand\", inverted = 1 }", "'inverted' is neither true nor false");
    refused("[places]\nhome = [1, 2]\n[states.a]\n", "line 13, column 8", "'home' has 2 numbers: x, y, z is wanted");
}

TEST_F(MachineRules, OfStatesAndTheirWhileAreHeld)
{
    const auto state = [&](const std::string &line, const std::string &rule) {
        refused("[states.a]\n" + line + "\n", "line 13", rule);
    };
    state("cost = 0", "'cost' is 0: 1 to 1e+06 is wanted");
    state("check = 0.001", "'check' is 0.001: 0.01 to 1e+06 is wanted");
    state("initial = 1", "'initial' is neither true nor false");
    state("enter = 3", "'enter' is not a list");
    state("leave = [ 3 ]", "an action is not a table");
    state("transitions = { to = \"a\" }", "'transitions' is not a list");
    state("transitions = [ 3 ]", "a transition is not a table");
    state("while = 3", "'while' is not a table");
    state("while = { every = 1 }", "'while' needs 'every' and 'do'");
    state("while = { do = [] }", "'while' needs 'every' and 'do'");
    state("while = { every = 0.001, do = [] }", "'every' is 0.001: 0.01 to 1e+06 is wanted");
    refused(
        "[states.s0.states.s1.states.s2.states.s3.states.s4.states.s5.states.s6.states.s7]\nstates = { s8 = { "
        "states = { s9 = {} } } }\n",
        "line 1", "inside each other");
}

TEST_F(MachineRules, OfTransitionsAreHeld)
{
    const auto transition = [&](const std::string &text, const std::string &rule) {
        refused("[states.a]\ninitial = true\ntransitions = [\n{ " + text + " } ]\n", "line 15", rule);
    };
    transition("on = 3, to = \"a\"", "'on' is not a string");
    transition("end = false, to = \"a\"", "'end' is true, or is left out");
    transition("end = 1, to = \"a\"", "'end' is neither true nor false");
    transition("marker = 3, to = \"a\"", "'marker' is not a string");
    transition("on = \"go\", weights = [1], do = []", "'weights' belongs to 'to'");
    transition("on = \"go\", history = \"deep\", do = []", "'history' belongs to 'to'");
    transition("on = \"go\", to = \"a\", weights = 1", "'weights' is not a list");
    transition("on = \"go\", to = \"a\", weights = [-1]", "'weights' is -1: 0 to 1e+09 is wanted");
    transition("on = \"go\", to = \"a\", weights = [0]", "all weights are 0");
    transition("on = \"go\", to = \"a\", history = \"old\"", "'history' is shallow or deep, not 'old'");
    transition("on = \"go\", to = []", "'to' is neither a string nor a list of some");
    transition("after = [1], to = \"a\"", "'after' has not two numbers, [least, greatest]");
    transition("after = 'open', to = \"a\"", "'after' is a condition: a number is wanted");
    transition("end = true, before = -1, to = \"a\"", "'before' is -1: 0 to 1e+06 is wanted");
    accepted(
        "[states.a]\ninitial = true\ntransitions = [ { on = \"go\", to = \"b\", history = \"shallow\" } ]\n"
        "[states.b.states.c]\n");
}

TEST_F(MachineRules, OfActionsAreHeld)
{
    const auto action = [&](const std::string &text, const std::string &rule) {
        refused("[states.a]\nenter = [\n{ " + text + " } ]\n", "line 14", rule);
    };
    action("end_gesture = false", "'end_gesture' is true, or is left out");
    action("walk_on = 1", "'walk_on' is neither true nor false");
    action("stop = true, fade = 1", "'fade' is not known here; there are: stop, if");
    action("walk_on = true, fade = 4000", "'fade' is 4000: 0 to 3600 is wanted");
    action("play = []", "'play' is neither a string nor a list of some");
    action("play = \"slow\", curve = 3", "'curve' is not a string");
    action("play = \"slow\", phase = 2", "'phase' is 2: 0 to 1 is wanted");
    action("gesture = \"wave\", add = 1", "'add' is neither true nor false");
    action("gesture = \"wave\", weight = 2", "'weight' is 2: 0 to 1 is wanted");
    action("gesture = \"wave\", add = true, weight = 5", "'weight' is 5: -4 to 4 is wanted");
    action("set = \"n\", to = true", "'n' is a number");
    action("set = \"open\", to = 1", "'open' is true or false");
    action("set = \"n\", to = [1]", "'to' is not a string");
    action("send = \"go\", to = \"me\"", "'to' is self, sender or all, not 'me'");
    for (const char *key : {"class = \"owl\"", "radius = 1", "per_m = 1"})
        action(std::string("send = \"go\", to = \"sender\", ") + key, "chooses among all, and 'to' names one");
    action("look = [1, 2]", "'look' has 2 numbers: x, y, z is wanted");
    action("look = 3", "'look' is not a string");
    action("go = 3", "'go' is not a string");
    action("go = [1, 2, 3], speed = 13", "'speed' is 13: 0.1 to 12 is wanted");
    action("go = [1, 2, 3], settle = 1", "'settle' is neither true nor false");
    action("call = 3", "'call' is not a string");
    accepted(
        "[states.a]\nenter = [ { look = [1, 2, 3] }, { look = \"sender\" }, { look = \"none\" }, { look = \"owl\" "
        "}, { play = \"slow\", curve = \"linear\" }, { play = \"slow\", curve = \"smooth\" }, { play = \"slow\", "
        "curve = \"inertial\" }, { send = \"go\", to = \"all\" } ]\n");
}

TEST_F(MachineRules, OfNumbersOfThingsAreHeld)
{
    const auto many = [](const std::string &before, int count, const std::string &after) {
        std::string all;
        for (int i = 0; i < count; ++i) all += before + std::to_string(i) + after;
        return all;
    };
    const std::string m = "machine = \"m\"\n", states = "[states.a]\n";
    alone(m + "[variables]\n" + many("v", 65, " = 1\n") + states, "more than 64 variables");
    alone(m + "[crowd]\n" + many("c", 65, " = 1\n") + states, "more than 64 variables of the crowd");
    EXPECT_EQ(world_.refusal(m + "[crowd]\n" + many("c", 40, " = 1\n") + states), "");
    alone(m + "[crowd]\n" + many("d", 40, " = 1\n") + states, "more than 64 variables of the crowd");
    alone(m + "[events]\n" + many("e", 257, " = 1\n") + states, "more than 256 events");
    alone(m + states + "enter = [ " + many("{ play = \"c", 1001, "\" }, ") + "]\n", "more than 1000 clips");
    alone(m + "[events]\ngo = 1\n" + states + "transitions = [ " +
              many("{ on = \"go\", to = \"a\", if = '", 4001, " > 0' }, ") + "]\n",
          "more than 4000 transitions");
    alone(m + states + "enter = [ " + many("{ end_gesture = true, fade = 0.", 8001, " }, ") + "]\n",
          "more than 8000 actions");
}

}  // namespace
