// Vertices that kernels pack while skinning, compared with floats that are packed afterwards.
#pragma once

#include <cstring>

#include <gtest/gtest.h>

#include "lib/skin/skin.h"

namespace claque::skin
{

// The job has run with floats; it runs again. All bits must be equal, and nothing behind the last vertex changes.
inline void expect_packed_as_afterwards(SkinJob job)
{
    const uint32_t count = job.level->vertex_count, room = count + 8;
    std::vector<PackedPosition> positions(room), direct_positions(room);
    std::vector<PackedNormal> normals(room), direct_normals(room);
    PackJob pack;
    pack.range.offset[1] = 0.5f, pack.range.step = 1.7f / 32767;
    pack.simd_level = SimdLevel::scalar;
    pack.positions = {job.out_positions.data, 3 * count}, pack.normals = {job.out_normals.data, 3 * count};
    pack.out_positions = {positions.data(), count}, pack.out_normals = {normals.data(), count};
    ASSERT_TRUE(pack.check().ok()) << pack.check().text;
    pack.run();
    job.range = pack.range;
    job.out_positions = {}, job.out_normals = {};
    job.out_packed_positions = {direct_positions.data(), count};
    job.out_packed_normals = {direct_normals.data(), count};
    ASSERT_TRUE(job.check().ok()) << job.check().text;
    job.run();
    EXPECT_EQ(std::memcmp(positions.data(), direct_positions.data(), sizeof(PackedPosition) * room), 0);
    EXPECT_EQ(std::memcmp(normals.data(), direct_normals.data(), sizeof(PackedNormal) * room), 0);
}

}  // namespace claque::skin
