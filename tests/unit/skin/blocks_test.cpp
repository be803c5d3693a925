// Kernels of 128-bit lanes that a processor does not choose by itself, and memory with no more than the requested
// alignment.
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "lib/model/template.h"
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

// The worst memory of a host: every address is a multiple of the requested alignment, and not of twice that.
class BarelyAligned : public std::pmr::memory_resource
{
    void *do_allocate(size_t bytes, size_t alignment) override
    {
        char *memory =
            static_cast<char *>(std::pmr::new_delete_resource()->allocate(bytes + 2 * alignment, 2 * alignment));
        return memory + alignment;
    }
    void do_deallocate(void *memory, size_t bytes, size_t alignment) override
    {
        std::pmr::new_delete_resource()->deallocate(static_cast<char *>(memory) - alignment, bytes + 2 * alignment,
                                                    2 * alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }
};

struct Made {
    std::vector<float> floats = std::vector<float>(6 * 100, -77.0f);
    std::vector<PackedPosition> positions = std::vector<PackedPosition>(100);
    std::vector<PackedNormal> normals = std::vector<PackedNormal>(100);

    bool operator==(const Made &o) const
    {
        return std::memcmp(floats.data(), o.floats.data(), floats.size() * sizeof(float)) == 0 &&
               std::memcmp(positions.data(), o.positions.data(), positions.size() * sizeof(PackedPosition)) == 0 &&
               std::memcmp(normals.data(), o.normals.data(), normals.size() * sizeof(PackedNormal)) == 0;
    }
};

class Blocks
{
public:
    explicit Blocks(uint32_t influences) : level_(&memory_)
    {
        std::mt19937 random(4);
        std::uniform_real_distribution<float> real(-1, 1);
        for (float &x : matrices_) x = real(random);
        level_.source_count = level_.vertex_count = 95;  // the last block is not full
        level_.runs.push_back({0, 95, influences, 0});
        for (uint32_t v = 0; v < 95; ++v) {
            for (int k = 0; k < 3; ++k)
                level_.positions.push_back(real(random)), level_.normals.push_back(real(random));
            for (uint32_t i = 0; i < influences; ++i)
                level_.joints.push_back(uint16_t((v / 16 + i) % 8)), level_.weights.push_back(real(random));
        }
        model::plan_skinning(level_);
    }

    Made made(void (*run_blocks)(const BlockRun &), bool own_normal_matrices) const
    {
        Made out;
        BlockRun run;
        run.blocks = level_.skinning.blocks.data();
        run.count = uint32_t(level_.skinning.blocks.size());
        run.influences = level_.runs[0].influences;
        run.lanes = level_.skinning.lanes.data();
        run.palette = matrices_;
        if (own_normal_matrices) run.normal_palette = matrices_ + 8 * aligned_matrix_floats;
        run.vertex_count = level_.vertex_count;
        run.out_positions = reinterpret_cast<Float3 *>(out.floats.data());
        run.out_normals = run.out_positions + 100;
        run_blocks(run);
        run.packed.range.step = 4.0f / 32767;
        run.packed.positions = out.positions.data(), run.packed.normals = out.normals.data();
        run_blocks(run);
        return out;
    }

private:
    BarelyAligned memory_;
    model::Level level_;
    alignas(32) float matrices_[16 * aligned_matrix_floats];
};

}  // namespace

TEST(SkinBlocks, HaveTheSameBitsOnEveryProcessor)
{
    for (uint32_t influences = 1; influences <= model::max_block_influences; ++influences)
        for (const bool own_normal_matrices : {false, true}) {
            const Blocks blocks(influences);
            const Made plain = blocks.made(run_128_blocks, own_normal_matrices);
            EXPECT_NE(plain.floats[3 * 94], -77.0f);
            EXPECT_EQ(plain.floats[3 * 95], -77.0f);
            if (math::has_avx()) {
                EXPECT_TRUE(plain == blocks.made(run_128_avx_blocks, own_normal_matrices)) << influences;
            }
            if (math::can_run(SimdLevel::simd256)) {
                EXPECT_TRUE(plain == blocks.made(run_256_blocks, own_normal_matrices)) << influences;
            }
        }
}

}  // namespace claque::skin
