// What is left out of an action is what docs/stage.md says in parentheses: the same commands as with the number.
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/unit/stage/stage_world.h"

namespace
{

// The hash of all commands of an agent that does the action, whose keys are `more`.
uint64_t commands_of(const std::string &action, const std::string &more)
{
    StageWorld world;
    const clq_machine machine = world.machine(machine_text(
        "[states.a]\ninitial = true\nenter = [ { play = \"slow\" } ]\ntransitions = [ { after = 0.5, to = \"b\" } ]\n"
        "[states.b]\nenter = [ { gesture = \"fast\", loops = 0, fade_in = 0 }, { " +
        action + more +
        " } ]\ntransitions = [ { on = \"go\", to = \"c\" } ]\n[states.c]\nenter = [ { play = \"bent\", " +
        "fade = \"0.1 + 0.01 * value\" } ]\n"));
    world.actor_agent(machine);
    world.step(10);
    EXPECT_GT(world.info().commands, 1u) << action << more;
    return world.info().hash;
}

TEST(Defaults, OfActionsAreThoseOfTheirPage)
{
    std::ifstream page(CLAQUE_SOURCE_DIR "/docs/stage.md");
    std::stringstream text;
    text << page.rdbuf();
    const std::string all = text.str();
    const struct {
        const char *action, *row;
        size_t keys;
    } actions[] = {{"play = \"bent\"", "| `play = ", 3},
                   {"gesture = \"wave\"", "| `gesture = ", 6},
                   {"end_gesture = true", "| `end_gesture = ", 1},
                   {"send = \"go\", to = \"self\"", "| `send = ", 2}};
    for (const auto &one : actions) {
        const size_t at = all.find(one.row);
        ASSERT_NE(at, std::string::npos) << one.row;
        const size_t others = all.find(" | ", at) + 3;
        const std::string row = all.substr(others, all.find(" | ", others) - others);
        const uint64_t without = commands_of(one.action, "");
        const std::regex pattern("`(\\w+)` \\(([\\w.]+)\\)");
        size_t keys = 0;
        for (std::sregex_iterator i(row.begin(), row.end(), pattern); i != std::sregex_iterator(); ++i) {
            const std::string key = (*i)[1], value = (*i)[2];
            if (key == "per_m") continue;  // of events for all
            ++keys;
            EXPECT_EQ(commands_of(one.action, ", " + key + " = " + value), without) << one.action << ", " << key;
            const std::string other = value == "false" ? "true" : key == "weight" ? "0.5" : value == "0" ? "0.25" : "3";
            EXPECT_NE(commands_of(one.action, ", " + key + " = " + other), without)
                << one.action << ", " << key << " changes nothing, so that this test would not see its default";
        }
        EXPECT_EQ(keys, one.keys) << row;
    }
}

}  // namespace
