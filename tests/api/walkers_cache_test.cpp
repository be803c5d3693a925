// A cache shows what the crowd shows without one: after commands at the time shown, back at time 0, and one actor
// beside others.
#include <claque/drawn_actor.h>
#include <claque/play.h>

#include <array>

#include "tests/api/walkers.h"

using walkers::Walkers;

namespace
{

class WalkersCache : public Walkers
{
protected:
    clq_crowd *kept_in(clq_cache_mode cache)
    {
        clq_crowd_def def = clq_crowd_def_init();
        def.cache = cache;
        return crowd(&def);
    }
    static uint64_t shown(clq_crowd *crowd, clq_view *view, double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view);
    }
    clq_play clip(const char *name, double start_s) const
    {
        clq_play play = clq_play_init();
        play.clip = clq_template_find_clip(citizen_, name), play.start_s = start_s;
        return play;
    }
};

using Matrix = std::array<float, 16>;

Matrix model_view(clq_view *view, uint32_t index)
{
    clq_drawn_actor drawn = clq_drawn_actor_init();
    EXPECT_EQ(clq_view_get_drawn_actor(view, index, &drawn), CLQ_OK) << clq_last_error();
    Matrix out;
    std::copy(drawn.model_view, drawn.model_view + 16, out.begin());
    return out;
}

}  // namespace

// The layers of a pose depend on its tick and its version alone: a cache that overlooks the version shows the old one.
TEST_F(WalkersCache, ShowACommandThatIsGivenAtTheTimeShown)
{
    const auto story = [&](clq_cache_mode cache) {
        clq_crowd *crowd = kept_in(cache);
        clq_view *view = this->view(crowd, 9);
        const clq_actor actor = walker(crowd, track(1.2, 0));
        const uint64_t walks = shown(crowd, view, 3);
        clq_layer_def wave = clq_layer_def_init();
        clq_layer added;
        wave.play = clip("wave", 1);
        EXPECT_EQ(clq_actor_add_layer(crowd, actor, &wave, &added), CLQ_OK) << clq_last_error();
        const uint64_t waves = shown(crowd, view, 3);
        EXPECT_NE(waves, walks);
        return std::vector<uint64_t>{walks, waves};
    };
    EXPECT_EQ(story(CLQ_CACHE_FULL), story(CLQ_CACHE_NONE));
}

// A key-pose is of one clip alone (S3 4): a walker blends gaits and its feet are held, so it shows poses of its own. A
// person that plays one clip shows key-poses.
TEST_F(WalkersCache, ShowNoKeyPosesWhereverTheyStep)
{
    const auto story = [&](clq_key_pose_mode mode, bool on_track) {
        clq_crowd_def def = clq_crowd_def_init();
        if (mode != CLQ_KEY_POSE_INDIVIDUAL) def.key_poses.bands[0] = {0, mode}, def.key_poses.band_count = 1;
        clq_crowd *crowd = this->crowd(&def);
        clq_view *view = this->view(crowd, 9);
        if (on_track) {
            walker(crowd, track(1.2, 0));
        } else {
            clq_actor_def one = clq_actor_def_init();
            one.tmpl = citizen_, one.play = clip("walk", 0);
            clq_actor made;
            EXPECT_EQ(clq_actor_create(crowd, &one, &made), CLQ_OK) << clq_last_error();
        }
        std::vector<uint64_t> out;
        for (double t = 1; t < 6; t += 0.21) out.push_back(shown(crowd, view, t));
        return out;
    };
    const std::vector<uint64_t> walks = story(CLQ_KEY_POSE_INDIVIDUAL, true),
                                plays = story(CLQ_KEY_POSE_INDIVIDUAL, false);
    for (const clq_key_pose_mode mode : {CLQ_KEY_POSE_INTERMITTENT, CLQ_KEY_POSE_INTERPOLATED}) {
        EXPECT_EQ(story(mode, true), walks) << mode;
        EXPECT_NE(story(mode, false), plays) << mode;
    }
}

// The tick of a pose that is no function of ticks is 0, as is the tick at time 0.
TEST_F(WalkersCache, ShowTimeZeroAfterLaterTimes)
{
    const auto at_zero = [&](const std::vector<double> &before) {
        clq_crowd *crowd = kept_in(CLQ_CACHE_FULL);
        clq_view *view = this->view(crowd, 9);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen_, def.play = clip("walk", 0);
        clq_actor made;
        EXPECT_EQ(clq_actor_create(crowd, &def, &made), CLQ_OK) << clq_last_error();
        uint64_t earlier = 0;
        for (const double t : before) earlier = shown(crowd, view, t);
        const uint64_t zero = shown(crowd, view, 0);
        EXPECT_NE(zero, earlier);
        return zero;
    };
    EXPECT_EQ(at_zero({5.3}), at_zero({}));
}

TEST_F(WalkersCache, PlaceEachActorByItsOwnTrack)
{
    const auto along = [&](int i) { return track(0.6 + 0.25 * i, -2.0 * i, 0.4 * i); };
    std::vector<Matrix> alone;
    for (int i = 0; i < 5; ++i) {
        clq_crowd *crowd = kept_in(CLQ_CACHE_FULL);
        clq_view *view = this->view(crowd, 9);
        walker(crowd, along(i));
        shown(crowd, view, 4);
        ASSERT_EQ(visible(view), 1u);
        alone.push_back(model_view(view, 0));
    }
    clq_crowd *crowd = kept_in(CLQ_CACHE_FULL);
    clq_view *view = this->view(crowd, 9);
    for (int i = 0; i < 5; ++i) walker(crowd, along(i));
    shown(crowd, view, 4);
    ASSERT_EQ(visible(view), 5u);
    std::vector<Matrix> together;
    for (uint32_t i = 0; i < 5; ++i) together.push_back(model_view(view, i));
    std::sort(together.begin(), together.end());
    std::sort(alone.begin(), alone.end());
    EXPECT_EQ(together, alone);
}
