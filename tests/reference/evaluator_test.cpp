// The reference itself, against answers worked out by hand.
#include <fstream>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/reference/asset_files.h"
#include "tests/reference/comparison.h"
#include "tests/support/written_characters.h"

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
    // Extents after skinning and all node transforms, without morph targets, rounded to a hundredth.
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

// Answers below are worked out from what tests/support writes.

Character written_file(const char *file) { return load_character(written::folder() + file); }

// Vertices of the parts on these nodes, in the order of the file.
std::vector<Vec3> positions_on(const Character &character, const std::set<std::string> &nodes, size_t clip,
                               double time_s)
{
    const std::vector<Vec3> all = evaluate(character, clip, time_s).positions;
    std::vector<Vec3> out;
    auto first = all.begin();
    for (const Part &part : character.parts) {
        const auto end = first + static_cast<std::ptrdiff_t>(part.positions.size());
        if (nodes.count(character.nodes[part.node].name) != 0) out.insert(out.end(), first, end);
        first = end;
    }
    return out;
}

const Channel &channel_of(const Character &character, const char *clip, const char *node)
{
    for (const Clip &one : character.clips)
        for (const Channel &channel : one.channels)
            if (one.name == clip && character.nodes[channel.node].name == node) return channel;
    throw std::runtime_error(std::string("no channel of ") + clip + " on " + node);
}

TEST(ReferenceOnWrittenFiles, AFrameTurnsAboutASlantingAxisAfterItsScale)
{
    const Character lines = written_file("WrittenLines.gltf");
    ASSERT_EQ(12u, lines.vertex_count());
    expect_at({0, 2, 0.5}, evaluate(lines, rest, 0).positions[3]);
    expect_at({1, 2, 0.5}, extent_of(evaluate(lines, rest, 0).positions));
    // (1, 0, 0) about (0, 1, 1): cos, sin / sqrt 2, -sin / sqrt 2.
    const double s = std::sqrt(0.5);
    expect_at({s, 0.5, -0.5}, evaluate(lines, 0, 0.5).positions[1]);
    expect_at({0, s, -s}, evaluate(lines, 0, 1).positions[1]);
}

TEST(ReferenceOnWrittenFiles, AFlattenedFlagBelowAMirroringMatrixLiesWhereItsMatricesPutIt)
{
    const Character odd = written_file("WrittenOdd.gltf");
    expect_at({1.4, 0.1, -1.2}, positions_on(odd, {"mirror"}, rest, 0)[0]);
    expect_at({1.85, -0.8, 0.15}, positions_on(odd, {"flat"}, rest, 0)[0]);
}

TEST(ReferenceOnWrittenFiles, HeadsMoveByWeightsOfMeshNodeAndClip)
{
    const Character morph = written_file("WrittenMorph.gltf");
    const auto right = [&](size_t clip, double time_s) { return positions_on(morph, {"right head"}, clip, time_s); };
    // The tips: the first moves by (., -0.12, 0.024) for the first weight, the last by (., 0.1, -0.02) for the second.
    const size_t last = right(rest, 0).size() - 1;
    EXPECT_NEAR(-0.2 * -0.12 * 1.2, right(rest, 0)[0].y, 1e-6);
    EXPECT_NEAR(-0.2 * 0.024 + 0.1, right(rest, 0)[0].z, 1e-6);
    EXPECT_NEAR((0.6 + 0.8 * 0.1) * 1.2, right(rest, 0)[last].y, 1e-6);
    EXPECT_NEAR(0.8 * -0.02 + 0.1, right(rest, 0)[last].z, 1e-6);
    ASSERT_EQ("gasp", morph.clips.at(1).name);
    EXPECT_NEAR(0.5 * -0.12 * 1.2, right(1, 1)[0].y, 1e-6);
    EXPECT_NEAR(0.7 * -0.12 * 1.2, right(0, 0.6)[0].y, 1e-6);  // a key of the spline
}

TEST(ReferenceOnWrittenFiles, ANeckBendsRoundItsUpperJoint)
{
    const Character morph = written_file("WrittenMorph.gltf");
    const std::vector<Vec3> neck = positions_on(morph, {"neck"}, rest, 0);
    expect_at({0, -0.6, 0}, neck[0]);
    const double c = std::cos(8 * pi / 180), s = std::sin(8 * pi / 180);
    expect_at({-0.3 * s, -0.35 + 0.3 * c, 0}, neck.back());
    // (0.1, -0.2, 0) with 0.2 of the lower joint, which stands as it was bound, and 0.8 of the upper one.
    expect_at({0.2 * 0.1 + 0.8 * (0.1 * c - 0.15 * s), 0.2 * -0.2 + 0.8 * (0.1 * s + 0.15 * c - 0.35), 0}, neck[24]);
}

TEST(ReferenceOnWrittenFiles, APersonsClipsShowEveryKindOfInterpolation)
{
    const Character person = written_file("WrittenPerson.glb");
    const double ten_degrees = pi / 18;
    EXPECT_NEAR(std::sin(ten_degrees / 2), sample(channel_of(person, "walk", "leg.l"), 0.3125)[0], 1e-6);
    EXPECT_NEAR(0.01, sample(channel_of(person, "walk", "hips"), 0.375)[0], 1e-6);
    EXPECT_NEAR(0.96, sample(channel_of(person, "walk", "hips"), 0.375)[1], 1e-6);
    const Channel &nod = channel_of(person, "wave", "head");
    EXPECT_NEAR(std::sin(ten_degrees), sample(nod, 0.599)[1], 1e-6);
    EXPECT_NEAR(-std::sin(ten_degrees), sample(nod, 0.601)[1], 1e-6);
    // Half way from 0.95 to 0.9 in 0.7 s: leaving with 1.5 * 0.5 times their difference, arriving with none.
    EXPECT_NEAR(0.925 + 0.7 * (0.75 * -0.05) / 8, sample(channel_of(person, "wave", "hips"), 0.35)[1], 1e-6);
}

TEST(ReferenceOnWrittenFiles, APersonStoredInOtherWaysIsThePersonAtRest)
{
    const Character person = written_file("WrittenPerson.glb");
    const std::vector<Vec3> expected = positions_on(person, {"body"}, rest, 0);
    ASSERT_EQ(387u, expected.size());
    for (const char *file : {"WrittenSkins.glb", "WrittenQuantised.glb"}) {
        SCOPED_TRACE(file);
        const std::vector<Vec3> actual = positions_on(written_file(file), {"body", "above", "below"}, rest, 0);
        ASSERT_EQ(expected.size(), actual.size());
        for (size_t v = 0; v < actual.size(); ++v) expect_at(expected[v], actual[v], 1e-4);
    }
}

}  // namespace
}  // namespace claque::reference
