// One walk in several files: equal people from equal data.
#include "sample_walks.h"

namespace claque::testing
{
namespace
{

// 30 people of one run, in three formats.
TEST(SampleFilesOfOneRun, GiveEqualPeople)
{
    CLAQUE_NEEDS_TRACKS();
    CLAQUE_NEEDS_LIBRARY_OF("pedpy/trajectories.sqlite");
    const asset::Trajectories second = read_track_file("pedpy/trajectories.sqlite");
    const asset::Trajectories third = read_track_file("derived/jupedsim_v3.sqlite");
    const asset::Trajectories viswalk = read_track_file("derived/viswalk_from_trajectories_sqlite.pp");
    ASSERT_EQ(second.samples.size(), 8083u);
    ASSERT_EQ(third.samples.size(), second.samples.size());
    ASSERT_EQ(viswalk.samples.size(), second.samples.size());
    EXPECT_EQ(viswalk.facts.most_at_once, second.facts.most_at_once);
    for (size_t i = 0; i < second.people.size(); ++i) {
        EXPECT_STREQ(third.people[i].id, second.people[i].id);
        EXPECT_STREQ(viswalk.people[i].id, second.people[i].id);
        EXPECT_EQ(viswalk.people[i].first, second.people[i].first);
        EXPECT_EQ(third.people[i].count, second.people[i].count);
    }
    for (size_t i = 0; i < second.samples.size(); ++i) {
        const clq_trajectory_sample &a = second.samples[i], &b = third.samples[i], &c = viswalk.samples[i];
        EXPECT_EQ(a.time_s, b.time_s);
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
        EXPECT_NEAR(a.time_s + 0.04, c.time_s, 1e-9);
        EXPECT_NEAR(a.x, c.x, 5.1e-4);
        EXPECT_NEAR(a.y, c.y, 5.1e-4);
    }
    EXPECT_TRUE(second.facts.has_headings);
    EXPECT_FALSE(third.facts.has_headings);
}

// obsmat is the vsp file, read linearly.
TEST(SampleFilesOfOneRun, ControlPointsMeetTheRowsThatWereMadeFromThem)
{
    CLAQUE_NEEDS_TRACKS();
    const asset::Trajectories rows = read_track_file("opentraj/zara01/obsmat.txt");
    const asset::Trajectories points = read_track_file("opentraj/zara01/annotation.vsp");
    const std::vector<Samples> people = by_id(points), wanted = by_id(rows);
    ASSERT_EQ(people.size(), wanted.size());
    size_t met = 0;
    for (size_t i = 0; i < people.size(); ++i)
        for (const clq_trajectory_sample &sample : sampled(people[i], 0.4))
            for (const clq_trajectory_sample &row : wanted[i]) {
                // Its frame numbers begin at 1.
                if (std::fabs(row.time_s - 0.04 - sample.time_s) > 1e-6) continue;
                EXPECT_NEAR(row.x, sample.x, 5e-6);
                EXPECT_NEAR(row.y, sample.y, 5e-6);
                ++met;
            }
    EXPECT_EQ(met, 5024u);
}

}  // namespace
}  // namespace claque::testing
