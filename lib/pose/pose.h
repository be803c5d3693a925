// One clip at one time to the matrix palette that skinning follows (S1 4), and the weights of morph targets.
#pragma once

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/math/simd.h"
#include "lib/math/simd_level.h"
#include "lib/model/template.h"
#include "lib/pose/layer.h"

#include <vector>

namespace claque::pose
{

size_t scratch_floats(const model::Rig &rig, const model::Motion *motion = nullptr);

// Everything the pose of a rig needs; allocates nothing, keeps nothing. Any number may run at once on one Rig.
struct PoseJob {
    // in
    const model::Rig *rig = nullptr;
    const model::Motion *motion = nullptr;  // of the same rig; null or empty: clips are sampled from their channels
    uint32_t clip = model::none;            // none: the rest pose and the rest weights
    double time_s = 0;                    // on the clip's own axis, from start_s on; clamped to each channel's own keys
    base::Span<const Layer> layers;       // instead of clip and time_s, unless empty
    const float *dofs = nullptr;          // [rig.dofs.size()], on top of the clip; null: all at rest
    const model::Level *level = nullptr;  // only what is left of the skeleton there (S0 5.2); null: everything

    math::SimdLevel simd_level = math::default_simd_level();

    // scratch; what is left in it: globals in model space. Locals only by run_transforms() and run_locals().
    base::Span<math::Trs> locals;       // [node_count]
    base::Span<math::Columns> globals;  // [node_count], 16-byte aligned
    base::Span<float> scratch;          // [scratch_floats()]; may be empty where there are neither layers nor motion

    // out
    base::Span<math::Affine> palette;  // [rig.palette.size()], with one more float of memory behind the last
    base::Span<float> weights;         // [rig.rest_weights.size()]

    base::Status check() const;  // the first broken rule
    void run() const;            // requires check()
    bool has_rows() const;       // whether clips are sampled from motion

    // Instead of run(): local transforms in `locals`, and the weights.
    void run_local_transforms() const;

    // Instead of run(): each active node's matrix relative to its parent, for GL's matrix stack; no palette. Returns how
    // many are not those of the rest pose: the others cost a copy (S0 6.2.2, fCoh).
    //   out   [node_count]
    uint32_t run_local_matrices(base::Span<math::Affine> out) const;
};

// From what run_locals() left to the palette of a level, for who needs to know where rigid parts are (S0 6.2.2).
//   globals   [node_count]; palette [rig.palette.size()], with one more float of memory behind the last
void palette_from_locals(const model::Rig &rig, const model::Level &level, const math::Affine *locals,
                         math::Columns *globals, math::Affine *palette);

// Owns what a PoseJob asks for. For start-up code and tests: it allocates when it is made.
class Workspace
{
public:
    explicit Workspace(const model::Rig &rig, const model::Motion *motion = nullptr);
    // All that a job needs but what it shall show.
    PoseJob job();
    // Poses and returns the palette, good until the next call.
    base::Span<const math::Affine> pose(uint32_t clip, double time_s);

    base::Span<const math::Trs> locals() const
    {
        return base::Span<const math::Trs>(locals_);
    }                                          // after run_transforms()
    math::Affine global(uint32_t node) const;  // of the last pose, model space
    base::Span<const float> weights() const { return base::Span<const float>(weights_); }

private:
    const model::Rig *rig_;
    const model::Motion *motion_;
    std::vector<math::Trs> locals_;
    std::vector<math::Columns> globals_;
    std::vector<math::Affine> palette_;
    std::vector<float> weights_, scratch_;
};

}  // namespace claque::pose
