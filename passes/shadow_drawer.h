// Draws the shadows of one list: the vertices that individuals show are projected on the ground and drawn blended,
// every pixel at most once. That is ensured by a stencil bit if the host lends one, otherwise by a mask (ShadowMask).
#pragma once

#include <optional>

#include "passes/canvas.h"
#include "passes/preflight.h"
#include "passes/shadow_mask.h"

namespace claque::passes
{

// The target of the shadows, queried before.
struct ShadowTarget {
    int32_t width = 0, height = 0;  // of the viewport
};

// False for items without triangles at their level.
bool casts(const draw::Item &item);

class ShadowDrawer
{
public:
    ShadowDrawer(const Gl11 &gl, const Preflight &preflight, const Array<PreparedTemplate> &templates, Scratch &scratch,
                 const draw::DrawList &list, const ShadowOptions &options, ShadowTarget target, ShadowStats &stats);

    // Everything has been checked. Fails: CLQ_OUT_OF_MEMORY (an item without vertices).
    base::Status draw();

private:
    void set_state();
    void set_stencil();
    bool cast(const draw::Item &item, const PreparedLevel &ready);
    void cast_blob(const ShadowPlane &plane, const PreparedLevel &ready, bool by_indices);
    void cast_mesh(const ShadowPlane &plane, const PreparedLevel &ready);
    void flatten(const Flattener &flattener, const draw::Vertices &vertices, uint32_t step);
    void flatten_parts(const ShadowPlane &plane, const draw::Item &item, const PreparedLevel &ready);
    void draw_by_matrix(const Flattener &flattener, const draw::Vertices &vertices, const PreparedLevel &ready);
    void add(const ShadowPlane &plane, const FlattenedMesh &flat);

    const Gl11 &gl_;
    const Preflight &preflight_;
    const Array<PreparedTemplate> &templates_;
    Scratch &scratch_;
    const draw::DrawList &list_;
    const ShadowOptions &options_;
    ShadowTarget target_;
    ShadowStats &stats_;
    ShadowPlaneFinder plane_finder_;
    ShadowBatch batch_;
    std::optional<ShadowMask> shadow_mask_;
    uint32_t flat_count_ = 0;  // vertices in scratch_.shadow.flat
};

}  // namespace claque::passes
