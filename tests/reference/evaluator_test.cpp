// The reference itself, against answers worked out by hand.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/reference/asset_files.h"
#include "tests/reference/comparison.h"

namespace claque::reference
{
namespace
{

constexpr double pi = 3.14159265358979323846;

void expect_at(const Vec3 &expected, const Vec3 &actual, double slack = 1e-6)
{
    EXPECT_NEAR(expected.x, actual.x, slack);
    EXPECT_NEAR(expected.y, actual.y, slack);
    EXPECT_NEAR(expected.z, actual.z, slack);
}

Character real(const char *file) { return load_character(assets_folder() + "conformance/" + file); }

#define NEEDS_ASSETS() \
    if (assets_folder().empty()) GTEST_SKIP() << "no folder " << CLAQUE_ASSETS_DIR

TEST(ReferenceMatrices, ComposeScalesThenTurnsThenMoves)
{
    const Mat4 m = compose({10, 20, 30}, {0, 0, std::sqrt(0.5), std::sqrt(0.5)}, {2, 3, 4});
    expect_at({10 - 3, 20 + 2, 30 + 4}, transform_point(m, {1, 1, 1}));
}

TEST(ReferenceMatrices, NormalsStayAtRightAnglesToStretchedAndMirroredSurfaces)
{
    const Mat4 stretched = compose({5, 5, 5}, {}, {4, 1, 1});
    expect_at(normalized(Vec3{0.25, 1, 0}), transform_normal(stretched, normalized(Vec3{1, 1, 0})));
    expect_at({-1, 0, 0}, transform_normal(compose({}, {}, {-1, 1, 1}), {1, 0, 0}));
    expect_at({0, 0, 0}, transform_normal(compose({}, {}, {0, 1, 1}), {1, 0, 0}));
}

TEST(ReferenceMatrices, StretchIsTheRatioOfTheLongestToTheShortestAxis)
{
    const Quat turned = normalized(Quat{1, 2, 3, 4});
    EXPECT_NEAR(1, condition_number(compose({}, turned, {-7, 7, 7})), 1e-6);
    EXPECT_NEAR(4, condition_number(compose({}, turned, {2, 0.5, -1}) * compose({1, 2, 3}, turned, {1, 1, 1})), 1e-9);
    EXPECT_TRUE(std::isinf(condition_number(compose({}, turned, {1, 0, 1}))));
}

TEST(ReferenceMatrices, SlerpHasConstantSpeedAndTakesTheShorterArc)
{
    const auto turn = [](double angle) { return Quat{0, 0, std::sin(angle / 2), std::cos(angle / 2)}; };
    EXPECT_NEAR(std::sin(0.5), slerp(turn(0), turn(2), 0.5).z, 1e-12);
    EXPECT_NEAR(std::sin(0.1), slerp(turn(0), turn(2), 0.1).z, 1e-12);
    const Quat other{0, 0, -turn(2).z, -turn(2).w};
    EXPECT_NEAR(std::sin(0.1), slerp(turn(0), other, 0.1).z, 1e-12);
    EXPECT_NEAR(1e-11, slerp(turn(0), turn(1e-10), 0.2).z, 1e-15);  // hardly a turn at all
}

TEST(ReferenceSampling, SplinesUseTangentsTimesTheSpanOfTheirKeys)
{
    Channel channel;
    channel.interpolation = Interpolation::CubicSpline;
    channel.times = {1, 3};
    channel.width = 1;
    channel.values = {99, 0, 5, 7, 2, 99};  // arriving, value, leaving of both keys
    // At the middle: (0 + 2) / 2 + span * (leaving - arriving) / 8.
    EXPECT_NEAR(1 + 2 * (5 - 7) / 8.0, sample(channel, 2)[0], 1e-12);
    EXPECT_EQ(0, sample(channel, -5)[0]);
    EXPECT_EQ(2, sample(channel, 50)[0]);
}

TEST(ReferenceSampling, StepsHoldTheirKeyUntilTheNext)
{
    Channel channel;
    channel.interpolation = Interpolation::Step;
    channel.times = {0, 1, 2};
    channel.width = 1;
    channel.values = {10, 20, 30};
    EXPECT_EQ(10, sample(channel, 0.999)[0]);
    EXPECT_EQ(20, sample(channel, 1)[0]);
    EXPECT_EQ(30, sample(channel, 2)[0]);
}

TEST(ReferenceOnFiles, SimpleSkinBendsRoundItsSecondJoint)
{
    NEEDS_ASSETS();
    const Character skin = real("khronos/SimpleSkin-external/SimpleSkin.gltf");
    ASSERT_EQ(10u, skin.vertex_count());
    expect_at({-0.5, 2, 0}, evaluate(skin, rest, 0).positions[8]);
    // A quarter turn about (0, 1, 0): the free end falls to the left, the middle goes half the way.
    const Shape bent = evaluate(skin, 0, 1);
    expect_at({0.5, 0, 0}, bent.positions[1]);
    expect_at({0.25, 1.25, 0}, bent.positions[5]);
    expect_at({-1, 0.5, 0}, bent.positions[8]);
    // Half way to the key at 0.5 s, whose quaternion (0, 0, 0.383, 0.924) is not quite of unit length.
    const double angle = std::atan2(0.383, 0.924);
    const double c = std::cos(angle), s = std::sin(angle);
    expect_at({-0.5 * c - s, 1 - 0.5 * s + c, 0}, evaluate(skin, 0, 0.25).positions[8], 1e-6);
}

TEST(ReferenceOnFiles, SimpleMorphMovesItsTipByWeights)
{
    NEEDS_ASSETS();
    const Character morph = real("khronos/SimpleMorph-Embedded/SimpleMorph.gltf");
    expect_at({0.5, 1.5, 0}, evaluate(morph, rest, 0).positions[2]);
    expect_at({0.5, 0.5, 0}, evaluate(morph, 0, -1).positions[2]);
    expect_at({1, 1, 0}, evaluate(morph, 0, 0.5).positions[2]);
    expect_at({0.5, 2.5, 0}, evaluate(morph, 0, 2).positions[2]);
    expect_at({1, 0, 0}, evaluate(morph, 0, 2).positions[1]);
}

TEST(ReferenceOnFiles, AnimationNode04MovesOnASpline)
{
    NEEDS_ASSETS();
    const Character cube = real("asset-generator/Animation_Node/Animation_Node_04.gltf");
    ASSERT_EQ(24u, cube.vertex_count());
    // Tangents are zero, from -0.1 to 0.1 and back: at a quarter (3/16 - 2/64) of the way.
    expect_at({-0.3 - 0.1 + 0.2 * 0.15625, -0.3, -0.3}, evaluate(cube, 0, 0.25).positions[0]);
    expect_at({-0.3, -0.3, -0.3}, evaluate(cube, 0, 1.5).positions[0]);
}

TEST(ReferenceOnFiles, InterpolationTestShowsEveryKind)
{
    NEEDS_ASSETS();
    const Character test = real("khronos/InterpolationTest.glb");
    const auto channel = [&](size_t clip) -> const Channel & { return test.clips.at(clip).channels.at(0); };
    ASSERT_EQ("Linear Translation", test.clips.at(8).name);
    EXPECT_NEAR(8, sample(channel(8), 0.625)[1], 1e-6);
    ASSERT_EQ("CubicSpline Translation", test.clips.at(7).name);
    EXPECT_NEAR(9.375, sample(channel(7), 0.5208333333)[1], 1e-6);
    ASSERT_EQ("Step Rotation", test.clips.at(3).name);
    EXPECT_NEAR(-std::sqrt(0.5), sample(channel(3), 1.2)[2], 1e-6);
    ASSERT_EQ("Linear Rotation", test.clips.at(5).name);
    EXPECT_NEAR(-std::sin(pi / 16), sample(channel(5), 0.20833333)[2], 1e-6);
    ASSERT_EQ("Step Scale", test.clips.at(0).name);
    EXPECT_EQ(0.5, sample(channel(0), 0.87)[0]);
}

TEST(ReferenceOnFiles, RestPosesHaveTheSizesThatTheInventoryGives)
{
    NEEDS_ASSETS();
    // Extents after skinning and all node transforms, without morph targets, rounded to a hundredth by whoever measured
    // them.
    std::ifstream inventory(assets_folder() + "inventory.json");
    size_t held = 0;
    for (const auto &entry : nlohmann::json::parse(inventory)) {
        const std::string file = entry.at("file");
        const auto size = entry.value("rest_size_xyz", nlohmann::json());
        if (!size.is_array() || file.rfind("hostile/", 0) == 0 || refusal_of(file)) continue;
        Character character = load_character(assets_folder() + file);
        for (Node &node : character.nodes) node.morph_weights.clear();
        const Shape shape = evaluate(character, rest, 0);
        if (shape.positions.empty()) continue;
        const Vec3 extent = extent_of(shape.positions);
        SCOPED_TRACE(file);
        expect_at({size.at(0), size.at(1), size.at(2)}, extent, 0.0051);
        ++held;
    }
    EXPECT_GT(held, 70u);
}

}  // namespace
}  // namespace claque::reference
