// Files that the tests write, one of each format at least: all give the same two people.
#include <clocale>

#include "fixture.h"

namespace claque::testing
{
namespace
{

constexpr double turn = 1.5707963267948966;

void expect_walk(const asset::Trajectories &read, const Written &file)
{
    ASSERT_EQ(read.people.size(), 2u) << all_warnings(read);
    EXPECT_EQ(read.facts.id_count, std::string(file.name) == "rider.fcd.xml" ? 3u : 2u);
    EXPECT_EQ(read.facts.most_at_once, 2u);
    EXPECT_NEAR(read.facts.step_s, file.step_s, 1e-9);
    EXPECT_EQ(read.facts.has_headings, file.headings);
    EXPECT_STREQ(read.people[0].id, "1");
    EXPECT_STREQ(read.people[1].id, "2");
    for (size_t p = 0; p < 2; ++p) {
        const asset::Person &person = read.people[p];
        ASSERT_EQ(person.count, file.samples);
        for (size_t i = 0; i < person.count; ++i) {
            const clq_trajectory_sample &sample = read.samples[person.first + i];
            const double walked = double(i) / double(file.samples - 1);
            EXPECT_NEAR(sample.time_s, file.first_s + double(i) * file.step_s, 1e-9);
            EXPECT_NEAR(sample.x, p == 0 ? 2 * walked : 2, 1e-9);
            EXPECT_NEAR(sample.y, p == 0 ? 1 : 3 - walked, 1e-9);
            EXPECT_EQ(sample.z, 0);
            EXPECT_EQ(sample.flags, 0u);
            if (file.headings && (i > 0 || file.format != CLQ_TRAJECTORY_JUPEDSIM))
                EXPECT_NEAR(double(sample.heading_rad), p == 0 ? 0 : -turn, 1e-6);
            else EXPECT_TRUE(std::isnan(sample.heading_rad));
        }
    }
}

TEST(WrittenTrajectories, OfEachFormatGiveTheSamePeople)
{
    size_t formats = 0;
    for (const Written &file : written_files()) {
        SCOPED_TRACE(file.name);
        const asset::Trajectories read = read_bytes(file.bytes, file.options, file.name);
        EXPECT_EQ(read.facts.format, file.format);
        expect_walk(read, file);
        ++formats;
    }
    EXPECT_GE(formats, 12u);
}

TEST(WrittenTrajectories, AreReadTheSameWhenTheFormatIsGiven)
{
    for (const Written &file : written_files()) {
        SCOPED_TRACE(file.name);
        asset::TrajectoryOptions options = file.options;
        options.format = file.format;
        expect_walk(read_bytes(file.bytes, options), file);
    }
}

TEST(WrittenTrajectories, WarnOfNothingButRidersAndPredictions)
{
    for (const Written &file : written_files()) {
        const asset::Trajectories read = read_bytes(file.bytes, file.options, file.name);
        if (std::string(file.name) == "rider.fcd.xml")
            EXPECT_EQ(all_warnings(read), "left out 11 rows of people in a vehicle; the first is line 5\n");
        else if (file.format == CLQ_TRAJECTORY_TRAJNET)
            EXPECT_EQ(all_warnings(read), "left out 1 row of predictions; the first is line 24\n");
        else if (file.format == CLQ_TRAJECTORY_PATHFINDER_JSON)
            EXPECT_EQ(all_warnings(read),
                      "put in order 20 rows that came after a later row of the same person; the first is entry 2\n");
        else EXPECT_EQ(all_warnings(read), "") << file.name;
    }
}

TEST(WrittenTrajectories, HaveTheHeightOfHeadsWhereTheFileHasIt)
{
    for (const Written &file : written_files()) {
        const asset::Trajectories read = read_bytes(file.bytes, file.options, file.name);
        if (file.format == CLQ_TRAJECTORY_PETRACK || file.format == CLQ_TRAJECTORY_JPSREPORT)
            EXPECT_FLOAT_EQ(read.people[1].height_m, 1.75f) << file.name;
        else EXPECT_TRUE(std::isnan(read.people[1].height_m)) << file.name;
    }
}

TEST(WrittenTrajectories, OfVehiclesAreReadOnRequest)
{
#ifndef CLAQUE_HAS_EXPAT
    GTEST_SKIP() << "this build has no expat";
#endif
    for (const Written &file : written_files()) {
        if (std::string(file.name) != "rider.fcd.xml") continue;
        asset::TrajectoryOptions options;
        options.vehicles = true;
        options.max_speed_m_s = 4;  // of people
        const asset::Trajectories read = read_bytes(file.bytes, options);
        ASSERT_EQ(read.people.size(), 4u) << all_warnings(read);
        EXPECT_STREQ(read.people[0].id, "car");
        EXPECT_EQ(read.samples[0].flags, CLQ_TRAJECTORY_VEHICLE);
        EXPECT_STREQ(read.people[1].id, "rider");
        EXPECT_EQ(read.samples[read.people[1].first].flags, CLQ_TRAJECTORY_RIDES);
        EXPECT_EQ(read.people[1].count, 11u);
        EXPECT_NEAR(double(read.samples[0].heading_rad), turn, 1e-6);
    }
}

TEST(WrittenTrajectories, ATableWithYUpIsTurnedOverItsXAxis)
{
    asset::TrajectoryOptions options = of_table("id,frame,x,y,z,heading", 10, 2);
    options.up = CLQ_UP_Y;
    const asset::Trajectories read = read_text("a 5 1 2 3 90\na 6 1.25 2.5 3.5 -180\n", options);
    ASSERT_EQ(read.samples.size(), 2u);
    EXPECT_EQ(read.samples[0].time_s, 0.5);
    EXPECT_EQ(read.samples[0].x, 2);
    EXPECT_EQ(read.samples[0].y, -6);
    EXPECT_EQ(read.samples[0].z, 4);
    EXPECT_NEAR(double(read.samples[0].heading_rad), turn, 1e-6);
    EXPECT_NEAR(double(read.samples[1].heading_rad), 2 * turn, 1e-6);
}

TEST(WrittenTrajectories, NumbersAreReadWhateverTheLocale)
{
    std::string old = std::setlocale(LC_ALL, nullptr);
    const char *const comma = std::setlocale(LC_ALL, "de_DE.UTF-8");
    const asset::Trajectories read = read_text("a,1,1.5,2.25\na,2,1.75,2\n", of_table("id,frame,x,y", 1));
    std::setlocale(LC_ALL, old.c_str());
    EXPECT_EQ(read.samples[0].x, 1.5);
    EXPECT_EQ(read.samples[0].y, 2.25);
    if (!comma) GTEST_SKIP() << "read in the locale " << old << ": this machine has no de_DE.UTF-8";
}

TEST(WrittenTrajectories, ATimeWindowLeavesOutWhatIsOutside)
{
    for (const Written &file : written_files()) {
        if (file.format != CLQ_TRAJECTORY_CROWDIT) continue;
        asset::TrajectoryOptions options;
        options.start_s = 2.9, options.end_s = 3.5;
        const asset::Trajectories read = read_bytes(file.bytes, options);
        ASSERT_EQ(read.samples.size(), 6u);
        EXPECT_EQ(read.facts.min_s, 3);
        EXPECT_EQ(read.facts.max_s, 3.4);
        EXPECT_EQ(read.facts.row_count, 22u);
        options.start_s = 7, options.end_s = 8;
        EXPECT_EQ(refusal_of(file.bytes, options).status, CLQ_ARGUMENT);
    }
}

}  // namespace
}  // namespace claque::testing
