// Computes the matrix palette that skinning uses (S1 4), and the weights of morph targets, from one clip at one time.
#pragma once

#include <vector>

#include "lib/base/span.h"
#include "lib/base/status.h"
#include "lib/math/simd.h"
#include "lib/math/simd_level.h"
#include "lib/model/template.h"
#include "lib/pose/layer.h"
#include "lib/pose/leg.h"
#include "lib/pose/upper.h"

namespace claque::pose
{

size_t scratch_floats(const model::Rig &rig, const model::Motion *motion = nullptr);

// The inputs, scratch memory and outputs of the pose of a rig. It allocates nothing and keeps no state. Any number of
// jobs may run at once on one Rig.
struct PoseJob {
    // in
    const model::Rig *rig = nullptr;
    const model::Motion *motion = nullptr;  // of the same rig; null or empty: clips are sampled from their channels
    uint32_t clip = model::none;            // none: the rest pose and the rest weights
    double time_s = 0;                    // on the clip's own axis, from start_s on; clamped to each channel's own keys
    base::Span<const Layer> layers;       // replaces clip and time_s unless empty
    const float *dofs = nullptr;          // [rig.dofs.size()], on top of the clip; null: all at rest
    base::Span<const FootTarget> feet;    // of legs that are moved afterwards; run() alone does it
    UpperTarget upper;                    // head and torso, likewise
    const model::Level *level = nullptr;  // limits the skeleton to the level's active nodes (S0 5.2); null: all nodes

    math::SimdLevel simd_level = math::default_simd_level();

    // Scratch. Afterwards `globals` holds the nodes' transforms in model space, and `locals` those of
    // run_local_transforms() or run_local_matrices().
    base::Span<math::Trs> locals;       // [node_count]
    base::Span<math::Columns> globals;  // [node_count], 16-byte aligned
    base::Span<float> scratch;          // [scratch_floats()]; may be empty if there are neither layers nor motion

    // out
    base::Span<math::Affine> palette;  // [rig.palette.size()], followed by one more writable float
    base::Span<float> weights;         // [rig.rest_weights.size()]

    base::Status check() const;  // reports the first broken rule
    void run() const;            // requires check()
    // The end of run(): `nodes` null: all.
    void move_feet(const uint32_t *nodes, uint32_t node_count) const;
    bool has_rows() const;  // whether clips are sampled from motion

    // Instead of run(): writes local transforms to `locals`, and the weights.
    void run_local_transforms() const;

    // Instead of run(): writes each active node's matrix relative to its parent, for GL's matrix stack; no palette.
    // Returns the number of matrices that differ from the rest pose; the others are copies (S0 6.2.2, fCoh). `out`:
    // [node_count].
    uint32_t run_local_matrices(base::Span<math::Affine> out) const;
};

// Computes the palette of a level from the results of run_local_matrices(), for callers that need the transforms of
// rigid parts (S0 6.2.2). `globals`: [node_count]; `palette`: [rig.palette.size()], followed by one more writable
// float.
void palette_from_locals(const model::Rig &rig, const model::Level &level, const math::Affine *locals,
                         math::Columns *globals, math::Affine *palette);

// Owns the memory of a PoseJob. For start-up code and tests: the constructor allocates.
class Workspace
{
public:
    explicit Workspace(const model::Rig &rig, const model::Motion *motion = nullptr);
    // Returns a job with all memory set; the caller sets clip, time and layers.
    PoseJob job();
    // Poses and returns the palette, which is valid until the next call.
    base::Span<const math::Affine> pose(uint32_t clip, double time_s);

    // Valid after run_local_transforms().
    base::Span<const math::Trs> locals() const { return base::Span<const math::Trs>(locals_); }
    math::Affine global(uint32_t node) const;  // of the last pose, in model space
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
