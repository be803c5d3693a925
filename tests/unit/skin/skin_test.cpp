// Skinning, compared with the textbook's sum in double and between kernels.
#include "lib/skin/skin.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "lib/pose/pose.h"
#include "tests/law/support/figure.h"
#include "tests/unit/skin/packed_support.h"

namespace claque::skin
{

using namespace testing_support;

namespace
{

struct Result {
    std::vector<float> positions, normals;
};

Result run(const model::Level &level, base::Span<const math::Affine> palette, base::Span<const float> weights,
           Normals normals, SimdLevel simd_level)
{
    SkinJob job;
    job.level = &level;
    job.palette = palette;
    job.morph_weights = weights;
    job.normals = normals;
    job.simd_level = simd_level;
    std::vector<float> scratch(scratch_floats(level, palette.count, normals));
    Result out{std::vector<float>(3 * level.vertex_count + 1, -77.0f),
               std::vector<float>(3 * level.vertex_count + 1, -77.0f)};
    job.scratch = base::Span<float>(scratch);
    job.out_positions = {out.positions.data(), 3 * level.vertex_count};
    job.out_normals = {out.normals.data(), 3 * level.vertex_count};
    EXPECT_TRUE(job.check().ok()) << job.check().text;
    job.run();
    EXPECT_EQ(out.positions.back(), -77.0f);  // nothing behind the last vertex changes
    EXPECT_EQ(out.normals.back(), -77.0f);
    expect_packed_as_afterwards(job);
    return out;
}

// The textbook's sum over influences of weight * matrix * vertex, in double.
void reference(const model::Level &level, base::Span<const math::Affine> palette, base::Span<const float> morphs,
               Normals how, std::vector<double> &positions, std::vector<double> &normals)
{
    std::vector<double> p(level.positions.begin(), level.positions.end()),
        n(level.normals.begin(), level.normals.end());
    for (const model::MorphRange &range : level.morph_ranges)
        for (uint32_t i = range.first; i < range.first + range.count; ++i)
            for (int k = 0; k < 3; ++k) {
                p[3 * level.morph_deltas[i].vertex + k] +=
                    double(morphs[range.weight]) * level.morph_deltas[i].position[k];
                n[3 * level.morph_deltas[i].vertex + k] +=
                    double(morphs[range.weight]) * level.morph_deltas[i].normal[k];
            }
    positions.assign(3 * level.vertex_count, 0);
    normals.assign(3 * level.vertex_count, 0);
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = run.first; v < run.first + run.count; ++v)
            for (uint32_t i = 0; i < run.influences; ++i) {
                const uint32_t at = run.first_influence + (v - run.first) * run.influences + i;
                const math::Affine &m = palette[level.joints[at]];
                const math::Affine nm = how == Normals::by_palette ? m : math::normal_matrix(m);
                for (int r = 0; r < 3; ++r) {
                    positions[3 * v + r] += level.weights[at] * (m.c[r] * p[3 * v] + m.c[3 + r] * p[3 * v + 1] +
                                                                 m.c[6 + r] * p[3 * v + 2] + double(m.c[9 + r]));
                    normals[3 * v + r] += level.weights[at] * (nm.c[r] * n[3 * v] + nm.c[3 + r] * n[3 * v + 1] +
                                                               double(nm.c[6 + r]) * n[3 * v + 2]);
                }
            }
    for (uint32_t i = 0; i < level.copies.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            positions[3 * (level.source_count + i) + k] = positions[3 * level.copies[i] + k];
            normals[3 * (level.source_count + i) + k] = normals[3 * level.copies[i] + k];
        }
}

class Skin : public ::testing::TestWithParam<Shape>
{
protected:
    Skin()
    {
        FigureDef def;
        def.shape = GetParam();
        figure_ = make_figure(def);
        workspace_ = std::make_unique<pose::Workspace>(figure_->rig);
        how_ = normals_of(*figure_);
    }
    std::unique_ptr<model::Template> figure_;
    std::unique_ptr<pose::Workspace> workspace_;
    Normals how_;
};

INSTANTIATE_TEST_SUITE_P(Shapes, Skin, ::testing::Values(Shape::similar, Shape::sheared));

}  // namespace

TEST_P(Skin, AgreesWithTheTextbookSumInDouble)
{
    for (const model::Level &level : figure_->levels) {
        const auto palette = workspace_->pose(clip_walk, 0.4);
        ASSERT_NE(workspace_->weights()[0], 0);  // morph targets are active
        const Result got = run(level, palette, workspace_->weights(), how_, SimdLevel::simd128);
        std::vector<double> positions, normals;
        reference(level, palette, workspace_->weights(), how_, positions, normals);
        for (size_t i = 0; i < positions.size(); ++i) {
            ASSERT_NEAR(got.positions[i], positions[i], 3e-6) << i;
            ASSERT_NEAR(got.normals[i], normals[i], 2e-6) << i;
        }
    }
}

TEST_P(Skin, AllKernelsGiveTheSameBits)
{
    if (!can_run(SimdLevel::simd256)) GTEST_LOG_(INFO) << "this processor has no AVX2: the wide kernel is not run";
    for (int i = 0; i < 50; ++i) {
        const auto palette = workspace_->pose(uint32_t(i) % 4, i * 0.021);
        for (const model::Level &level : figure_->levels) {
            const Result a = run(level, palette, workspace_->weights(), how_, SimdLevel::scalar);
            for (const SimdLevel simd_level : {SimdLevel::simd128, SimdLevel::simd256}) {
                const Result b = run(level, palette, workspace_->weights(), how_, simd_level);
                ASSERT_EQ(std::memcmp(a.positions.data(), b.positions.data(), 4 * a.positions.size()), 0);
                ASSERT_EQ(std::memcmp(a.normals.data(), b.normals.data(), 4 * a.normals.size()), 0);
            }
        }
    }
}

// Every length of a run, so that the last vertices of the wide kernel occur alone and in pairs.
TEST(SkinRuns, OfAnyLengthAndNumberOfInfluencesAreTheSameInAllKernels)
{
    std::vector<math::Affine> palette(9);
    uint32_t n = 0;
    for (math::Affine &a : palette)
        for (float &x : a.c) x = float(std::sin(double(++n)));
    for (const Normals how : {Normals::by_palette, Normals::by_own_matrices})
        for (uint32_t influences = 1; influences <= 6; ++influences)
            for (uint32_t count = 0; count < 9; ++count) {
                model::Level level(std::pmr::get_default_resource());
                level.source_count = level.vertex_count = count;
                level.runs.push_back({0, count, influences, 0});
                for (uint32_t i = 0; i < 3 * count; ++i) {
                    level.positions.push_back(float(std::sin(0.7 * double(++n))));
                    level.normals.push_back(float(std::cos(0.3 * double(++n))));
                }
                for (uint32_t i = 0; i < influences * count; ++i) {
                    level.joints.push_back(uint16_t(++n * 5 % 8));
                    level.weights.push_back(1.0f / float(influences + i % 3));
                }
                const Result a = run(level, {palette.data(), 8}, {}, how, SimdLevel::scalar);
                for (const SimdLevel simd_level : {SimdLevel::simd128, SimdLevel::simd256}) {
                    const Result b = run(level, {palette.data(), 8}, {}, how, simd_level);
                    ASSERT_EQ(std::memcmp(a.positions.data(), b.positions.data(), 4 * a.positions.size()), 0);
                    ASSERT_EQ(std::memcmp(a.normals.data(), b.normals.data(), 4 * a.normals.size()), 0);
                }
            }
}

TEST_P(Skin, MorphTargetsOfNoWeightCostNothingAndShowNothing)
{
    const auto palette = workspace_->pose(model::none, 0);
    const model::Level &level = figure_->levels[0];
    const float zero[2] = {0, 0};
    const Result a = run(level, palette, {zero, 2}, how_, SimdLevel::simd128),
                 b = run(level, palette, {}, how_, SimdLevel::simd128);
    EXPECT_EQ(a.positions, b.positions);
    const float one[2] = {0, 1};
    EXPECT_NE(a.positions, run(level, palette, {one, 2}, how_, SimdLevel::simd128).positions);
}

TEST(SkinNormals, StayUprightOnASlopeThatIsStretched)
{
    // A 45 degree slope stretched twofold along x: its normal leans towards y.
    math::Affine stretch;
    stretch.c[0] = 2;
    const math::Affine palette[2] = {stretch, stretch};
    model::Level level(std::pmr::get_default_resource());
    level.source_count = level.vertex_count = 1;
    level.positions = {1, -1, 0};
    level.normals = {0.70710678f, 0.70710678f, 0};
    level.runs.push_back({0, 1, 1, 0});
    level.joints = {0};
    level.weights = {1};
    const Result got = run(level, {palette, 1}, {}, Normals::by_own_matrices, SimdLevel::simd128);
    EXPECT_NEAR(got.normals[1] / got.normals[0], 2, 1e-6);
    EXPECT_EQ(got.positions[0], 2);
}

TEST(SkinJob, NamesTheFirstBrokenRule)
{
    SkinJob job;
    EXPECT_STREQ(job.check().text, "a skin job has no level");
    const auto figure = make_figure();
    job.level = &figure->levels[0];
    EXPECT_NE(std::string(job.check().text).find("room for 0 and 0"), std::string::npos);
    std::vector<float> out(3 * figure->levels[0].vertex_count);
    job.out_positions = base::Span<float>(out);
    job.out_normals = base::Span<float>(out);
    EXPECT_NE(std::string(job.check().text).find("of scratch"), std::string::npos);
    PackedPosition positions[2];
    job.out_packed_positions = {positions, 2};
    EXPECT_NE(std::string(job.check().text).find("room for 2 and 0 of"), std::string::npos);
    std::vector<PackedPosition> enough(job.level->vertex_count);
    std::vector<PackedNormal> normals(job.level->vertex_count);
    job.out_packed_positions = base::Span<PackedPosition>(enough);
    job.out_packed_normals = base::Span<PackedNormal>(normals);
    job.range.step = 0;
    EXPECT_STREQ(job.check().text, "a skin job packs in steps of 0");
}

}  // namespace claque::skin
