// All blocks of a run by skin_block(), which stands before this is included, with what it says by macros: the attributes of
// functions for the processors that it is for (CLAQUE_BLOCKS), and the name of the function made (CLAQUE_BLOCKS_RUN).
// No #pragma once: each file that includes it has its own.
#include <cstring>

#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

template <uint32_t K, bool OwnNormalMatrices>
CLAQUE_BLOCKS void run_kernel(const BlockRun run)
{
    uint32_t b = 0;
    for (; b < run.count && run.blocks[b].first + model::lane_count <= run.vertex_count; ++b) {
        const size_t at = 3 * size_t(run.blocks[b].first);
        skin_block<K, OwnNormalMatrices>(run, run.blocks[b], run.out_positions + at, run.out_normals + at);
    }
    for (; b < run.count; ++b) {  // no room for all lanes
        float positions[3 * model::lane_count], normals[3 * model::lane_count];
        skin_block<K, OwnNormalMatrices>(run, run.blocks[b], positions, normals);
        const size_t at = 3 * size_t(run.blocks[b].first), bytes = 3 * size_t(run.blocks[b].count) * sizeof(float);
        std::memcpy(run.out_positions + at, positions, bytes);
        std::memcpy(run.out_normals + at, normals, bytes);
    }
}

template <uint32_t K>
void choose(const BlockRun &run)
{
    run.normal_palette ? run_kernel<K, true>(run) : run_kernel<K, false>(run);
}

}  // namespace

void CLAQUE_BLOCKS_RUN(const BlockRun &run)
{
    switch (run.influences) {
        case 1:
            return choose<1>(run);
        case 2:
            return choose<2>(run);
        case 3:
            return choose<3>(run);
        default:
            return choose<4>(run);
    }
}

}  // namespace claque::skin
