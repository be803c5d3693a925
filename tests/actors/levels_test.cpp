// Levels of geometry, skeleton and behaviour follow one effective distance per actor (S0 5).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "meshsplit/build.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

uint32_t level_at(World &world, double distance)
{
    world.views[0]->camera =
        frame::look_at({0, 1, distance}, {0, 1, 0}, glm::vec3(0, 1, 0), 1.0471976f, 1.3f, 0.1f, 2000);
    world.update(0);
    return world.seen(world.ids[0]).level;
}

// At so many times the actor's size.
uint32_t level_of_size(World &world, float scale, double distance)
{
    const double far = scale * distance;
    world.views[0]->camera = frame::look_at({0, scale, far}, {0, scale, 0}, glm::vec3(0, 1, 0), 1.0471976f, 1.3f,
                                            0.01f * scale, 1e4f * scale);
    world.update(0);
    return world.seen(world.ids[0]).level;
}

void set_scale(World &world, float scale)
{
    crowd::Transform place;
    place.scale = scale;
    crowd::set_transforms(world.crowd, &world.ids[0], &place, 1);
}

// From the size in the picture alone: a metre of the model in pixels of 768 lines over 60 degrees, against those of a
// metre where the robot's levels begin.
uint32_t level_by_pixels(double scale, const glm::dvec3 &eye)
{
    const auto pixels = [](double metre, double away) {
        return metre * 768 / (2 * std::tan(3.14159265358979 / 6) * away);
    };
    const double shown = pixels(scale, std::sqrt(eye.x * eye.x + eye.y * eye.y + eye.z * eye.z));
    return (shown <= pixels(1, double(hands_stop_m))) + (shown <= pixels(1, double(limbs_stop_m)));
}

}  // namespace

TEST(Levels, AllPartsFollowTheActorsOneDistanceEachWithItsOwn)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    ASSERT_EQ(world.tmpl->levels.size(), 3u);
    for (const auto &[distance, level] :
         {std::pair{5.0, 0u}, {18.0, 0u}, {21.0, 1u}, {55.0, 1u}, {62.0, 2u}, {900.0, 2u}})
        EXPECT_EQ(level_at(world, distance), level) << distance;
    EXPECT_EQ(world.tmpl->levels[0].parts.size(), 10u);
    EXPECT_EQ(world.tmpl->levels[1].parts.size(), 8u);
    EXPECT_EQ(world.tmpl->levels[2].parts.size(), 1u);
}

TEST(Levels, NodesBeyondTheirDistanceAreNotEvaluated)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    level_at(world, 5);
    EXPECT_EQ(world.frame.stats().matrices_built, 10u);
    level_at(world, 30);
    EXPECT_EQ(world.frame.stats().matrices_built, 8u);
    level_at(world, 100);
    EXPECT_EQ(world.frame.stats().matrices_built, 1u);
}

TEST(Levels, FollowTheSizeInThePictureAtAllScales)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    uint32_t seen[3] = {0, 0, 0};
    for (float scale = 0.05f; scale <= 20; scale *= 1.13f)
        for (const float sign : {1.0f, -1.0f}) {
            set_scale(world, sign * scale);
            for (double distance = 2; distance < 300; distance *= 1.09) {
                const uint32_t level = level_of_size(world, scale, distance);
                ASSERT_EQ(level, level_by_pixels(scale, world.views[0]->camera.eye)) << scale << ' ' << distance;
                ++seen[level];
            }
        }
    for (const uint32_t count : seen) EXPECT_GT(count, 500u);
}

TEST(Levels, FollowTheScaleOfTheGroupToo)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    crowd::Transform place;
    place.scale = 0.1f;
    const crowd::Id group = crowd::create_group(world.crowd, place);
    for (const float own : {0.5f, 10.0f, 40.0f}) {
        place.scale = own;
        crowd::join(world.crowd, world.ids[0], group, &place);
        for (const auto &[distance, level] : {std::pair{18.0, 0u}, {21.0, 1u}, {58.0, 1u}, {62.0, 2u}})
            EXPECT_EQ(level_of_size(world, 0.1f * own, distance), level) << own << ' ' << distance;
    }
}

TEST(Levels, PriorityRaisesTheDetail)
{
    World world;
    const crowd::Id id = world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    EXPECT_EQ(level_at(world, 100), 2u);
    crowd::set_priority(world.crowd, id, 0.5f);
    EXPECT_EQ(level_at(world, 100), 1u);
    crowd::set_priority(world.crowd, id, 1);
    EXPECT_EQ(level_at(world, 1500), 0u);
}

TEST(Levels, AZoomLensAndALargerPictureGetMoreDetail)
{
    World world;
    world.add({0, 0, 0});
    frame::View &view = world.look({0, 1, 100}, {0, 1, 0}, 1.0471976f);
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 2u);
    view.camera = frame::look_at({0, 1, 100}, {0, 1, 0}, glm::vec3(0, 1, 0), 0.15f, 1.3f, 0.1f, 2000);
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 0u) << "a lens of 8.6 degrees shows it as from 13 m";
    view.camera = frame::look_at({0, 1, 100}, {0, 1, 0}, glm::vec3(0, 1, 0), 1.0471976f, 1.3f, 0.1f, 2000);
    view.height_px = 768 * 3;
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 1u) << "as from 33 m";
    view.height_px = 0;
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 2u);
}

TEST(Levels, AParallelProjectionChoosesBySizeAlone)
{
    World world;
    world.add({0, 0, 0});
    frame::View &view = world.look({0, 1, 500}, {0, 1, 0});
    // 16 m fill 768 lines: 48 pixels per metre, as at 13.9 m through the lens that the level distances assume.
    float parallel[16] = {0.1f, 0, 0, 0, 0, 0.125f, 0, 0, 0, 0, -0.002f, 0, 0, 0, -1, 1};
    std::copy(parallel, parallel + 16, view.camera.projection);
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 0u);
    view.camera.projection[5] = 0.02f;  // the picture is 100 m high
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 2u);
}

TEST(Levels, HysteresisHoldsTheCoarserLevelOnReturn)
{
    frame::Settings settings;
    settings.lod_hysteresis = 0.2f;
    World world(settings);
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    EXPECT_EQ(level_at(world, 19), 0u);
    EXPECT_EQ(level_at(world, 21), 1u);
    EXPECT_EQ(level_at(world, 19), 1u);
    EXPECT_EQ(level_at(world, 16.5), 1u);
    EXPECT_EQ(level_at(world, 15.5), 0u);
    EXPECT_EQ(level_at(world, 19), 0u);
}

TEST(Levels, HysteresisIsAShareOfTheWayAtAllScales)
{
    frame::Settings settings;
    settings.lod_hysteresis = 0.2f;
    for (const float scale : {0.05f, 0.7f, 6.0f, 20.0f}) {
        World world(settings);
        world.add({0, 0, 0});
        world.look({0, 1, 5}, {0, 1, 0});
        set_scale(world, scale);
        for (const auto &[distance, level] : {std::pair{19.0, 0u}, {21.0, 1u}, {16.5, 1u}, {15.5, 0u}, {19.0, 0u}})
            EXPECT_EQ(level_of_size(world, scale, distance), level) << scale << ' ' << distance;
    }
}

TEST(Levels, OfTheSmallestAndTheLargestActorsAreChosen)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 5}, {0, 1, 0});
    set_scale(world, 1e-30f);
    EXPECT_EQ(level_at(world, 500), 2u);
    set_scale(world, 1e6f);
    EXPECT_EQ(level_at(world, 500), 0u);
}

TEST(Levels, SeveralViewsGetTheDetailOfTheNearest)
{
    World world;
    world.add({0, 0, 0});
    world.look({0, 1, 200}, {0, 1, 0});
    world.look({0, 1, 30}, {0, 1, 0});
    world.update(0);
    EXPECT_EQ(world.seen(world.ids[0]).level, 1u);
    EXPECT_EQ(world.views[0]->list.items[0].level, 1u);
    EXPECT_NEAR(world.seen(world.ids[0]).distance, 30, 0.1);
}

TEST(Levels, ASwitchOfTheMeshAloneKeepsThePose)
{
    // Both levels share one skeleton: the robot without deactivated nodes.
    model::Model model = robot_model();
    model.rig.deactivation_m.clear();
    for (model::Part &part : model.parts) {
        if (part.name == "whole") part.lod_min_m = 30;
        else part.lod_max_m = 30, part.lod_min_m = 0;
    }
    model.parts.erase(std::remove_if(model.parts.begin(), model.parts.end(),
                                     [](const model::Part &p) { return p.name.find("and hand") != std::string::npos; }),
                      model.parts.end());
    World world;
    world.tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    meshsplit::build(model, meshsplit::BuildOptions(), *world.tmpl);
    ASSERT_EQ(world.tmpl->levels.size(), 2u);
    world.add({0, 0, 0});
    world.look({0, 1, 29}, {0, 1, 0});
    level_at(world, 29.9);
    EXPECT_EQ(world.frame.stats().animated, 1u);
    level_at(world, 30.1);
    EXPECT_EQ(world.frame.stats().animated, 0u) << "S1 4: after a switch of level the cached palette is skinned again";
    EXPECT_EQ(world.frame.stats().skinned, 1u);
}
