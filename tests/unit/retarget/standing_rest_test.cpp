// Characters whose files rest in the air or below the ground.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/retarget/retarget.h"
#include "rigs.h"

namespace claque::testing
{
namespace
{

retarget::Options as_sampled()
{
    retarget::Options options;
    options.mode = retarget::Mode::motion;
    options.travel = retarget::RootTravel::keep;
    options.rate_hz = 10;  // the rate of the source's keys
    return options;
}

}  // namespace

// Files rest in a jump, or round their hips.
TEST(StandingRest, PutsFeetOnTheGroundOfACharacterThatRestsAboveOrBelowIt)
{
    model::Rig source = rig_of(person(1, 0));
    add_motion(source, "stand", 12, 1, 0.03f);
    for (const float higher : {0.3f, -0.95f}) {
        std::vector<Bone> bones = person(1, 0);
        bones[0].offset.y += higher;
        model::Rig target = rig_of(bones);
        retarget::add_clips(target, source, as_sampled());
        double lowest = 1e9;
        for (uint32_t k = 0; k < 12; ++k)
            for (const char *foot : {"foot.l", "foot.r"})
                lowest = std::min(lowest, posed(target, 0, k).of(target, foot).y);
        EXPECT_NEAR(lowest, 0, 0.01) << higher;
    }
}

// Godot's mannequin rests in a jump, and its skin was bound as it stands.
TEST(StandingRest, OfACharacterSavedInAJumpIsThatOfItsSkin)
{
    model::Rig source = rig_of(person(1, 0));
    add_motion(source, "dance", 12, 1);
    const auto moved = [&](bool jumps) {
        model::Rig target = rig_of(person(1, 0));
        math::Affine global[15];
        for (uint32_t i = 0; i < target.node_count(); ++i) {
            const math::Affine local = math::affine_of(target.rest[i]);
            global[i] = target.parents[i] == model::none ? local : math::mul(global[target.parents[i]], local);
            target.palette.push_back({i, math::inverse(global[i])});
        }
        if (jumps) {
            target.rest[0].translation.y += 0.7f, target.rest[0].rotation = axis_turn({1, 0, 0}, 0.4f);
            for (const char *bent : {"knee.l", "knee.r", "arm.l"})
                target.rest[target.find_node(bent)].rotation = axis_turn({1, 0, 0}, 1);
        }
        retarget::add_clips(target, source, as_sampled());
        std::vector<glm::dvec3> places;
        for (uint32_t k = 0; k < 12; ++k)
            for (const glm::dvec3 &place : posed(target, 0, k).places) places.push_back(place);
        return places;
    };
    const std::vector<glm::dvec3> stands = moved(false), jumps = moved(true);
    ASSERT_EQ(stands.size(), jumps.size());
    for (size_t i = 0; i < stands.size(); ++i) EXPECT_LT(glm::distance(stands[i], jumps[i]), 1e-5) << i;
}

}  // namespace claque::testing
