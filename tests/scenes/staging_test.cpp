// What scenario files say of people who decide, and how a file that breaks a rule is refused.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/scenes/described.h"

namespace
{

using namespace scenes;

const std::string hall = R"toml(name = "hall"

[stage]
seconds = 30.0
timetable = "alarm.toml"

[[characters]]
name = "guests"
character = "citizen"

[places]
"gate" = [0.0, 0.0, 5.0]
"far gate" = [4.0, 1.0, -5.0]

[navigation]
rectangle = [5.0, -6.0, -5.0, 6.0]

[[doors]]
name = "west"
area = [-1.0, 4.0, 1.0, 4.5]
y_m = [0.0, 2.0]
closes_s = [12.0, 3.0]
opens_s = 7.0

[[agents]]
class = "guests"
machine = "guest.toml"
count = 20
area = [-4.0, -5.0, 4.0, 1.0, 0.0, 3.0]
exits = ["far gate"]

[[agents]]
class = "guests"
name = "latecomers"
machine = "guest.toml"
count = 5
from = ["gate", "far gate"]
from_s = 4.0
per_minute = 20.0
heading_deg = 90.0
)toml";

std::string hall_with(const std::string &was, const std::string &is) { return changed_text(hall, "", was, is); }

Scenario read_hall(const std::string &text)
{
    return read_scenario(text, "mine.toml",
                         {"", [](const std::string &, std::string &) { return std::string(); },
                          [](const std::string &) { return std::string(); }});
}

}  // namespace

TEST(Staging, HasItsPlacesGroundDoorsAndAgents)
{
    ASSERT_EQ(refusal_of(hall), "read");
    const Scenario read = read_hall(hall);
    ASSERT_TRUE(read.stage.has_value());
    const Staging &stage = *read.stage;
    EXPECT_EQ(stage.seconds, 30);
    EXPECT_EQ(stage.timetable, "alarm.toml");
    ASSERT_EQ(stage.places.size(), 2u);
    ASSERT_TRUE(stage.ground.has_value());
    EXPECT_EQ(stage.ground->rectangle, (Outline{-5, -6, -5, 6, 5, 6, 5, -6}))
        << "in order, whichever corners are given";
    ASSERT_EQ(stage.doors.size(), 1u);
    EXPECT_TRUE(stage.doors[0].open);
    EXPECT_EQ(stage.doors[0].high_m, 2);
    std::vector<std::pair<double, bool>> changes;
    for (const ScenarioDoor::Change &change : stage.doors[0].changes) changes.push_back({change.at_s, change.open});
    EXPECT_EQ(changes, (std::vector<std::pair<double, bool>>{{3, false}, {7, true}, {12, false}})) << "by time";
    ASSERT_EQ(stage.agents.size(), 2u);
    EXPECT_EQ(stage.agents[0].name, "guests");
    EXPECT_EQ(stage.agents[0].outline.size(), 6u);
    ASSERT_EQ(stage.agents[0].exits.size(), 1u);
    EXPECT_EQ(stage.places[stage.agents[0].exits[0]].position, (std::array<double, 3>{4, 1, -5}));
    EXPECT_EQ(stage.agents[1].name, "latecomers");
    EXPECT_EQ(stage.agents[1].from.size(), 2u);
    EXPECT_EQ(stage.agents[1].per_minute, 20);
    EXPECT_EQ(stage.agents[1].heading_deg, 90);
}

TEST(Staging, HasThePacesOfItsStairsOrThoseOfTheWalkers)
{
    EXPECT_FALSE(read_hall(hall).stage->ground->climbing.has_value());
    const Scenario read = read_hall(hall_with("[navigation]\n", "[navigation]\nclimbing = 0.7\ndescending = 0.9\n"));
    EXPECT_EQ(read.stage->ground->climbing, 0.7);
    EXPECT_EQ(read.stage->ground->descending, 0.9);
    for (const char *line : {"climbing = 0.0\n", "descending = 1.5\n"})
        expect_refused(hall_with("[navigation]\n", std::string("[navigation]\n") + line), {"[navigation]", "ing' = "});
}

TEST(Staging, ThatNamesWhatIsNotThereIsRefusedAtTheName)
{
    expect_refused(hall_with("\"guests\"\nmachine", "\"ghosts\"\nmachine"),
                   {"[[agents]] 1", "'ghosts'", "'guests' is near"});
    expect_refused(hall_with("[\"far gate\"]", "[\"no gate\"]"), {"[[agents]] 1", "'exits'", "'no gate'", "'gate'"});
    expect_refused(hall_with("exits = [\"far gate\"]\n", "exits = [\"far gate\"]\nexit_widths_m = [1.0, 2.0]\n"),
                   {"[[agents]] 1 has 1 'exits' and 2 widths of them"});
    expect_refused(hall_with("[\"gate\", \"far gate\"]", "[]"), {"[[agents]] 2", "'from' without a place"});
    expect_refused(hall_with("guest.toml", "none.toml"), {"[[agents]] 1", "'machine'", "none.toml is absent"});
    expect_refused(hall_with("alarm.toml", "none.toml"), {"mine.toml:5:13", "'timetable'", "none.toml is absent"});
}

TEST(Staging, WithASectionThatLacksAnotherIsRefused)
{
    expect_refused(hall_with("[stage]\nseconds = 30.0\ntimetable = \"alarm.toml\"\n", "[camera]\nfollow = \"1\"\n"),
                   {"'places', which goes with [stage]"});
    expect_refused(hall_with("[navigation]\nrectangle = [5.0, -6.0, -5.0, 6.0]\n", ""),
                   {"has doors, and no [navigation]"});
    const std::string doors = hall.substr(hall.find("[[doors]]"), hall.find("[[agents]]") - hall.find("[[doors]]"));
    expect_refused(changed_text(hall_with(doors, ""), "", "[navigation]\nrectangle = [5.0, -6.0, -5.0, 6.0]\n", ""),
                   {"[[agents]] 1", "'exits'", "which goes with [navigation]"});
    expect_refused(hall.substr(0, hall.find("[[agents]]")), {"has 'stage', which is now 'theatre.stage'"});
    expect_refused("name = \"x\"\nagents = []\n[stage]\nseconds = 3.0\n", {"an empty list of agents"});
    expect_refused(hall_with("[places]", "[tracks]\nfile = \"a.csv\"\n[places]"),
                   {"[stage]", "[tracks]", "one of the two"});
}

TEST(Staging, WithNumbersThatMeanNothingIsRefused)
{
    expect_refused(hall_with("seconds = 30.0", "seconds = 0.0"), {"[stage]", "'seconds' = 0", "0.1 to 86400"});
    expect_refused(hall_with("[5.0, -6.0, -5.0, 6.0]", "[5.0, -6.0, 5.0, 6.0]"), {"'rectangle' without any width"});
    expect_refused(hall_with("[-1.0, 4.0, 1.0, 4.5]", "[1.0, 4.0, 1.0, 4.5, 2.0]"),
                   {"[[doors]] 1", "of 5 numbers", "4, a rectangle"});
    expect_refused(hall_with("y_m = [0.0, 2.0]", "y_m = [2.0, 0.0]"), {"[[doors]] 1", "heights in the wrong order"});
    expect_refused(hall_with("from = [\"gate\", \"far gate\"]\n", ""), {"[[agents]] 2", "'from'", "'area'", "neither"});
    expect_refused(hall_with("from = [", "area = [0.0, 0.0, 1.0, 1.0]\nfrom = ["), {"[[agents]] 2", "both"});
    expect_refused(hall_with("count = 20", "count = 16000"), {"[[agents]] 2", "16005 people", "at most 16000"});
    expect_refused(hall_with("count = 20", "count = 0"), {"[[agents]] 1", "'count' = 0"});
    expect_refused(hall_with("rectangle", "rectangles"), {"[navigation]", "where people walk"});
    expect_refused(hall_with("count = 20", "counts = 20"), {"[[agents]] 1", "unknown key 'counts'", "'count' is near"});
    expect_refused(hall_with("[[agents]]", "[[doors]]\nname = \"west\"\narea = [2.0, 2.0, 3.0, 3.0]\n[[agents]]"),
                   {"[[doors]] 2", "a second door 'west'"});
}

TEST(Staging, SaysOfClassesOnlyWhatTheyLookLike)
{
    for (const char *key : {"count = 3\n", "share = 0.5\n", "programme = {}\n"})
        expect_refused(hall_with("character = \"citizen\"\n", std::string("character = \"citizen\"\n") + key),
                       {"[[characters]] 1", "[[agents]] says how many"});
    expect_refused(hall_with("[places]", "[ground]\narea = \"a.wkt\"\n[places]"),
                   {"[ground]", "have it in [navigation]"});
}
