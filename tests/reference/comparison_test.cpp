// The comparison is worth something only if it fails: a collected and a written character are damaged in the ways that
// loaders and skinning go wrong, and each time it has to notice.
#include "tests/reference/comparison.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/reference/asset_files.h"
#include "tests/support/written_characters.h"

namespace claque::reference
{
namespace
{

std::vector<float> floats(const std::vector<Vec3> &positions)
{
    std::vector<float> result;
    for (const Vec3 &p : positions)
        for (const double number : {p.x, p.y, p.z}) result.push_back(static_cast<float>(number));
    return result;
}

struct WalkingCharacter {
    const char *file, *clip;
    double time_s;
};

class ComparisonOnACharacter : public testing::TestWithParam<WalkingCharacter>
{
protected:
    void SetUp() override
    {
        const std::string file = GetParam().file;
        if (!written::is_written(file) && assets_folder().empty()) GTEST_SKIP() << "no folder " << CLAQUE_ASSETS_DIR;
        character_ = load_character(written::path_of(file, assets_folder()));
        time_s_ = GetParam().time_s;
        for (size_t i = 0; i < character_.clips.size(); ++i)
            if (character_.clips[i].name == GetParam().clip) walk_ = i;
        ASSERT_NE(rest, walk_);
        expected_ = evaluate(character_, walk_, time_s_).positions;
        size_ = size_of(character_);
    }

    Comparison against(const Character &damaged) const
    {
        return compare(expected_, floats(evaluate(damaged, walk_, time_s_).positions), size_);
    }

    Character character_;
    size_t walk_ = rest;
    double time_s_ = 0;
    std::vector<Vec3> expected_;
    double size_ = 0;
};

TEST_P(ComparisonOnACharacter, TheSameIsTheSame)
{
    EXPECT_TRUE(against(character_).same) << against(character_).text;
    EXPECT_LT(against(character_).worst, 1e-6);
}

TEST_P(ComparisonOnACharacter, ADroppedWeightIsNoticed)
{
    // The first vertex with two real influences loses one, and the rest is not made up for.
    Character damaged = character_;
    for (Part &part : damaged.parts)
        for (size_t i = 0; i + 1 < part.weights.size(); i += part.influences)
            if (part.weights[i] > 0.2 && part.weights[i + 1] > 0.2) {
                part.weights[i + 1] = 0;
                EXPECT_FALSE(against(damaged).same);
                return;
            }
    FAIL() << "no vertex has two influences";
}

TEST_P(ComparisonOnACharacter, ANearlyRightWeightOfOneVertexIsNoticed)
{
    Character damaged = character_;
    for (Part &part : damaged.parts)
        for (size_t i = 0; i + 1 < part.weights.size(); i += part.influences)
            if (part.weights[i] > 0.2 && part.weights[i + 1] > 0.2 && part.joints[i] != part.joints[i + 1]) {
                part.weights[i] -= 0.05;
                part.weights[i + 1] += 0.05;
            }
    EXPECT_FALSE(against(damaged).same);
}

TEST_P(ComparisonOnACharacter, APoseOneKeyLateIsNoticed)
{
    Character damaged = character_;
    for (Channel &channel : damaged.clips[walk_].channels) {
        const double step = channel.times.size() > 1 ? channel.times[1] - channel.times[0] : 0;
        for (double &time : channel.times) time += step;
    }
    EXPECT_FALSE(against(damaged).same);
}

TEST_P(ComparisonOnACharacter, AMissingNodeTransformIsNoticed)
{
    size_t missed = 0, tried = 0;
    for (const Part &part : character_.parts) {
        if (part.skin >= 0) continue;
        const Node &node = character_.nodes[part.node];
        if (length(node.translation) < 0.01) continue;
        Character damaged = character_;
        damaged.nodes[part.node].translation = {};
        ++tried;
        missed += against(damaged).same ? 1 : 0;
    }
    EXPECT_GT(tried, 0u) << "no rigid part has a transform of its own";
    EXPECT_EQ(0u, missed);
}

TEST_P(ComparisonOnACharacter, TheLongerArcIsNoticed)
{
    // Interpolating numbers without turning the second key round, where keys cross the double cover.
    Channel *crossing = nullptr;
    size_t key = 0;
    Character damaged = character_;
    for (size_t clip = 0; clip < damaged.clips.size() && !crossing; ++clip)
        for (Channel &channel : damaged.clips[clip].channels) {
            if (channel.path != Path::Rotation) continue;
            for (size_t k = 0; k + 1 < channel.times.size() && !crossing; ++k) {
                double product = 0;
                for (size_t i = 0; i < 4; ++i) product += channel.values[4 * k + i] * channel.values[4 * k + 4 + i];
                if (product < -0.9) crossing = &channel, key = k, walk_ = clip;
            }
            if (crossing) break;
        }
    ASSERT_NE(nullptr, crossing) << "the file is known to have such keys";
    time_s_ = (crossing->times[key] + crossing->times[key + 1]) / 2;
    expected_ = evaluate(character_, walk_, time_s_).positions;
    const std::vector<double> wrong = [&] {
        std::vector<double> sum(4);
        for (size_t i = 0; i < 4; ++i) sum[i] = crossing->values[4 * key + i] + crossing->values[4 * key + 4 + i];
        return sum;
    }();
    crossing->interpolation = Interpolation::Step;
    for (size_t i = 0; i < 4; ++i) crossing->values[4 * key + i] = wrong[i];
    EXPECT_FALSE(against(damaged).same);
}

INSTANTIATE_TEST_SUITE_P(Of, ComparisonOnACharacter,
                         testing::Values(WalkingCharacter{"humanoids/kaykit/Barbarian.glb", "Walking_A", 0.4},
                                         WalkingCharacter{"WrittenPerson.glb", "walk", 0.6}),
                         [](const auto &shown) {
                             return written::is_written(shown.param.file) ? "WrittenPerson" : "Barbarian";
                         });

TEST(Comparison, OneVertexAtTheEdgeOfTheToleranceDecides)
{
    const std::vector<Vec3> expected{{0, 0, 0}, {1, 2, 3}};
    EXPECT_TRUE(compare(expected, {0, 0, 0, 1, 2, 3.0009f}, 10).same);
    const Comparison off = compare(expected, {0, 0, 0, 1, 2, 3.0011f}, 10);
    EXPECT_FALSE(off.same);
    EXPECT_EQ(1u, off.vertex);
    EXPECT_NE(std::string::npos, off.text.find("vertex 1")) << off.text;
}

TEST(Comparison, WhatIsNotANumberAndWhatIsMissingDiffer)
{
    const std::vector<Vec3> expected{{0, 0, 0}, {1, 2, 3}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(compare(expected, {0, nan, 0, 1, 2, 3}, 10).same);
    EXPECT_FALSE(compare(expected, {0, 0, 0}, 10).same);
    EXPECT_FALSE(compare(expected, {0, 0, 0, 1, 2, 3, 0}, 10).same);
}

}  // namespace
}  // namespace claque::reference
