// The audience as a crowd: a frame does not depend on earlier frames, and neighbours do not move alike.
#include "samples/scenes/odeon/audience.h"

#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/eye.h"
#include "samples/scenes/scenario/scenario.h"

namespace
{

using namespace scenes;

const Theatre &small_odeon()
{
    static const Theatre theatre = *odeon_scenario().theatre;
    return theatre;
}

// The view from the stage, without GL.
class House
{
public:
    explicit House(uint32_t count = 300) : library_(1), audience_(library_, small_odeon(), crowd_options(count))
    {
        clq_view *made = nullptr;
        check(clq_view_create(audience_.crowd(), &made));
        view_.reset(made);
    }
    uint64_t at(double time_s)
    {
        const clq_camera camera = look({0, 9, 8}, {0, 4, -10}, 65, 4.0 / 3.0, 0.3, 500);
        check(clq_view_set_camera(view_.get(), &camera));
        audience_.act(time_s);
        clq_view *views[] = {view_.get()};
        check(clq_crowd_update(audience_.crowd(), time_s, views, 1));
        return clq_view_get_hash(view_.get());
    }
    Audience &audience() { return audience_; }

private:
    static CrowdOptions crowd_options(uint32_t count)
    {
        CrowdOptions crowd_options;
        crowd_options.count = count;
        return crowd_options;
    }
    Library library_;
    Audience audience_;
    Own<clq_view> view_;
};

TEST(Audience, AFrameIsTheSameHoweverItIsReached)
{
    House forward, backward;
    const std::vector<double> times = {0.0, 1.3, 2.6, 7.9, 33.1, 250.0};
    std::vector<uint64_t> there, back;
    for (size_t i = 0; i < times.size(); ++i) there.push_back(forward.at(times[i]));
    for (size_t i = times.size(); i-- > 0;) back.insert(back.begin(), backward.at(times[i]));
    EXPECT_EQ(there, back);
    House alone;
    EXPECT_EQ(alone.at(times[3]), there[3]);
    EXPECT_NE(there[3], there[4]);
}

TEST(Audience, EqualCastingsMakeEqualCrowds)
{
    House one, other, fewer(299);
    EXPECT_EQ(clq_crowd_get_hash(one.audience().crowd()), clq_crowd_get_hash(other.audience().crowd()));
    EXPECT_NE(clq_crowd_get_hash(one.audience().crowd()), clq_crowd_get_hash(fewer.audience().crowd()));
}

TEST(Audience, HasThreeFiguresWithEveryClip)
{
    House house;
    EXPECT_EQ(house.audience().templates().size(), 3u);
    EXPECT_EQ(clq_crowd_get_actor_count(house.audience().crowd()), 300u);
}

TEST(Audience, NeighboursDoNotMoveAlike)
{
    Library library(1);
    const Audience audience(library, small_odeon(), [] {
        CrowdOptions crowd_options;
        crowd_options.count = 1020;
        return crowd_options;
    }());
    const auto alike = [&](size_t a, size_t b, double t) {
        const Playing p = playing_at(audience.members()[a], t), q = playing_at(audience.members()[b], t);
        return p.act == q.act && std::abs((t - p.begin_s) * p.speed - (t - q.begin_s) * q.speed) < 0.1;
    };
    size_t pairs = 0, once = 0;
    for (size_t i = 1; i < audience.members().size(); ++i) {
        bool always = true;
        for (const double t : {2.0, 9.0, 30.0}) {
            const bool same = alike(i - 1, i, t);
            always = always && same;
            once += same;
            ++pairs;
        }
        EXPECT_FALSE(always) << i;
    }
    EXPECT_LT(once, pairs / 50);
}

// Distant poses are renewed four times a second: a new clip shows nothing from before its start.
TEST(Audience, AClipThatHasJustBegunNeverShowsItsEnd)
{
    Theatre theatre = small_odeon();
    Library library(1);
    CrowdOptions crowd_options;
    crowd_options.count = 1020;
    Audience audience(library, theatre, crowd_options);
    clq_view *made = nullptr;
    check(clq_view_create(audience.crowd(), &made));
    const Own<clq_view> view(made);
    const clq_camera camera = look({0, 40, 70}, {0, 4, -10}, 65, 4.0 / 3.0, 0.3, 500);
    check(clq_view_set_camera(view.get(), &camera));
    uint32_t begun = 0;
    for (double t = 0; t < 3; t += 0.04) {
        audience.act(t);
        clq_view *views[] = {view.get()};
        check(clq_crowd_update(audience.crowd(), t, views, 1));
        for (uint32_t i = 0; i < 1020; ++i) {
            clq_actor_info info = clq_actor_info_init();
            const clq_actor actor = {i + 1, 1};
            check(clq_actor_get_info(audience.crowd(), actor, &info));
            if (!info.visible) continue;
            EXPECT_GE(info.tick_s, info.play.start_s);
            begun += t - info.play.start_s < 0.1;
        }
    }
    EXPECT_GT(begun, 100u);
}

}  // namespace
