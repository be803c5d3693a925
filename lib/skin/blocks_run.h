// Runs skin_block() over all blocks of a run. The including file defines skin_block() first, and the output forms
// Floats and Packed, which are made from a BlockRun and hold the positions and normals of vertex 0. Macros set the
// function attributes that select the processors (CLAQUE_BLOCKS) and the name of the resulting function
// (CLAQUE_BLOCKS_RUN). No #pragma once: each including file needs its own copy.
#include <algorithm>

#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

template <class Form, uint32_t K, bool OwnNormalMatrices>
CLAQUE_BLOCKS void run_kernel(const BlockRun run)
{
    const Form form(run);
    uint32_t b = 0;
    for (; b < run.count && run.blocks[b].first + model::lane_count <= run.vertex_count; ++b) {
        const size_t at = run.blocks[b].first;
        skin_block<K, OwnNormalMatrices>(run, run.blocks[b], form, form.positions + at, form.normals + at);
    }
    for (; b < run.count; ++b) {  // no room for all lanes
        typename Form::Position positions[model::lane_count];
        typename Form::Normal normals[model::lane_count];
        skin_block<K, OwnNormalMatrices>(run, run.blocks[b], form, positions, normals);
        std::copy_n(positions, run.blocks[b].count, form.positions + run.blocks[b].first);
        std::copy_n(normals, run.blocks[b].count, form.normals + run.blocks[b].first);
    }
}

template <class Form, uint32_t K>
void choose(const BlockRun &run)
{
    run.normal_palette ? run_kernel<Form, K, true>(run) : run_kernel<Form, K, false>(run);
}

template <uint32_t K>
void choose_form(const BlockRun &run)
{
    run.packed.positions ? choose<Packed, K>(run) : choose<Floats, K>(run);
}

}  // namespace

void CLAQUE_BLOCKS_RUN(const BlockRun &run)
{
    switch (run.influences) {
        case 1:
            return choose_form<1>(run);
        case 2:
            return choose_form<2>(run);
        case 3:
            return choose_form<3>(run);
        default:
            return choose_form<4>(run);
    }
}

}  // namespace claque::skin
