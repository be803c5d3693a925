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

    // The vertices of `a`, and of one actor those of `b`, which has the same actors with as many vertices.
    static Capture vertices_with_one_of(const Capture &a, const Capture &b, clq_actor actor)
    {
        Capture out = vertices_of(a);
        for (const Actor &one : *a.actors) {
            if (one.id != actor.index1) continue;
            for (size_t k = 3 * one.first_vertex; k < 3 * (one.first_vertex + one.vertex_count); ++k)
                (*out.positions)[k] = (*b.positions)[k], (*out.normals)[k] = (*b.normals)[k];
        }
        return out;
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
        std::string depths, colours;  // one pose may cover the few pixels of another
        for (const double later_s : {0.2, 0.5, 0.9}) {
            play(actor, later_s);
            const Capture after = capture();
            expect_broken(broken(vertices_of(before_), vertices_of(after)), "positions.max_relative");
            depths += broken(pictures_of(before_), pictures_of(after));
            colours += broken(before_, colours_of(after));
            play(actor, -later_s);
        }
        expect_broken(depths, "depth.worst_actor");
        // Far away depths alone tell: some ten triangles of one zone each keep their colours where they turn.
        if (info_of(actor).level == 0) expect_broken(colours, "colour.worst_zone");
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

TEST_F(FarMutation, AMissingIndividualIsCaughtNearAndFar)
{
    for (const clq_actor actor : both()) {
        const Capture before = capture();
        scenes::check(clq_actor_destroy(crowd(), actor));
        const Capture after = capture();
        expect_broken(broken(vertices_of(before), vertices_of(after)), "actors.missing is 1");
        expect_broken(broken(pictures_of(before), pictures_of(after)), "actor_ids.outside");
        expect_broken(broken(before, colours_of(after)), "colour.worst_zone");
    }
}

TEST_F(FarMutation, AnotherLevelOfDetailIsCaughtNearAndFar)
{
    for (const clq_actor actor : both()) {
        const uint32_t level = info_of(actor).level;
        scenes::check(clq_actor_set_priority(crowd(), actor, 0.9f));
        const Capture after = capture();
        ASSERT_NE(info_of(actor).level, level);
        expect_broken(broken(vertices_of(before_), vertices_of(after)), "actors.changed is 1");
        expect_broken(broken(pictures_of(before_), pictures_of(after)), "actor_ids.outside");
        expect_broken(broken(before_, colours_of(after)), "colour.worst_zone");
        scenes::check(clq_actor_set_priority(crowd(), actor, 0));
    }
}

// The two zones of an individual that most pixels show, in the id maps alone and in colours alone.
TEST_F(FarMutation, TwoZonesSwappedAreCaughtNearAndFar)
{
    for (const clq_actor actor : both()) {
        Capture after = before_;
        const uint32_t first = static_cast<uint32_t>(widest_zone(before_, actor)) + 1;
        for (size_t i = 0; i < after.zone->values.size(); ++i)
            if (after.actor->values[i] == actor.index1 && after.zone->values[i] == first) after.actor->values[i] = 0;
        const uint32_t second = static_cast<uint32_t>(widest_zone(after, actor)) + 1;
        ASSERT_NE(first, second);
        after.actor = before_.actor;
        for (size_t i = 0; i < after.zone->values.size(); ++i) {
            auto &zone = after.zone->values[i];
            if (after.actor->values[i] != actor.index1 || (zone != first && zone != second)) continue;
            zone = static_cast<std::remove_reference_t<decltype(zone)>>(first + second - zone);
        }
        expect_broken(broken(pictures_of(before_), pictures_of(after)), "zone_ids.worst_zone");
    }
}

// Of one vertex of a strip, of which all of a parade are made, in one individual. The error is so small that vertices
// stay in their order, and that far away no pixel changes.
TEST_F(FarMutation, AWrongWeightIsCaughtByVerticesNearAndFar)
{
    scene_renderer_.reset();
    options_.scene = "parade";
    options_.crowd_options.count = 40;
    std::vector<Capture> captures;
    clq_actor near = {0, 0}, far = {0, 0};
    for (const bool wrong : {false, true}) {
        std::vector<float> weights = weights_of_strip();
        if (wrong) weights[6] = 0.7f, weights[7] = 0.3f;  // row 1, which has 3 to 1
        captures.push_back(capture_of_strip(weights));
        near = nearest(captures[0]);
        far = near;
        for (const clq_actor actor : scene_renderer_->scene().actors()) {
            const size_t pixels = pixels_of(captures[0], actor);
            if (pixels > 0 && pixels < pixels_of(captures[0], far)) far = actor;
        }
        scene_renderer_.reset();
    }
    EXPECT_GT(pixels_of(captures[0], near), 2000u);
    EXPECT_LT(pixels_of(captures[0], far), 200u);
    for (const clq_actor actor : {near, far}) {
        const Capture after = vertices_with_one_of(captures[0], captures[1], actor);
        expect_broken(broken(vertices_of(captures[0]), after), "positions.max_relative");
        for (const Measure &measure : compare(vertices_of(captures[0]), after, 67).measures)
            if (measure.name == "positions.max_m") {
                EXPECT_LT(measure.value, 0.05) << "other vertices are compared";
            }
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
