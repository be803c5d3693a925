// What files have that they should not: order, repeats, gaps, jumps, reused ids, numbers that are none.
#include "fixture.h"

namespace claque::testing
{
namespace
{

const asset::TrajectoryOptions table = of_table("id,time,x,y");

std::string ids_of(const asset::Trajectories &read)
{
    std::string out;
    for (const asset::Person &person : read.people)
        out += std::string(person.id) + ":" + std::to_string(person.count) + " ";
    return out;
}

TEST(TrajectoryQuirks, RowsOutOfOrderArePutInOrder)
{
    const asset::Trajectories read = read_text("a 3 3 0\na 1 1 0\nb 1 0 0\na 2 2 0\nb 2 0 0\n", table);
    EXPECT_EQ(ids_of(read), "a:3 b:2 ");
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(read.samples[i].x, double(i + 1));
    EXPECT_EQ(all_warnings(read),
              "put in order 2 rows that came after a later row of the same person; the first is line 2\n");
}

TEST(TrajectoryQuirks, RepeatedRowsAreLeftOut)
{
    const asset::Trajectories read =
        read_text("a 1 1 0\na 2 2 0\na 2 2 0\nb 1 0 0\na 2 2 0\na 3 3 0\nb 2 0 0\n", table);
    EXPECT_EQ(ids_of(read), "a:3 b:2 ");
    EXPECT_EQ(all_warnings(read),
              "left out 2 rows with time and place of another row of the same person; the first is line 3, person "
              "'a'\n");
}

TEST(TrajectoryQuirks, OfTwoPlacesAtOneTimeTheFirstIsKept)
{
    const asset::Trajectories read = read_text("a 1 1 0\na 2 2 0\na 2 9 0\na 3 3 0\n", table);
    EXPECT_EQ(read.samples[1].x, 2);
    EXPECT_EQ(all_warnings(read),
              "left out 1 row that put a person at a second place at one time; the first is line 3, person 'a'\n");
}

TEST(TrajectoryQuirks, APersonWhoVanishesComesBackAsAnother)
{
    const asset::Trajectories read = read_text("a 1 1 0\na 2 2 0\na 9 3 0\na 10 4 0\na 40 4 0\na 41 4 0\n", table);
    EXPECT_EQ(ids_of(read), "a:2 a#2:2 a#3:2 ");
    EXPECT_EQ(read.facts.id_count, 1u);
    EXPECT_EQ(all_warnings(read),
              "people are absent for longer than 4 s in 2 places, and are others after it: the longest, 30.00 s, is "
              "that of 'a' at 40.00 s (line 5)\n");
}

TEST(TrajectoryQuirks, TheLimitOfAGapIsTheCallersOrFollowsTheStep)
{
    const std::string coarse = "a 0 1 0\na 10 2 0\na 20 3 0\na 60 3 0\na 101 3 0\na 111 3 0\n";
    EXPECT_EQ(ids_of(read_text(coarse, table)), "a:4 a#2:2 ");
    asset::TrajectoryOptions options = table;
    options.max_gap_s = 10;
    EXPECT_EQ(ids_of(read_text(coarse, options)), "a:3 a#2:1 a#3:2 ");
    options.max_gap_s = HUGE_VAL;
    EXPECT_EQ(ids_of(read_text(coarse, options)), "a:6 ");
    // A step of 0.1 s: 2.5 s are bridged, more is not.
    EXPECT_EQ(ids_of(read_text("a 0 0 0\na .1 0 0\na .2 0 0\na 2.7 0 0\na 5.3 0 0\n", table)), "a:4 a#2:1 ");
}

TEST(TrajectoryQuirks, ReusedIdsAreDifferentPeople)
{
    const asset::Trajectories read = read_text("7 1 0 0\n7 2 1 0\n7 500 40 0\n7 501 41 0\n8 1 0 0\n8 2 1 0\n", table);
    EXPECT_EQ(ids_of(read), "7:2 7#2:2 8:2 ");
    EXPECT_EQ(read.facts.most_at_once, 2u);
    EXPECT_EQ(read.facts.most_at_once_s, 1);
}

TEST(TrajectoryQuirks, AJumpMakesAnotherPerson)
{
    const std::string jump = "a 0 0 0\na 1 12 0\na 2 12 0\na 3 24.1 0\na 4 25 0\nb 0 0 0\nb 1 0 20\n";
    const asset::Trajectories read = read_text(jump, table);
    EXPECT_EQ(ids_of(read), "a:3 a#2:2 b:1 b#2:1 ");
    EXPECT_TRUE(warns(read, {"people are faster than 12 m/s in 2 places, and are others after it: the fastest, 20.0 "
                             "m/s, is that of 'b' at 1.00 s (line 7)"}))
        << all_warnings(read);
    EXPECT_TRUE(warns(read, {"2 people have one sample only; the first, at 0.00 s, is 'b'"})) << all_warnings(read);
    asset::TrajectoryOptions options = table;
    options.max_speed_m_s = HUGE_VAL;
    EXPECT_EQ(ids_of(read_text(jump, options)), "a:5 b:2 ");
    // The limit is in metres, whatever the file's unit.
    options = of_table("id,time,x,y", 0, 0.5);
    EXPECT_EQ(ids_of(read_text(jump, options)), "a:5 b:2 ");
}

TEST(TrajectoryQuirks, NumbersThatAreNoneLeaveTheRowOut)
{
    const asset::Trajectories read =
        read_text("a,1,nan,0\na,2,2,0\na,3,inf,0\na,4,,0\na,5,1e400,0\na,2e9,5,0\na,6,1e-400,0\n,7,7,0\n", table);
    EXPECT_EQ(ids_of(read), "a:2 ");
    EXPECT_EQ(read.facts.row_count, 8u);
    EXPECT_TRUE(warns(read, {"left out 4 rows with a number that is not finite or beyond 1e9; the first is line 1"}))
        << all_warnings(read);
    EXPECT_TRUE(warns(read, {"left out 2 rows that lack a value; the first is line 4"})) << all_warnings(read);
}

TEST(TrajectoryQuirks, ARowThatWasCutOffIsLeftOut)
{
    const asset::Trajectories read = read_text("a 1 1 0\na 2 2 0\na 3 3", table);
    EXPECT_EQ(ids_of(read), "a:2 ");
    EXPECT_EQ(all_warnings(read), "left out 1 row that lack a value; the first is line 3\n");
}

TEST(TrajectoryQuirks, IdsAreTextsAndWholeNumbersAreWrittenPlainly)
{
    const asset::Trajectories read = read_text(
        "1.0e+00 1 1 0\n0001 1 0 0\n2.5 1 0 0\ncaf\xc3\xa9 1 0 0\ncaf\xe9 2 0 0\na\x01z 1 0 0\n-3.0 1 0 0\n", table);
    EXPECT_EQ(ids_of(read), "1:1 0001:1 2.5:1 caf\xc3\xa9:2 a?z:1 -3:1 ");
}

TEST(TrajectoryQuirks, IdsInAnyOrderAreFoundAgain)
{
    // Two people in turn, then others between them, as files by time have.
    std::string text;
    for (int t = 0; t < 60; ++t)
        for (int p = 0; p < 40; ++p)
            if ((t * 7 + p * 13) % 5 != 0)
                text += std::to_string((p * 17 + t % 3) % 40) + " " + std::to_string(t) + " 0 0\n";
    const asset::Trajectories read = read_text(text, table);
    EXPECT_EQ(read.facts.id_count, 40u);
    for (const asset::Person &person : read.people)
        for (uint64_t i = 1; i < person.count; ++i)
            EXPECT_LT(read.samples[person.first + i - 1].time_s, read.samples[person.first + i].time_s);
}

TEST(TrajectoryQuirks, TheSmallestStepOfFrameNumbersTellsTheRate)
{
    for (const int step : {6, 10}) {
        std::string text;
        for (const int k : {0, 1, 2, 5, 6}) text += std::to_string(780 + step * k) + " 4 1.5 0 2.5 0 0 0\n";
        const asset::Trajectories read = read_text(text);
        EXPECT_EQ(read.facts.format, CLQ_TRAJECTORY_OBSMAT);
        ASSERT_EQ(read.samples.size(), 5u);
        EXPECT_NEAR(read.samples[4].time_s - read.samples[0].time_s, 6 * 0.4, 1e-9);
        asset::TrajectoryOptions options;
        options.rate_hz = 100;
        EXPECT_NEAR(read_text(text, options).samples[0].time_s, 7.8, 1e-12);
    }
}

TEST(TrajectoryQuirks, AStepThatBeginsWhereTheLastEndedIsNoRepeat)
{
    const std::string head = "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1\n";
    const asset::Trajectories read =
        read_text(head + "1 0 0.5 0 0 0.5 0\n1 0.5 1.5 0.5 0 0.5 0\n1 1.5 9.5 0.5 0 3 0\n");
    EXPECT_EQ(ids_of(read), "1:4 ");
    EXPECT_EQ(all_warnings(read), "");
    EXPECT_EQ(read.facts.row_count, 3u);
    // Steps at odds are noticed.
    EXPECT_TRUE(warns(read_text(head + "1 0 1 0 0 1 0\n1 1 2 3 0 4 0\n"), {"a second place at one time"}));
}

TEST(TrajectoryQuirks, PeopleInAVehicleAreAnotherPersonAfterIt)
{
#ifndef CLAQUE_HAS_EXPAT
    GTEST_SKIP() << "this build has no expat";
#endif
    std::string text = "<fcd-export>";
    for (int t = 0; t < 6; ++t) {
        const bool rides = t == 2 || t == 3;
        text += "<timestep time=\"" + std::to_string(t) + "\"><person id=\"p\" x=\"" + std::to_string(t) +
                "\" y=\"0\" speed=\"1\" angle=\"90\"/><vehicle id=\"v\" x=\"" + std::to_string(rides ? t : 50) +
                "\" y=\"0\" speed=\"1\" angle=\"0\"/></timestep>";
    }
    EXPECT_EQ(ids_of(read_text(text + "</fcd-export>")), "p:2 p#2:2 ");
    asset::TrajectoryOptions options;
    options.vehicles = true, options.max_gap_s = HUGE_VAL;
    EXPECT_EQ(ids_of(read_text(text + "</fcd-export>", options)), "p:2 p#2:2 p#3:2 v:6 ");
}

TEST(TrajectoryQuirks, AVehicleHasItsOwnIdUnlessAPersonHasItToo)
{
#ifndef CLAQUE_HAS_EXPAT
    GTEST_SKIP() << "this build has no expat";
#endif
    const std::string at = " x=\"0\" y=\"0\" speed=\"1\" angle=\"90\"/>";
    const std::string text = "<fcd-export><timestep time=\"0\"><vehicle id=\"both\"" + at + "<vehicle id=\"bus\"" + at +
                             "<person id=\"both\"" + " x=\"5\" y=\"0\" speed=\"1\" angle=\"90\"/>" +
                             "</timestep></fcd-export>";
    asset::TrajectoryOptions options;
    options.vehicles = true;
    EXPECT_EQ(ids_of(read_text(text, options)), "vehicle both:1 bus:1 both:1 ");
}

TEST(TrajectoryQuirks, AStandingPersonOfSumoHasNoHeading)
{
#ifndef CLAQUE_HAS_EXPAT
    GTEST_SKIP() << "this build has no expat";
#endif
    const asset::Trajectories read = read_text(
        "<fcd-export><timestep time=\"0\"><person id=\"a\" x=\"0\" y=\"0\" angle=\"0.00\" speed=\"0.00\"/><person "
        "id=\"b\" x=\"1\" y=\"0\" angle=\"0.00\" speed=\"1\"/><person id=\"c\" x=\"2\" y=\"0\" angle=\"45\" "
        "speed=\"0\"/><person id=\"d\" x=\"2\" y=\"0\"/></timestep></fcd-export>");
    ASSERT_EQ(read.samples.size(), 4u);
    EXPECT_TRUE(std::isnan(read.samples[0].heading_rad));
    EXPECT_FLOAT_EQ(read.samples[1].heading_rad, 1.57079633f);
    EXPECT_FLOAT_EQ(read.samples[2].heading_rad, 0.785398163f);
    EXPECT_TRUE(std::isnan(read.samples[3].heading_rad));
}

}  // namespace
}  // namespace claque::testing
