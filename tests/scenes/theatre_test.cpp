// Theatres that contradict themselves are refused by one sentence with file, line, column, row, and the numbers.
#include <gtest/gtest.h>

#include "tests/scenes/described.h"

namespace
{

using namespace scenes;

// The description that comes with claque, changed.
std::string changed(const std::string &after, const std::string &was, const std::string &is)
{
    return changed_text(odeon_description(), after, was, is);
}

const std::string lower = "ima cavea", middle = "lower half", upper = "upper half", walkway = "[[theatre.walkways]]",
                  stairs = "[[theatre.gangways]]", palette = "[[characters]]";

}  // namespace

TEST(Theatre, TheDescriptionThatComesWithClaqueIsRead)
{
    const Theatre theatre = *odeon_scenario().theatre;
    ASSERT_EQ(theatre.rows.size(), 18u);
    EXPECT_DOUBLE_EQ(theatre.rows[1].radius_m, 7.68);
    EXPECT_NEAR(theatre.rows[8].seat_y_m, 4.30, 1e-9);
    EXPECT_NEAR(theatre.rows[8].step_y_m, 3.87, 1e-9);
    EXPECT_EQ(theatre.rows[17].social_class, "plebeians");
    ASSERT_EQ(theatre.gangways.size(), 10u);
    EXPECT_EQ(theatre.gangways[9].first_row, 9u);
    ASSERT_EQ(theatre.classes.size(), 3u);
    EXPECT_EQ(theatre.classes[1].character, "patrician");
    ASSERT_EQ(theatre.classes[2].palette.size(), 2u);
    for (const SocialClass &one : theatre.classes) EXPECT_EQ(one.count, 340u);
}

TEST(Theatre, InvalidTomlIsRefusedWithItsLine)
{
    expect_refused("name = \"x\"\nthis is no key\n", {"mine.toml:2:", "not TOML"});
    expect_refused(std::string("name = \"\x01\""), {"not TOML"});
    expect_refused("name = " + std::string(300000, '['), {"not TOML"});
    std::string deep = "name = \"a.dot.in.a.string.does.not.count.a.b.c.d.e.f.g.h.i.j\"\na";
    for (int i = 0; i < 300000; ++i) deep += ".a";
    expect_refused(deep + " = 1\n", {"mine.toml:2:", "a key has more than 16 parts"});
    expect_refused("name = \"\u00DF\" # \u00DF\n\u00DF = 1\n",
                   {"mine.toml:2:", "not TOML: a letter outside of strings"});
    expect_refused("\xEF\xBB\xBFname = 1 \u00DF\n", {"mine.toml:1:", "not TOML: a letter outside of strings"});
    expect_refused("\xEF\xBB\xBFname = \"\u00DF\"\n", {"does not say where its people are"});
}

TEST(Theatre, MissingKeysAreNamed)
{
    expect_refused("", {"'name'"});
    expect_refused(changed("[theatre.orchestra]", "radius_m = 6.2", ""), {"[theatre.orchestra]", "lacks 'radius_m'"});
    expect_refused(changed(middle, "depth_m = 0.78", ""), {"[[theatre.rows]] 2", "lacks 'depth_m'"});
    expect_refused(changed(palette, "character = \"decurion\"", ""), {"[[characters]] 1", "lacks 'character'"});
}

TEST(Theatre, FormerKeysAreRefusedWithTheirNewNames)
{
    expect_refused(changed(palette, "character = \"decurion\"", "figure = \"decurion\""),
                   {"[[characters]] 1", "'figure'", "'character'"});
    expect_refused(changed(lower, "class = \"decurions\"", "who = \"decurions\""),
                   {"[[theatre.rows]] 1", "'who'", "'class'"});
    for (const char *former : {"orchestra", "seats", "stage"})
        expect_refused("[" + std::string(former) + "]\n" + odeon_description(),
                       {"mine.toml:1:1:", "'" + std::string(former) + "'", "'theatre." + std::string(former) + "'"});
    expect_refused("[audience]\n" + odeon_description(), {"mine.toml:1:1:", "'audience'", "'characters'"});
}

// S1 2: "a theatre without a scenario".
TEST(Theatre, WithoutAScenarioIsRefusedAndToldWhatIsMissing)
{
    const std::string text = odeon_description();
    const size_t people = text.find(palette), light = text.find("[light]");
    expect_refused(text.substr(0, people) + text.substr(light),
                   {"[theatre] is a theatre without a scenario", "nothing says who sits in it", "[[characters]]"});
    expect_refused(text.substr(0, text.find("[theatre.orchestra]")), {"[theatre] or [tracks]"});
}

TEST(Theatre, WithoutSeatsIsRefused)
{
    const std::string text = odeon_description();
    expect_refused(text.substr(0, text.find("[[theatre.rows]]")) + text.substr(text.find("[[theatre.walkways]]")),
                   {"no seats"});
}

TEST(Theatre, AnUnknownKeyIsNamedWithTheValidOnes)
{
    expect_refused(changed(lower, "sweep_deg", "sweep"), {"lacks 'sweep_deg'"});
    expect_refused(changed(lower, "rise_m = 0.43", "rise_m = 0.43\nslope = 3"),
                   {"unknown key 'slope'", "depth_m", "mine.toml:25:1:"});
    expect_refused("colour = 1\n" + odeon_description(), {"mine.toml:1:", "unknown key 'colour'"});
}

TEST(Theatre, WrongTypesAreNamed)
{
    expect_refused(changed(lower, "radius_m = 6.9", "radius_m = \"wide\""), {"'radius_m'", "a string", "number"});
    expect_refused(changed(lower, "count = 9", "count = 9.5"), {"'count'", "whole"});
    expect_refused(changed(lower, "class = \"decurions\"", "class = 3"), {"'class'", "a whole number", "string"});
    expect_refused(changed(lower, "[-97.0, 97.0]", "[-97.0, 0.0, 97.0]"), {"'sweep_deg'", "[first, last]"});
    expect_refused("light = 1\n" + odeon_description().substr(0, odeon_description().find("[light]")),
                   {"mine.toml:1:9:", "'light'", "table"});
    expect_refused(changed(palette, "tunic = {", "tunic = 2  # {"), {"'tunic'", "table"});
}

TEST(Theatre, NumbersThatAreNotFiniteOrAbsurdAreRefused)
{
    expect_refused(changed(lower, "radius_m = 6.9", "radius_m = inf"), {"'radius_m' = inf", "not finite"});
    expect_refused(changed(lower, "seat_y_m = 0.86", "seat_y_m = nan"), {"'seat_y_m'", "not finite"});
    expect_refused(changed(lower, "radius_m = 6.9", "radius_m = 1e9"), {"1e+09", "1 to 200"});
    expect_refused(changed("[theatre.seats]", "width_m = 0.65", "width_m = 0"), {"'width_m' = 0", "0.64"});
    expect_refused(changed("[theatre.seats]", "width_m = 0.65", "width_m = -1"), {"'width_m' = -1"});
    expect_refused(changed(lower, "count = 9", "count = 0"), {"'count' = 0"});
    expect_refused(changed(lower, "count = 9", "count = -9"), {"'count' = -9"});
    expect_refused(changed(lower, "count = 9", "count = 9000000000000"), {"'count' = 9e+12"});
    expect_refused(changed(lower, "rise_m = 0.43", "rise_m = 0.9"), {"'rise_m' = 0.9", "0.46"});
    expect_refused(changed(lower, "[-97.0, 97.0]", "[-197.0, 97.0]"), {"-197", "-180 to 180"});
    expect_refused(changed(lower, "[-97.0, 97.0]", "[97.0, -97.0]"), {"97 to -97", "descending"});
    expect_refused(changed(palette, "saturation = [0.40, 0.80]", "saturation = [0.40, 1.80]"), {"1.8", "0 to 1"});
    expect_refused(changed(palette, "saturation = [0.40, 0.80]", "saturation = [0.80, 0.40]"), {"in the wrong order"});
}

TEST(Theatre, RowsThatOverlapAreRefusedWithTheirNumbers)
{
    expect_refused(changed(upper, "radius_m = 19.6", "radius_m = 19.1"),
                   {"row 14", "row 15", "overlap", "19.6", "19.1"});
    expect_refused(changed(lower, "depth_m = 0.78", "depth_m = 0.98"), {"walkway 1", "row 8", "13.92", "14.74"});
}

TEST(Theatre, RowsThatDescendAreRefused)
{
    expect_refused(changed(upper, "seat_y_m = 7.74", "seat_y_m = 6.0"), {"row 15", "6 m", "row 14", "7.31"});
}

TEST(Theatre, ARowWithoutAStepForItsFeetIsRefused)
{
    expect_refused(changed(upper, "seat_y_m = 7.74", "seat_y_m = 8.0"), {"row 15", "step", "7.57", "7.31"});
    expect_refused(changed(upper, "radius_m = 19.6", "radius_m = 20.2"),
                   {"row 14", "row 15", "19.6", "20.2", "walkway"});
    expect_refused(changed(middle, "radius_m = 15.7", "radius_m = 15.1"), {"row 10", "0.43 m of stone", "15"});
    expect_refused(changed(lower, "radius_m = 6.9", "radius_m = 6.3"), {"row 1", "6.3", "6.2"});
    expect_refused(changed(walkway, "y_m = 4.30", "y_m = 5.30"), {"row 10", "5.16", "5.3"});
}

TEST(Theatre, AWalkwayThroughSeatsIsRefused)
{
    expect_refused(changed(walkway, "inner_m = 13.92", "inner_m = 13.5"), {"walkway", "13.5", "13.92"});
    expect_refused(changed(walkway, "outer_m = 15.0", "outer_m = 13.0"), {"walkway 1", "13.92", "13 m"});
}

TEST(Theatre, InvalidGangwaysAreRefused)
{
    expect_refused(changed(stairs, "-64.6", "-120.0"), {"gangway 1", "-120", "row 1", "-97"});
    expect_refused(changed(stairs, "rows = [1, 9]", "rows = [1, 19]"), {"19", "1 to 18"});
    expect_refused(changed(stairs, "rows = [1, 9]", "rows = [9, 1]"), {"row 9 to row 1"});
    expect_refused(changed(stairs, "width_m = 0.85", "width_m = 8.0"), {"no seats", "row 1", "0.65"});
    expect_refused(changed(stairs, "width_m = 0.85", "width_m = -1.0"), {"'width_m' = -1"});
}

TEST(Theatre, ARowOnTheStageIsRefused)
{
    expect_refused(changed(lower, "[-97.0, 97.0]", "[-97.0, 170.0]"), {"row 1", "170", "stage", "5.2"});
}

TEST(Theatre, UnknownClassesAndCharactersAreRefusedWithTheirRow)
{
    expect_refused(changed(upper, "class = \"plebeians\"", "class = \"slaves\""), {"row 15", "'slaves'"});
    expect_refused(changed(palette, "character = \"decurion\"", "character = \"emperor\""), {"'emperor'", "patrician"});
    expect_refused(changed("women of", "name = \"patricians\"", "name = \"decurions\""), {"second class 'decurions'"});
}

TEST(Theatre, MorePeopleThanSeatsAreRefusedWithBothNumbers)
{
    expect_refused(changed(palette, "count = 340", "count = 391"), {"391 decurions", "390 seats", "rows 1, 2"});
    EXPECT_EQ(refusal_of(changed(palette, "count = 340", "count = 390")), "read");
    expect_refused(changed(lower, "class = \"decurions\"", ""), {"340 decurions", "no row is theirs"});
}
