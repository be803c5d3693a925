// Scenario files: those that come with claque say what is in them, and a file that breaks a rule is refused with file,
// line, column and the rule.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/scenes/described.h"

namespace
{

using namespace scenes;

const std::string scenario_folder = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";

const std::string &corner()
{
    static const std::string text = [] {
        std::ifstream file(scenario_folder + "corner.toml");
        return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    }();
    return text;
}

std::string corner_with(const std::string &after, const std::string &was, const std::string &is)
{
    return changed_text(corner(), after, was, is);
}

// With these lines in its first class, or in one section.
std::string in_class(const std::string &lines) { return corner_with("citizens", "share = 3\n", "share = 3\n" + lines); }
std::string in_section(const std::string &section, const std::string &lines)
{
    return corner_with("", section + "\n", section + "\n" + lines);
}

}  // namespace

TEST(Scenario, OfTheOdeonHasItsSeatsClassesClipsCameraAndLight)
{
    const Scenario &odeon = odeon_scenario();
    EXPECT_EQ(odeon.name, "odeon");
    ASSERT_TRUE(odeon.theatre.has_value());
    EXPECT_EQ(seats_of(*odeon.theatre).size(), 1190u);
    EXPECT_EQ(odeon.theatre->facing_noise_deg, 7);
    ASSERT_EQ(odeon.characters.size(), 3u);
    const Temperament *manners[] = {&Temperament::grave, &Temperament::gracious, &Temperament::hearty};
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(odeon.characters[i].temperament.odds, manners[i]->odds) << i;
        EXPECT_EQ(odeon.characters[i].temperament.cheer, manners[i]->cheer) << i;
        EXPECT_EQ(odeon.characters[i].temperament.laugh, manners[i]->laugh) << i;
        EXPECT_EQ(odeon.characters[i].temperament.rise, manners[i]->rise) << i;
    }
    ASSERT_TRUE(odeon.path.has_value());
    EXPECT_EQ(odeon.path->sections().size(), 4u);
    ASSERT_TRUE(odeon.light.has_value());
    EXPECT_EQ(odeon.light->to_sun.y, 0.62f);
    EXPECT_EQ(odeon.light->bounce.b, 0.18f);
    EXPECT_EQ(odeon.paving->r, 0.86f);
}

TEST(Scenario, OfTheCornerHasItsTracksClassesGroundAndLight)
{
    const Scenario read = load_scenario(scenario_folder + "corner.toml");
    EXPECT_EQ(read.name, "corner");
    ASSERT_TRUE(read.tracks.has_value());
    EXPECT_EQ(read.tracks->path, scenario_folder + "corner.csv");
    EXPECT_EQ(read.tracks->columns, "id,frame,x,y");
    EXPECT_EQ(read.tracks->reading.rate_hz, 2);
    EXPECT_EQ(read.tracks->reading.metres_per_unit, 1);
    EXPECT_EQ(read.tracks->origin, (std::array<double, 2>{0, 0}));
    ASSERT_EQ(read.characters.size(), 2u);
    EXPECT_EQ(read.characters[0].share, 3);
    EXPECT_EQ(read.characters[1].clips.run, "jog");
    EXPECT_EQ(read.characters[1].clips.slow_walk, "walk_slow");
    EXPECT_EQ(read.characters[1].clips.turn, "turn");
    EXPECT_EQ(read.characters[1].clips.idles, (std::vector<std::string>{"stand", "stand_look"}));
    EXPECT_EQ(read.characters[1].palette.size(), 1u);
    EXPECT_EQ(read.area, scenario_folder + "corner.wkt");
    EXPECT_EQ(read.around->g, 0.50f);
    EXPECT_EQ(read.light->sun.r, 0.78f);
    EXPECT_EQ(read.path->keys().size(), 3u);
    EXPECT_EQ(refusal_of(corner()), "read");
    EXPECT_EQ(read.characters[0].placement.colours, CLQ_COLOURS_NEAR);
}

TEST(Scenario, WithWildOrOwnColoursNamesNoFileOfThem)
{
    for (const clq_colours colours : {CLQ_COLOURS_WILD, CLQ_COLOURS_OWN}) {
        const std::string text = std::string("colours = \"") + name_of(colours) + "\"\n" + corner();
        const Scenario read = read_scenario(text, scenario_folder + "mine.toml", files_beside(scenario_folder));
        for (const SocialClass &one : read.characters) EXPECT_EQ(one.placement.colours, colours) << one.name;
        EXPECT_EQ(read.colours, "");
    }
}

TEST(Scenario, HasPeopleWhoSitOrPeopleWhoWalk)
{
    expect_refused("name = \"x\"\n", {"does not say where its people are", "[theatre] or [tracks]"});
    expect_refused("", {"the scenario lacks 'name'"});
    expect_refused("name = \"\"\n", {":1:8:", "the name \"\""});
    expect_refused(odeon_description() + "[tracks]\nfile = \"a.csv\"\n", {"[theatre]", "[tracks]", "one of the two"});
}

TEST(Scenario, WithAnUnknownKeyIsRefusedAtTheKey)
{
    expect_refused(corner_with("", "[ground]\n", "[wind]\nspeed_m_s = 3.0\n\n[ground]\n"),
                   {"mine.toml:28:2:", "the scenario has an unknown key 'wind'", "characters", "tracks", "light"});
    expect_refused(in_section("[tracks]", "\n  speed = 3\n"),
                   {"mine.toml:8:3:", "[tracks]", "'speed'", "max_speed_m_s"});
    expect_refused(in_class("age = 3\n"), {"mine.toml:19:1:", "[[characters]] 1", "'age'",
                                           "there are: blend, character, clips, head, height_m, legs, name, neck, "
                                           "palette, scale, share, torso, turn_deg"});
    expect_refused(in_section("[ground]", "grass = 3\n"), {"[ground]", "'grass'", "paving"});
    expect_refused(in_section("[light]", "moon = 3\n"), {"[light]", "'moon'", "to_sun"});
    expect_refused(in_section("[camera]", "roll = 3\n"), {"[camera] has an unknown key 'roll'", "far_m"});
    expect_refused(in_class("clips = { fly = \"fly\" }\n"), {"the clips of class 'citizens'", "'fly'", "idles"});
}

TEST(Scenario, WithoutAFileThatItNamesIsRefusedWhereItNamesIt)
{
    expect_refused(corner_with("[tracks]", "corner.csv", "none.csv"),
                   {"mine.toml:7:8:", "[tracks]", "'file'", "none.csv is absent"});
    expect_refused(corner_with("[tracks]", "file = \"corner.csv\"", "file = \"\""),
                   {"mine.toml:7:8:", "names no file"});
    expect_refused(corner_with("[tracks]", "file = \"corner.csv\"", ""), {"[tracks]", "lacks 'file'"});
    expect_refused(corner_with("[ground]", "corner.wkt", "none.wkt"), {"[ground]", "'area'", "none.wkt is absent"});
    expect_refused(corner_with("citizens", "character = \"citizen\"", "character = \"none.glb\""),
                   {"[[characters]] 1", "'character'", "none.glb is absent"});
    expect_refused("colours = \"none.toml\"\n" + corner(), {"mine.toml:1:11:", "'colours'", "none.toml is absent"});
    expect_refused("name = \"x\"\n[tracks]\nfile = \"a\"\n[camera]\npath = \"none\"\n",
                   {"mine.toml:5:8:", "'path'", "none is absent"});
}

TEST(Scenario, WithTracksThatCannotBeReadSoIsRefused)
{
    expect_refused(corner_with("[tracks]", "rate_hz = 2", "rate_hz = 0"), {"'rate_hz' = 0", "1e-06 to 1e+06"});
    expect_refused(corner_with("[tracks]", "unit = \"m\"", "unit = \"ell\""), {"'ell' is no unit", "cm, mm, ft"});
    expect_refused(corner_with("[tracks]", "unit = \"m\"", "unit = 1"), {"'unit'", "a whole number", "a string"});
    expect_refused(corner_with("[tracks]", "unit = \"m\"", "up = \"x\""), {"up = 'x'", "neither y nor z"});
    expect_refused(corner_with("[tracks]", "unit = \"m\"", "max_speed_m_s = -1"), {"'max_speed_m_s' = -1"});
    expect_refused(corner_with("[tracks]", "unit = \"m\"", "vehicles = 1"), {"'vehicles'", "true or false"});
    expect_refused(corner_with("[tracks]", "[0.0, 0.0]", "[0.0]"), {"'origin_m'", "[first, last]"});
    expect_refused(corner_with("[tracks]", "\"id,frame,x,y\"", "\"\""), {"columns without names"});
    for (const char *unit : {"cm", "mm", "ft", "0.25"})
        EXPECT_EQ(refusal_of(corner_with("[tracks]", "unit = \"m\"", "unit = \"" + std::string(unit) + "\"")), "read");
}

TEST(Scenario, WithClassesThatCannotWalkIsRefused)
{
    expect_refused(in_class("count = 3\n"), {"'count'", "[theatre]", "'share'"});
    expect_refused(in_class("programme = { sit = 1 }\n"), {"'programme'", "[theatre]"});
    expect_refused(in_class("palette = { tunic = 3 }\n"), {"'tunic'", "not a table"});
    expect_refused(in_class("palette = { tunic = { hue = [0, 9], saturation = [1, 0], brightness = [0, 1] } }\n"),
                   {"for 'tunic'", "saturation in the wrong order"});
    expect_refused(in_class("clips = { idles = [\"a\", \"b\", \"c\", \"d\", \"e\"] }\n"), {"5 idles", "at most 4"});
    expect_refused(in_class("clips = { idles = \"a\" }\n"), {"'idles'", "list of strings"});
    expect_refused(corner_with("citizens", "share = 3", "share = -3"), {"'share' = -3"});
    expect_refused(changed_text(corner_with("citizens", "share = 3", "share = 0"), "workers", "share = 2", "share = 0"),
                   {"shares are all 0"});
    expect_refused(corner_with("", "name = \"workers\"", "name = \"citizens\""), {"a second class 'citizens'"});
    std::string many = "name = \"x\"\n[tracks]\nfile = \"a\"\n";
    for (int i = 0; i <= 64; ++i)
        many += "[[characters]]\nname = \"" + std::to_string(i) + "\"\ncharacter = \"citizen\"\n";
    expect_refused(many, {"[[characters]] 65", "at most 64 classes"});
}

TEST(Scenario, WithClassesThatCannotSitIsRefused)
{
    const auto sitter = [](const std::string &was, const std::string &is) {
        return changed_text(odeon_description(), "rich men", was, is);
    };
    expect_refused(sitter("count = 340", "share = 340"), {"'share'", "[tracks]", "'count'"});
    expect_refused(sitter("count = 340", "count = 340\nclips = { walk = \"walk\" }"),
                   {"'clips'", "[tracks]", "'programme'"});
    expect_refused(sitter("count = 340", ""), {"lacks 'count'"});
    expect_refused(sitter("character = \"decurion\"", "character = \"owl\""), {"'owl'", "cannot sit", "plebeian"});
    expect_refused(sitter("sit_wave = 0.02", "sit_wave = -1"),
                   {"the programme of class 'decurions'", "'sit_wave' = -1"});
    expect_refused(sitter("sit = 3.4", "sit = 0"), {"sit = 0"});
    expect_refused(sitter("sit_wave = 0.02", "wave = 1"), {"unknown key 'wave'", "sit_wave"});
}

TEST(Scenario, WithACameraLightOrGroundThatCannotBeIsRefused)
{
    expect_refused(corner_with("[camera]", "far_m = 2500.0", ""), {"[camera] lacks 'far_m'"});
    expect_refused(corner_with("time_s = 7.0", "near_m = 0.5", "near_m = 50"),
                   {"mine.toml:62:10:", "key frame 2", "50"});
    const std::string people = "name = \"x\"\n[tracks]\nfile = \"a\"\n";
    expect_refused(people + "[camera]\nfollow = \"\"\n", {"mine.toml:5:10:", "without an id"});
    expect_refused(people + "[camera]\nfollow = \"7\"\nfar_m = 3\n", {"mine.toml:6:1:", "'far_m'", "follow"});
    expect_refused(people + "[camera]\npath = \"p\"\nfar_m = 3\n", {"mine.toml:6:1:", "'far_m'", "path"});
    expect_refused(changed_text(odeon_description(), "[camera]", "path = \"path.toml\"", "follow = \"7\""),
                   {"follows a person, who has to walk", "[tracks]"});
    expect_refused(corner_with("[light]", "[-0.45, 0.70, 0.55]", "[-0.45, 0.01, 0.55]"),
                   {"mine.toml:34:10:", "its sun 0.8", "above the horizon", "5 to 85"});
    expect_refused(corner_with("[light]", "[-0.45, 0.70, 0.55]", "[0, 1, 0]"), {"90 degrees", "5 to 85"});
    expect_refused(corner_with("[light]", "[-0.45, 0.70, 0.55]", "[0, 1]"), {"2 numbers instead of 3", "[x, y, z]"});
    expect_refused(corner_with("[light]", "[0.78, 0.70, 0.56]", "[0.78, 0.70, 5.6]"), {"'sun' = 5.6", "0 to 2"});
    expect_refused(corner_with("[ground]", "[0.80, 0.77, 0.72]", "[0.80, 0.77, 1.72]"), {"'paving' = 1.72", "0 to 1"});
    expect_refused(changed_text(odeon_description(), "[ground]", "paving", "around"), {"'around'", "[tracks]"});
}

TEST(Scenario, ThatIsNotThereIsRefusedByName)
{
    try {
        load_scenario(scenario_folder + "none.toml");
        FAIL();
    } catch (const Failure &failure) {
        EXPECT_NE(std::string(failure.what()).find("none.toml"), std::string::npos) << failure.what();
    }
}

namespace
{

const std::string one_person =
    "name = 'x'\n[[characters]]\nname = 'c'\ncharacter = 'citizen'\n[[people]]\nclass = 'c'\nat = [0, 0, 0]\n";

std::string crowd_of(int people)
{
    std::string text = "name = 'x'\n[[characters]]\nname = 'c'\ncharacter = 'citizen'\n";
    for (int i = 0; i < people; ++i) text += "[[people]]\nclass = 'c'\nat = [0, 0, 0]\n";
    return text;
}

}  // namespace

TEST(Scenario, OfPeopleWithNumbersThatAreNotWhatTheySayIsRefused)
{
    EXPECT_EQ(refusal_of(one_person), "read");
    EXPECT_EQ(refusal_of(one_person + "seed = '18446744073709551615'\nstart_s = 9007\n"), "read");
    EXPECT_EQ(refusal_of(one_person + "orientation = [0, 0.6, 0, 0.8]\n"), "read");
    expect_refused(one_person + "start_s = 9007199254740993\n",
                   {"mine.toml:8:11: [[people]] 1 has 'start_s' that is 9007199254740993, a whole number that would be "
                    "rounded: up to 9007199254740992 none is"});
    for (const char *seed : {"18446744073709551616", "12345678901234567890123", "-1", "7a", "", " 7", "0x10"})
        expect_refused(one_person + "seed = '" + seed + "'\n",
                       {"mine.toml:8:8: [[people]] 1 has the seed '" + std::string(seed) +
                        "', which is not a whole number from 0 to 18446744073709551615"});
    expect_refused(one_person + "orientation = [0, 0, 0, 0]\n",
                   {"mine.toml:8:15: [[people]] 1 has an orientation of length 0 instead of 1"});
    expect_refused(one_person + "orientation = [0, 0.6, 0, 0.802]\n", {"of length 1.0016 instead of 1"});
}

TEST(Scenario, OfThreeHundredThousandPeopleIsRefusedBeforeItIsParsed)
{
    EXPECT_EQ(refusal_of(crowd_of(10000)), "read");
    expect_refused(crowd_of(10001), {"has 10001 people; it needs 1 to 10000"});
    std::string in_line = "name = 'x'\npeople = [";
    for (int i = 0; i < 300000; ++i) in_line += "{ class = 'c', at = [0, 0, 0] },";
    // A parser, which takes seconds, would name the line that is no TOML.
    for (const std::string &text : {crowd_of(300000), in_line + "]\n"})
        expect_refused(text + "= no TOML\n", {"the file has more than 100000 tables"});
}
