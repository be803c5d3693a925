// The panel Frame: times of the update's steps, the last ten seconds, and what a switch changed.
#include <numeric>

#include "tests/view/staged.h"

namespace
{

using view_test::Staged;

// Each call is a millisecond later.
double ticking()
{
    static double seconds = 0;
    return seconds += 0.001;
}

class FrameCosts : public Staged
{
protected:
    bool says(const std::string &words)
    {
        for (const view::Widget &text : session().ui().texts())
            if (text.name.find(words) != std::string::npos) return true;
        return false;
    }
};

TEST_F(FrameCosts, HaveTheTimesOfTheUpdatesStepsWhereTimesAreMeasured)
{
    const auto surface = view::make_offscreen_surface(contexts::Kind::any, 640, 480);
    view::Session measured(
        *surface,
        [](scenes::Library &) {
            view::Opened opened;
            opened.options.scene = "plaza";
            opened.options.crowd_options.count = 5;
            return opened;
        },
        view::Switches(), 1, ticking);
    measured.model().open.camera = measured.model().open.person = false;
    measured.model().open.frame = true;
    view::Input input;
    input.width = 640, input.height = 480, input.elapsed_s = 0.04;
    for (int frame = 0; frame < 4; ++frame) measured.frame(input);
    const clq_update_times &t = measured.model().cost.steps;
    ASSERT_TRUE(t.measured);
    for (const double step : {t.cull_s, t.choose_s, t.behave_s, t.animate_s, t.cull_parts_s, t.skin_s, t.list_s})
        EXPECT_NEAR(step, 0.001, 1e-9);
    int rows = 0;
    for (const view::Widget &text : measured.ui().texts()) rows += text.name == "1.00 ms";
    EXPECT_GE(rows, 7);
}

TEST_F(FrameCosts, AreThoseOfTheLastTenSeconds)
{
    view::Session &s = open({});
    play({"click \"Frame\"", "wait 4"});
    EXPECT_LT(s.model().history.size(), 250u);
    play({"wait 12"});
    const view::Model &model = s.model();
    EXPECT_NEAR(model.history.front().at_s, model.real_s - 10, 0.05);
    EXPECT_EQ(model.history.back().at_s, model.real_s);
    EXPECT_NEAR(static_cast<double>(model.history.size()), 250, 2);
    EXPECT_TRUE(says("people due, last 10 s"));
}

TEST_F(FrameCosts, SayWhatASwitchChanged)
{
    view::Session &s = open({"plaza", 8, 480, 480});
    play({"click \"Camera\"", "click \"Person\"", "click \"Frame\"", "wait 3"});
    EXPECT_FALSE(says("before, "));
    play({"click \"caches: none\"", "wait 3", "see \"caches: none, \""});
    const view::Model &model = s.model();
    ASSERT_EQ(model.switched.size(), 1u);
    double before = 0, since = 0, frames_before = 0, frames_since = 0;
    for (const view::FrameCost &one : model.history) {
        const bool after = one.at_s > model.switched[0].at_s;
        (after ? since : before) += one.crowd.skinned;
        (after ? frames_since : frames_before) += 1;
    }
    ASSERT_GT(frames_before * frames_since, 0);
    before /= frames_before, since /= frames_since;
    EXPECT_GT(since, before) << "without caches all are skinned in each frame";
    char words[64];
    std::snprintf(words, sizeof words, "%.1f before, %.1f since", before, since);
    EXPECT_TRUE(says(words)) << words;
    play({"wait 10"});
    EXPECT_TRUE(model.switched.empty()) << "more than ten seconds ago";
}

TEST_F(FrameCosts, KnowIndividualsWithTexturesOfTheirOwnWithoutAWorldMadeAnew)
{
    view::Session &s = open({"plaza", 8, 480, 480});
    play({"click \"Camera\"", "click \"Person\"", "click \"Frame\"", "wait 1"});
    const double before_s = s.model().real_s;
    play({"click \"close textures: on\"", "wait 0.4", "see \"close textures: on, \""});
    EXPECT_EQ(s.model().switches.close_textures, 1);
    EXPECT_GT(s.model().cost.drawn.individuals, 0u);
    EXPECT_GT(s.model().history.size(), 20u) << "frames before the switch are kept, from " << before_s;
    play({"click \"close textures: off\"", "wait 0.4"});
    EXPECT_EQ(s.model().cost.drawn.close_individuals, 0u);
}

TEST_F(FrameCosts, CountPosedPeopleByDistanceInEachFrame)
{
    view::Session &s = open({"plaza", 8, 480, 480});
    play({"click \"Camera\"", "click \"Person\"", "click \"Frame\"", "click \"caches: none\"", "wait 2"});
    const view::Model &model = s.model();
    const size_t last = model.history.size() - 1;
    uint64_t posed = 0;
    for (int band = 0; band < CLQ_DISTANCE_BAND_COUNT; ++band)
        posed += model.history[last].crowd.bands[band].animated - model.history[last - 1].crowd.bands[band].animated;
    EXPECT_EQ(posed, model.history[last].crowd.animated);
    EXPECT_GT(posed, 0u);
    EXPECT_TRUE(says(" m: "));
}

TEST_F(FrameCosts, GoOnInAnotherContextWhereOneIsLost)
{
    view::Session &s = open({"plaza", 12, 480, 480});
    play({"wait 0.4", "click person 3", "click \"pause\"", "wait 0.1"});
    const std::vector<uint8_t> before = picture();
    s.renew();
    play({"wait 0.1"});
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(s.model().picked.actor.index1, 3u);
    EXPECT_TRUE(says("the OpenGL context was lost"));
}

}  // namespace
