// Packed vertices: rounding, ranges and equal bits on every kernel.
#include "lib/skin/pack.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "lib/skin/pack_kernel.h"

namespace claque::skin
{

namespace
{

struct Packed {
    std::vector<PackedPosition> positions;
    std::vector<PackedNormal> normals;
};

Packed pack(const std::vector<float> &positions, const std::vector<float> &normals, const PackRange &range,
            SimdLevel simd_level)
{
    Packed out{std::vector<PackedPosition>(positions.size() / 3), std::vector<PackedNormal>(positions.size() / 3)};
    PackJob job;
    job.positions = base::Span<const float>(positions);
    job.normals = base::Span<const float>(normals);
    job.range = range;
    job.simd_level = simd_level;
    job.out_positions = base::Span<PackedPosition>(out.positions);
    job.out_normals = base::Span<PackedNormal>(out.normals);
    EXPECT_TRUE(job.check().ok()) << job.check().text;
    job.run();
    return out;
}

std::vector<float> random_numbers(size_t count, float limit)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> real(-limit, limit);
    std::vector<float> out(count);
    for (float &x : out) x = real(random);
    return out;
}

PackRange some_range()
{
    PackRange range;
    range.offset[0] = 0.25f, range.offset[1] = 1.0f, range.offset[2] = -0.125f;
    range.step = 1.5f / 32767;
    return range;
}

void expect_same(const Packed &a, const Packed &b)
{
    ASSERT_EQ(a.positions.size(), b.positions.size());
    if (a.positions.empty()) return;
    EXPECT_EQ(std::memcmp(a.positions.data(), b.positions.data(), 8 * a.positions.size()), 0);
    EXPECT_EQ(std::memcmp(a.normals.data(), b.normals.data(), 4 * a.normals.size()), 0);
}

}  // namespace

TEST(Pack, PutsEveryPositionOnTheNearestStepAndEveryNormalNearItsDirection)
{
    const std::vector<float> positions = random_numbers(3 * 1001, 0.4f), normals = random_numbers(3 * 1001, 2);
    const PackRange range = some_range();
    const Packed got = pack(positions, normals, range, SimdLevel::simd128);
    double widest_deg = 0;
    for (size_t v = 0; v < got.positions.size(); ++v) {
        const int16_t p[3] = {got.positions[v].x, got.positions[v].y, got.positions[v].z};
        for (size_t k = 0; k < 3; ++k) {
            const double exact = (double(positions[3 * v + k]) - range.offset[k]) / double(range.step);
            ASSERT_NEAR(p[k], exact, 0.51) << v;  // single precision adds this to a half
        }
        ASSERT_EQ(got.positions[v].w, 1);
        const double n[3] = {normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]};
        const double q[3] = {double(got.normals[v].x), double(got.normals[v].y), double(got.normals[v].z)};
        const double dot = n[0] * q[0] + n[1] * q[1] + n[2] * q[2];
        const double lengths =
            std::sqrt((n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]));
        widest_deg = std::max(widest_deg, std::acos(std::min(1.0, dot / lengths)) * 57.29577951308232);
    }
    EXPECT_LT(widest_deg, 0.4);
    EXPECT_GT(widest_deg, 0.1);
}

TEST(Pack, RoundsHalvesToTheEvenStep)
{
    PackRange range;
    const std::vector<float> positions = {0.5f, 1.5f, 2.5f, -0.5f, -1.5f, -2.5f, 3.5f, -3.5f, 0.49f, 7, 8, 9},
                             normals(12, 1.0f);
    for (const SimdLevel simd_level : {SimdLevel::scalar, SimdLevel::simd128}) {
        const Packed got = pack(positions, normals, range, simd_level);
        EXPECT_EQ(got.positions[0].x, 0);
        EXPECT_EQ(got.positions[0].y, 2);
        EXPECT_EQ(got.positions[0].z, 2);
        EXPECT_EQ(got.positions[1].x, 0);
        EXPECT_EQ(got.positions[1].y, -2);
        EXPECT_EQ(got.positions[1].z, -2);
        EXPECT_EQ(got.positions[2].x, 4);
        EXPECT_EQ(got.positions[2].y, -4);
        EXPECT_EQ(got.positions[2].z, 0);
    }
}

TEST(Pack, GivesTheSameBitsWithEveryKernelAndCount)
{
    for (size_t count = 0; count < 40; ++count) {
        const std::vector<float> positions = random_numbers(3 * count, 4), normals = random_numbers(3 * count, 1);
        expect_same(pack(positions, normals, some_range(), SimdLevel::scalar),
                    pack(positions, normals, some_range(), SimdLevel::simd128));
    }
}

TEST(Pack, ClampsOutOfRangeNumbersAndNaN)
{
    const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> odd = {infinite, -infinite, nan, 1e30f, -1e30f, 0, 1e-40f, 0, -0.0f, nan, 0, 1};
    const Packed a = pack(odd, odd, some_range(), SimdLevel::scalar),
                 b = pack(odd, odd, some_range(), SimdLevel::simd128);
    expect_same(a, b);
    EXPECT_EQ(a.positions[0].x, 32767);
    EXPECT_EQ(a.positions[0].y, -32767);
    EXPECT_EQ(a.positions[0].z, 32767);
    EXPECT_EQ(a.normals[2].x, 0);
    EXPECT_EQ(a.normals[2].z, 0);
}

TEST(Pack, ReachesTheWholeSphereOfATemplate)
{
    model::Template tmpl(std::pmr::get_default_resource());
    tmpl.sklsroot.centre = {0, 1, 0};
    tmpl.sklsroot.radius = 2;
    const PackRange range = pack_range(tmpl);
    const Packed got =
        pack({0, 3, 0, 0, -1, 0, 2, 1, 0, 0.5f, 0.5f, 0.5f}, std::vector<float>(12, 1.0f), range, SimdLevel::simd128);
    EXPECT_EQ(got.positions[0].y, 32767);
    EXPECT_EQ(got.positions[1].y, -32767);
    EXPECT_EQ(got.positions[2].x, 32767);
    const glm::vec3 back = unpacked(got.positions[3], range);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], 0.5f, range.step / 2);
}

TEST(PackJob, NamesTheFirstBrokenRule)
{
    const std::vector<float> numbers(6, 0.0f);
    PackJob job;
    job.positions = base::Span<const float>(numbers);
    EXPECT_STREQ(job.check().text, "a pack job has 6 numbers of positions and 0 of normals");
    job.normals = base::Span<const float>(numbers);
    EXPECT_STREQ(job.check().text, "a pack job of 2 vertices has room for 0 positions and 0 normals");
    PackedPosition positions[2];
    PackedNormal normals[2];
    job.out_positions = {positions, 2};
    job.out_normals = {normals, 2};
    job.range.step = 0;
    EXPECT_STREQ(job.check().text, "a pack job has steps of 0");
}

}  // namespace claque::skin
