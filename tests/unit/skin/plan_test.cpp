// Grouping a level's vertices for skinning; no grouping changes a bit.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "lib/skin/skin.h"
#include "tests/unit/skin/packed_support.h"

namespace claque::skin
{

namespace
{

using model::SkinMethod;

struct PlanMade {
    std::vector<uint16_t> joints;
    std::vector<float> weights;
};

// One run; `made` gives the lists of joints and weights vertex by vertex.
model::Level level_of(uint32_t influences, const std::vector<PlanMade> &made, uint32_t copies = 0)
{
    std::mt19937 random(uint32_t(5 + made.size()));
    std::uniform_real_distribution<float> real(-1, 1);
    model::Level level(std::pmr::get_default_resource());
    level.source_count = uint32_t(made.size());
    level.vertex_count = level.source_count + copies;
    for (uint32_t i = 0; i < copies; ++i) level.copies.push_back(i);
    level.runs.push_back({0, level.source_count, influences, 0});
    for (const PlanMade &vertex : made) {
        level.joints.insert(level.joints.end(), vertex.joints.begin(), vertex.joints.end());
        level.weights.insert(level.weights.end(), vertex.weights.begin(), vertex.weights.end());
        for (int k = 0; k < 3; ++k) level.positions.push_back(real(random)), level.normals.push_back(real(random));
    }
    return level;
}

// `groups`: how many vertices follow each list of joints, one after another; the first two are swapped now and then.
std::vector<PlanMade> grouped(const std::vector<uint32_t> &groups, uint32_t influences, uint32_t weights_of_each)
{
    std::mt19937 random(3);
    std::vector<PlanMade> out;
    for (uint32_t g = 0; g < groups.size(); ++g)
        for (uint32_t i = 0; i < groups[g]; ++i) {
            PlanMade vertex;
            for (uint32_t k = 0; k < influences; ++k) {
                vertex.joints.push_back(uint16_t((g + 2 * k) % 16));
                vertex.weights.push_back(0.1f * float(1 + (i % weights_of_each + k) % 9));
            }
            if (influences > 1 && weights_of_each > 1 && random() % 3 == 0)
                std::swap(vertex.joints[0], vertex.joints[1]);
            out.push_back(vertex);
        }
    return out;
}

struct PlanResult {
    std::vector<float> positions, normals;
};

PlanResult run(const model::Level &level, Normals normals, SimdLevel simd_level)
{
    std::vector<math::Affine> palette(17);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> real(-1, 1);
    for (math::Affine &a : palette)
        for (float &c : a.c) c = real(random);
    const size_t floats = 3 * size_t(level.vertex_count);
    PlanResult out{std::vector<float>(floats + 8, -77.0f), std::vector<float>(floats + 8, -77.0f)};
    std::vector<float> scratch(scratch_floats(level, 16, normals));
    SkinJob job;
    job.level = &level;
    job.palette = {palette.data(), 16};
    job.normals = normals;
    job.simd_level = simd_level;
    job.scratch = base::Span<float>(scratch);
    job.out_positions = {out.positions.data(), uint32_t(floats)};
    job.out_normals = {out.normals.data(), uint32_t(floats)};
    EXPECT_TRUE(job.check().ok()) << job.check().text;
    job.run();
    for (size_t i = floats; i < floats + 8; ++i) {  // nothing behind the last vertex changes
        EXPECT_EQ(out.positions[i], -77.0f);
        EXPECT_EQ(out.normals[i], -77.0f);
    }
    expect_packed_as_afterwards(job);
    return out;
}

void expect_same(const PlanResult &a, const PlanResult &b)
{
    EXPECT_EQ(std::memcmp(a.positions.data(), b.positions.data(), 4 * a.positions.size()), 0);
    EXPECT_EQ(std::memcmp(a.normals.data(), b.normals.data(), 4 * a.normals.size()), 0);
}

// With and without a plan, with every kernel.
void expect_no_bit_changed(model::Level level)
{
    for (const Normals how : {Normals::by_palette, Normals::by_own_matrices}) {
        level.skinning.segments.clear();
        const PlanResult plain = run(level, how, SimdLevel::scalar);
        model::plan_skinning(level);
        for (const SimdLevel simd_level : {SimdLevel::scalar, SimdLevel::simd128, SimdLevel::simd256})
            expect_same(plain, run(level, how, simd_level));
    }
}

void expect_covered(const model::Level &level)
{
    uint32_t next = 0;
    for (const model::SkinSegment &segment : level.skinning.segments) {
        EXPECT_EQ(segment.first, next);
        EXPECT_GT(segment.count, 0u);
        next += segment.count;
    }
    EXPECT_EQ(next, level.source_count);
}

}  // namespace

TEST(SkinPlan, PutsVerticesOfTheSameEntriesIntoBlocksAndFewSingly)
{
    model::Level level = level_of(2, grouped({20, 3, 8, 5}, 2, 9));
    model::plan_skinning(level);
    expect_covered(level);
    const auto &segments = level.skinning.segments;
    ASSERT_EQ(segments.size(), 3u);
    EXPECT_EQ(segments[0].method, SkinMethod::block);  // 16 of the 20; four are too few for a block
    EXPECT_EQ(segments[0].count, 16u);
    EXPECT_EQ(segments[1].method, SkinMethod::vertex);
    EXPECT_EQ(segments[1].count, 4u + 3u);
    EXPECT_EQ(segments[2].method, SkinMethod::block);
    EXPECT_EQ(segments[2].item_count, 2u);  // 8 and 5 lanes
    EXPECT_EQ(segments[2].count, 13u);
}

TEST(SkinPlan, BlendsOnceForVerticesThatShareJointsAndWeights)
{
    std::vector<PlanMade> made;
    for (uint32_t v = 0; v < 400; ++v) {
        const uint16_t j = uint16_t(v / 4 % 13);
        made.push_back({{j, uint16_t(j + 1), uint16_t(15 - j % 3)}, {0.5f, 0.25f, 0.25f - 1e-4f * float(v / 52)}});
    }
    model::Level level = level_of(3, made);
    model::plan_skinning(level);
    expect_covered(level);
    uint32_t by_sets = 0;
    for (const model::SkinSegment &segment : level.skinning.segments) {
        if (segment.method != SkinMethod::set) continue;
        by_sets += segment.count;
        EXPECT_LE(segment.item_count, model::max_chunk_sets);
        EXPECT_LE(2 * segment.item_count, segment.count);
    }
    EXPECT_EQ(by_sets, 400u);
    expect_no_bit_changed(level);
}

TEST(SkinPlan, TreatsListsWithSwappedFirstEntriesAsEqual)
{
    const uint16_t a[4] = {1, 2, 3, 4}, b[4] = {2, 1, 3, 4}, c[4] = {1, 3, 2, 4};
    EXPECT_TRUE(model::same_entries(a, b, 2));
    EXPECT_TRUE(model::same_entries(a, b, 4));
    EXPECT_FALSE(model::same_entries(a, b, 1));
    EXPECT_FALSE(model::same_entries(a, c, 3));  // a sum of three in another order has other bits
}

TEST(SkinPlan, ChangesNoBitWhateverTheGroups)
{
    std::mt19937 random(11);
    for (uint32_t influences = 1; influences <= 6; ++influences)
        for (uint32_t round = 0; round < 12; ++round) {
            std::vector<uint32_t> groups;
            for (uint32_t g = 0; g < 9; ++g) groups.push_back(1 + uint32_t(random() % 21));
            expect_no_bit_changed(level_of(influences, grouped(groups, influences, round % 3 == 0 ? 1 : 8), round % 4));
        }
}

// What the processor says, whatever the library makes of it.
bool has_fma()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

// The promise of clq_simd for CLQ_SIMD_FMA: the other kernels' numbers up to a few units in the last place of the
// largest term.
TEST(SkinPlan, WithFusedMultiplyAddDiffersByAFewUnitsOfTheLastPlace)
{
    if (!has_fma()) GTEST_SKIP() << "this processor has no fused multiply-add";
    ASSERT_TRUE(can_run(SimdLevel::fma));
    float most = 0;
    for (const Normals how : {Normals::by_palette, Normals::by_own_matrices})
        for (uint32_t influences = 1; influences <= 4; ++influences) {
            model::Level level = level_of(influences, grouped({24, 40, 16}, influences, 9), 3);
            model::plan_skinning(level);
            const PlanResult a = run(level, how, SimdLevel::simd256), b = run(level, how, SimdLevel::fma);
            for (size_t i = 0; i < a.positions.size(); ++i) {
                most = std::max(most, std::fabs(a.positions[i] - b.positions[i]));
                most = std::max(most, std::fabs(a.normals[i] - b.normals[i]));
            }
        }
    EXPECT_GT(most, 0);      // otherwise it did not use FMA
    EXPECT_LT(most, 2e-6f);  // sums of up to 16 products of numbers below 1
}

TEST(SkinPlan, WritesNothingBehindALastBlockThatIsNotFull)
{
    for (uint32_t count = 1; count < 18; ++count) expect_no_bit_changed(level_of(2, grouped({count}, 2, 9)));
}

}  // namespace claque::skin
