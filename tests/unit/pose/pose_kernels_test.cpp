// The steps of posing give the same bits on every instruction set.
#include "lib/pose/pose_kernels.h"

#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace claque::pose
{

namespace
{

using model::block_numbers;
using model::motion_lanes;

constexpr uint32_t blocks = 3;

// Inputs and outputs of all steps, on random numbers.
struct Case {
    std::vector<int16_t> rows;
    std::vector<model::MotionBlock> places;
    std::vector<float> rest, pose, other, reference, weights, scales, offsets;
    std::vector<uint32_t> nodes, parents;
    std::vector<model::PaletteEntry> entries;
    std::vector<math::Columns> columns;
    std::vector<math::Affine> palette;

    explicit Case(uint32_t seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> real(-1, 1);
        const auto fill = [&](std::vector<float> &v, size_t n) {
            v.resize(n);
            for (float &x : v) x = real(random);
        };
        const size_t numbers = block_numbers * blocks;
        rows.resize(2 * numbers);
        for (int16_t &x : rows) x = int16_t(random());
        places = {{0, uint32_t(numbers), 255}, {model::none, 0, 0}, {block_numbers, 0, 255}};
        fill(rest, numbers), fill(pose, numbers), fill(other, numbers), fill(reference, numbers);
        fill(weights, motion_lanes * blocks), fill(scales, 3 * motion_lanes * blocks);
        fill(offsets, 4 * motion_lanes * blocks);
        const uint32_t count = motion_lanes * blocks - 2;
        for (uint32_t i = 0; i < motion_lanes * blocks; ++i) nodes.push_back(i < count ? count - 1 - i : model::none);
        for (uint32_t i = 0; i < count; ++i) {
            parents.push_back(i % 7 == 0 ? model::none : i / 2);
            math::Affine bind;
            for (float &c : bind.c) c = real(random);
            entries.push_back({(i * 5) % count, bind});
        }
        columns.resize(count), palette.resize(count);
    }

    void go(const PoseKernels &kernels, bool masked)
    {
        RotationRows from;
        from.numbers = rows.data(), from.blocks = places.data(), from.rest = rest.data();
        from.block_count = blocks, from.part = 0.3f;
        kernels.sample(from, pose.data());
        const JointWeights some = {0.7f, masked ? weights.data() : nullptr};
        kernels.replace(pose.data(), other.data(), some, blocks);
        kernels.add(pose.data(), other.data(), reference.data(), some, blocks);
        kernels.local_matrices(pose.data(), {nodes.data(), scales.data(), offsets.data(), blocks}, columns.data());
        const uint32_t count = uint32_t(parents.size());
        kernels.local_to_model(parents.data(), nullptr, count, columns.data());
        kernels.fill_palette(entries.data(), nullptr, count, columns.data(), palette.data());
    }
};

// All that this processor can run.
std::vector<const PoseKernels *> all_kernels()
{
    std::vector<const PoseKernels *> all = {&pose_kernels_scalar, &pose_kernels_128};
    if (math::has_avx()) all.push_back(&pose_kernels_128_avx);
    if (math::can_run(math::SimdLevel::simd256)) all.push_back(&pose_kernels_256);
    return all;
}

}  // namespace

TEST(PoseSteps, GiveTheSameBitsOnEveryInstructionSet)
{
    for (uint32_t seed = 0; seed < 200; ++seed) {
        Case expected(seed);
        expected.go(pose_kernels_scalar, seed % 2);
        for (const PoseKernels *kernels : all_kernels()) {
            Case run(seed);
            run.go(*kernels, seed % 2);
            ASSERT_EQ(0, std::memcmp(run.pose.data(), expected.pose.data(), 4 * run.pose.size()));
            for (size_t i = 0; i < run.columns.size(); ++i)
                ASSERT_EQ(0, std::memcmp(&run.columns[i], &expected.columns[i], sizeof run.columns[i]));
            ASSERT_EQ(0, std::memcmp(run.palette.data(), expected.palette.data(), 48 * run.palette.size()));
        }
    }
}

// Each level names the fastest kernels for it.
TEST(PoseSteps, AreThoseOfTheLevel)
{
    EXPECT_EQ(&pose_kernels_of(math::SimdLevel::scalar), &pose_kernels_scalar);
    EXPECT_EQ(&pose_kernels_of(math::SimdLevel::simd128), math::has_avx() ? &pose_kernels_128_avx : &pose_kernels_128);
    if (math::can_run(math::SimdLevel::simd256))
        EXPECT_EQ(&pose_kernels_of(math::SimdLevel::simd256), &pose_kernels_256);
}

TEST(PoseSteps, WriteNothingBehindThePalette)
{
    for (const PoseKernels *kernels : all_kernels()) {
        Case run(1);
        run.palette.emplace_back();
        for (float &c : run.palette.back().c) c = 123;
        run.go(*kernels, true);
        for (const float c : run.palette.back().c) EXPECT_EQ(c, 123.0f);
    }
}

}  // namespace claque::pose
