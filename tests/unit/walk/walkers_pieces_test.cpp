// What walkers publish are pieces of tracks without gaps and jumps, and a crowd shows them.
#include <claque/assets.h>
#include <claque/view.h>

#include <cstddef>
#include <map>
#include <stdexcept>

#include "tests/unit/walk/floors.h"

using floors::Held;

namespace
{

class Published : public testing::Test
{
protected:
    Published()
    {
        EXPECT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        EXPECT_EQ(clq_template_builtin(context_, "citizen", &citizen_), CLQ_OK) << clq_last_error();
        const uint32_t stand = clq_template_find_clip(citizen_, "stand");
        clq_locomotion_def walk = clq_locomotion_def_init();
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        walk.run = clq_template_find_clip(citizen_, "jog"), walk.idle_count = 1, walk.idles = &stand;
        EXPECT_EQ(clq_locomotion_create(context_, &walk, &locomotion_), CLQ_OK) << clq_last_error();
    }
    ~Published() override
    {
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    static std::vector<clq_walker_piece> pieces(const Held &held)
    {
        const clq_walker_piece *first = nullptr;
        uint32_t count = 0;
        EXPECT_EQ(clq_walkers_get_pieces(held.walkers, &first, &count), CLQ_OK);
        return {first, first + count};
    }
    static clq_track_state at(const clq_track *track, double time_s)
    {
        clq_track_state out;
        EXPECT_EQ(clq_track_evaluate(track, time_s, &out), CLQ_OK);
        return out;
    }
    std::vector<clq_walker> people(const Held &held, int count) const
    {
        std::vector<clq_walker> out;
        for (int i = 0; i < count; ++i) {
            out.push_back(held.add(1 + 0.7 * (i % 5), 0.8 + 0.9 * (i / 5), locomotion_));
            held.go(out.back(), 15 - 0.7 * (i % 5), 0.8 + 0.9 * (i / 5));
        }
        return out;
    }

    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
};

}  // namespace

TEST_F(Published, PiecesFollowEachOtherWithoutGapOrJump)
{
    const Held held(floors::two_rooms(false));
    people(held, 15);
    std::map<uint32_t, std::pair<clq_track_info, clq_track_state>> last;
    size_t count = 0;
    double farthest = 0;
    std::map<uint32_t, std::map<int, floors::Point>> been;
    for (int tick = 1; tick <= 400; ++tick) {
        held.step();
        for (uint32_t i = 1; i <= 15; ++i) {
            const clq_walker_info now = held.info({i, 1});
            been[i][tick] = {now.position[0], now.position[1], now.position[2]};
        }
        for (const clq_walker_piece &piece : pieces(held)) {
            ++count;
            clq_track_info info = clq_track_info_init();
            ASSERT_EQ(clq_track_get_info(piece.track, &info), CLQ_OK);
            ASSERT_NEAR(info.start_s, piece.begin_s, 1e-9);
            ASSERT_NEAR(info.end_s, piece.end_s, 1e-9);
            ASSERT_NEAR(info.end_s, 0.05 * tick, 1e-9);
            const auto before = last.find(piece.walker.index1);
            if (before == last.end()) {
                ASSERT_EQ(piece.begin_s, 0);
                ASSERT_EQ(info.previous_hash, 0u);
            } else {
                const auto &[old, end] = before->second;
                ASSERT_EQ(info.previous_hash, old.hash);
                const clq_track_state begin = at(piece.track, info.start_s);
                ASSERT_LT(floors::apart(begin.position, end.position), 0.0003);
                ASSERT_EQ(begin.gait, end.gait);
                ASSERT_NEAR(begin.phase, end.phase, 1e-6);
                ASSERT_NEAR(std::remainder(begin.heading_rad - end.heading_rad, 2 * M_PI), 0, 1e-6);
            }
            last[piece.walker.index1] = {info, at(piece.track, info.end_s)};
            for (int t = static_cast<int>(info.start_s / 0.05 + 0.5); t <= tick; ++t)
                if (t > 0)
                    farthest = std::max(farthest, floors::apart(at(piece.track, 0.05 * t).position,
                                                                been[piece.walker.index1][t].data()));
        }
    }
    std::printf("walkers: their tracks are at most %.3f m beside them\n", farthest);
    EXPECT_LT(farthest, 0.25);
    EXPECT_GT(count, 15u * 38);
}

TEST_F(Published, PiecesAreTheSameWhenAllIsDoneAgain)
{
    const auto run = [&] {
        const Held held(floors::two_rooms(false));
        people(held, 10);
        std::vector<uint64_t> hashes;
        for (int tick = 0; tick < 200; ++tick) {
            held.step();
            for (const clq_walker_piece &piece : pieces(held)) {
                clq_track_info info = clq_track_info_init();
                EXPECT_EQ(clq_track_get_info(piece.track, &info), CLQ_OK);
                hashes.push_back(info.hash);
            }
        }
        return hashes;
    };
    const std::vector<uint64_t> first = run();
    EXPECT_GT(first.size(), 150u);
    EXPECT_EQ(first, run());
}

TEST_F(Published, PiecesAreSpreadOverTheTicks)
{
    const Held held(floors::two_rooms(false));
    people(held, 30);
    held.step(20);
    size_t sum = 0;
    for (int tick = 0; tick < 20; ++tick) {
        held.step();
        const size_t count = pieces(held).size();
        ASSERT_LE(count, 6u);  // of 30 in ten ticks
        sum += count;
    }
    EXPECT_EQ(sum, 60u);
}

TEST_F(Published, PiecesAreShownByACrowdWhileTheyAreMade)
{
    const Held held(floors::two_rooms(false));
    const std::vector<clq_walker> walkers = people(held, 8);
    clq_crowd *crowd = nullptr;
    clq_view *view = nullptr;
    ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd), CLQ_OK);
    ASSERT_EQ(clq_view_create(crowd, &view), CLQ_OK);
    std::map<uint32_t, clq_actor> actors;
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = citizen_;
    for (const clq_walker walker : walkers)
        ASSERT_EQ(clq_actor_create(crowd, &def, &actors[walker.index1]), CLQ_OK) << clq_last_error();
    for (int tick = 1; tick <= 200; ++tick) {
        held.step();
        for (const clq_walker_piece &piece : pieces(held))
            ASSERT_EQ(clq_actor_follow_track(crowd, actors[piece.walker.index1], piece.track, 0), CLQ_OK);
        if (tick < 30) continue;
        // Shown a second behind what is decided.
        const double time_s = 0.05 * tick - 1;
        ASSERT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_release_tracks(crowd, nullptr), CLQ_OK);
    }
    for (const clq_walker walker : walkers) {
        double root[16] = {};
        ASSERT_EQ(clq_actor_get_node(crowd, actors[walker.index1], 0, 9, root), CLQ_OK) << clq_last_error();
        EXPECT_GT(root[12], 6);  // from 1 to 4 at 1.34 m/s for 9 s
    }
    clq_view_destroy(view);
    clq_crowd_destroy(crowd);
}

TEST_F(Published, PiecesComeLateWhereTheGroundThrows)
{
    int broken = 0;
    clq_walkers_def def = clq_walkers_def_init();
    def.ground_user = &broken;
    def.ground = [](void *user, const double[3]) {
        if (*static_cast<int *>(user) > 0) throw std::runtime_error("no stone");
        return 0.0;
    };
    const Held held(floors::two_rooms(false), &def), sound(floors::two_rooms(false), &def);
    people(held, 4), people(sound, 4);
    size_t here = 0, there = 0, refused = 0;
    for (int tick = 0; tick < 60; ++tick) {
        sound.step();
        there += pieces(sound).size();
        broken = tick % 20 == 12;
        const clq_status status = clq_walkers_step(held.walkers);
        broken = 0;
        if (status == CLQ_OK) {
            here += pieces(held).size();
            continue;
        }
        ++refused;
        EXPECT_EQ(status, CLQ_CALLBACK);
        EXPECT_NE(std::string(clq_last_error()).find("threw an exception: no stone"), std::string::npos)
            << clq_last_error();
    }
    EXPECT_GT(refused, 0u);
    EXPECT_EQ(here, there);
    EXPECT_EQ(held.hash(), sound.hash());
}

// Hosts that were compiled with the first headers pass a shorter struct.
TEST_F(Published, PiecesOfHostsOfEarlierHeadersKnowNoGround)
{
    clq_walkers_def def = clq_walkers_def_init();
    def.struct_bytes = offsetof(clq_walkers_def, ground);
    def.ground = [](void *, const double[3]) -> double { throw std::runtime_error("it is not read"); };
    const Held held(floors::two_rooms(false), &def);
    people(held, 2);
    held.step(30);
    clq_walkers *made = nullptr;
    def.struct_bytes -= 4;
    EXPECT_EQ(clq_walkers_create(held.navigation, &def, &made), CLQ_STRUCT_SIZE);
}
