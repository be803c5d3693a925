// What is wrong with one individual is found whether it is near or far, by the library's default drawing: levels of
// detail, and flat triangles where they are small.
#include <array>
#include <map>

#include "tests/parity/mutation.h"

namespace parity
{
namespace
{

class FarMutation : public Mutation
{
protected:
    void SetUp() override
    {
        Mutation::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        options_.scene = "ten_thousand";  // whose individuals stay where they are put
        options_.crowd_options.count = 600;
        make_scene_renderer();
        before_ = capture();
    }

    // Of those at the coarsest level, the one that covers most of the picture.
    clq_actor farthest() const
    {
        clq_actor found = {0, 0};
        std::pair<uint32_t, size_t> best;
        for (const clq_actor actor : scene_renderer_->scene().actors()) {
            const std::pair<uint32_t, size_t> one = {info_of(actor).level, pixels_of(before_, actor)};
            if (one.second > 0 && one > best) found = actor, best = one;
        }
        return found;
    }

    std::array<clq_actor, 2> both() const { return {nearest(before_), farthest()}; }

    void move(clq_actor actor, double by_m)
    {
        clq_transform place = info_of(actor).transform;
        place.position[0] += by_m;
        scenes::check(clq_crowd_set_transforms(crowd(), &actor, &place, 1));
    }
    void play(clq_actor actor, double later_s)
    {
        clq_play play = info_of(actor).play;
        play.start_s -= later_s;
        scenes::check(clq_actor_play(crowd(), actor, &play));
    }
    void tint(clq_actor actor, float green)
    {
        clq_template_info info = clq_template_info_init();
        scenes::check(clq_template_get_info(info_of(actor).tmpl, &info));
        std::vector<float> rgb(3 * size_t{info.zone_count});
        scenes::check(clq_actor_get_colours(crowd(), actor, rgb.data(), info.zone_count));
        std::vector<float> &first = first_[actor.index1];
        if (first.empty()) first = rgb;
        rgb = first;
        for (size_t i = 1; i < rgb.size(); i += 3) rgb[i] += rgb[i] < 0.5f ? green : -green;
        scenes::check(clq_actor_set_colours(crowd(), actor, rgb.data(), info.zone_count));
    }

    Capture before_;
    std::map<uint32_t, std::vector<float>> first_;  // colours before, by actor
};

TEST_F(FarMutation, AMovedIndividualIsCaughtByPicturesNearAndFar)
{
    for (const clq_actor actor : both()) {
        move(actor, 0.3);
        const Capture after = capture();
        EXPECT_EQ(broken(vertices_of(before_), vertices_of(after)), "") << "vertices lie in the individual's frame";
        expect_broken(broken(pictures_of(before_), pictures_of(after)), "actor_ids.outside");
        expect_broken(broken(before_, colours_of(after)), "colour.worst_zone");
        move(actor, -0.3);
    }
}

TEST_F(FarMutation, AnotherPoseIsCaughtByVerticesAndPicturesNearAndFar)
{
    for (const clq_actor actor : both()) {
        play(actor, 0.2);
        const Capture after = capture();
        expect_broken(broken(vertices_of(before_), vertices_of(after)), "positions.max_relative");
        expect_broken(broken(pictures_of(before_), pictures_of(after)), "depth.worst_actor");
        expect_broken(broken(before_, colours_of(after)), "colour.worst_zone");
        play(actor, -0.2);
    }
}

TEST_F(FarMutation, OtherColoursAreCaughtByPicturesNearAndFar)
{
    for (const clq_actor actor : both()) {
        tint(actor, 0.03f);
        const Capture after = capture();
        expect_broken(broken(pictures_of(before_), pictures_of(after)), "colour.worst_zone");
        expect_broken(broken(before_, colours_of(after)), "colour.worst_zone");
        tint(actor, 0);
    }
}

// A pixel there is 10 cm wide, and 0.01 of a channel are 2.55 of its 255 steps before light takes some of them.
TEST_F(FarMutation, AMillimetreAndAHundredthOfAColourFarAwayAreBelowTheTolerance)
{
    const clq_actor actor = farthest();
    EXPECT_GT(info_of(actor).level, 10u);
    EXPECT_LT(pixels_of(before_, actor), 200u);
    move(actor, 0.001);
    tint(actor, 0.01f);
    const Capture after = capture();
    EXPECT_EQ(broken(before_, after), "");
    EXPECT_NE(broken(before_, after, "exact"), "");
}

}  // namespace
}  // namespace parity
