// Posing and skinning one individual into given memory: what caches and the on-demand server both do, so that a cache
// can change what a frame costs but never what it shows.
#pragma once

#include "animcache/keypose.h"
#include "animcache/settings.h"
#include "lib/base/span.h"
#include "lib/draw/draw_list.h"
#include "lib/math/simd.h"
#include "lib/pose/layer.h"

namespace claque::animcache
{

// Which pose an individual shows. A version stands for one play of one individual, so it names template and clip too.
struct PoseKey {
    uint64_t version = 0;  // 0 is no pose
    double clip_time_s = 0;
    double tick_s = 0;              // of what control mechanisms wrote; 0 where there are none
    uint64_t behaviour_levels = 0;  // of these mechanisms
    uint32_t clip = model::none;    // what an idle mechanism has drawn differs within one version
    uint32_t skeletal_level = 0;    // S0 5.2: what is left of the skeleton
    uint32_t layers = 0;        // that are blended, 0: the clip alone; what they are is a function of tick and version
    bool interpolated = false;  // between the key-poses round that clip time (S3 4), so there are vertices only
    bool operator==(const PoseKey &o) const
    {
        return version == o.version && clip_time_s == o.clip_time_s && tick_s == o.tick_s &&
               behaviour_levels == o.behaviour_levels && clip == o.clip && skeletal_level == o.skeletal_level &&
               layers == o.layers && interpolated == o.interpolated;
    }
};

// Where the matrices of rigid parts are multiplied (S0 6.2.2, fTrack).
enum class RigidMode : uint8_t {
    vertices = 0,  // here, and vertices moved by them: a palette is kept
    matrices = 1   // by GL's matrix stack: each node's matrix relative to its parent is kept
};

// One individual that is seen in this update.
struct Request {
    const model::Template *tmpl = nullptr;
    uint32_t row = 0;    // in the crowd
    uint32_t level = 0;  // of the template
    PoseKey pose;
    RigidMode rigid_mode = RigidMode::vertices;
    double shown_s = 0;  // tick of the pose, on the host's clock
    float period_s = 0;  // between ticks; 0: every frame
    float distance = 0;  // to the nearest eye: who is near goes first where not all can be renewed
    bool drawn = true;   // false: posed for what depends on it, but no view sees it
    const float *dofs =
        nullptr;  // [rig.dofs.size()], what control mechanisms wrote; null: at rest. Of those that are due
    base::Span<const pose::Layer> layers;  // instead of the clip of `pose`, unless empty; as long-lived as the lists
    float blend_radius = 0;     // with layers: of a sphere about sklsroot.centre that holds every blend of this version
    KeyPoseSelection key_pose;  // of who shows key-poses

    // Who shows a key-pose that is kept, or two, has no use for matrices.
    bool needs_palette() const
    {
        return key_pose.mode != KeyPoseMode::interpolated &&
               !(key_pose.mode == KeyPoseMode::intermittent && key_pose.served());
    }
};

// Sizes of memory in floats, for one template or the largest of several.
struct Sizes {
    size_t nodes = 0;
    size_t palette_floats = 0;  // matrices of the palette, or of the nodes; then morph weights, then padding
    size_t vertex_floats = 0;   // positions and normals of the largest level, copies included (S1 4), and padding
    size_t scratch_floats = 0;  // skinning: morphed vertices, matrices of normals
    size_t spare_floats = 0;    // vertices of a second key-pose, for who interpolates them: else 0
    void grow_to(const Sizes &other);
};

Sizes sizes_of(const model::Template &tmpl, VertexFormat vertex_format);
// The largest of several, with what the settings' methods ask for.
Sizes sizes_of(base::Span<const model::Template *const> templates, const Settings &settings);
// Positions and normals of a level, and padding.
size_t vertex_floats(const model::Level &level, VertexFormat vertex_format);

// Working memory of one task.
struct Scratch {
    math::Trs *locals = nullptr;
    math::Columns *globals = nullptr;
    float *floats = nullptr;
    float *palette = nullptr;   // of who has none of its own
    float *vertices = nullptr;  // of a second key-pose; null where nobody interpolates
    const Sizes *sizes = nullptr;
};

// palette: [sizes_of(tmpl).palette_floats]. Returns how many nodes' matrices it built (S0 6.2.2, fCoh).
uint32_t animate(const Request &request, const Scratch &scratch, float *palette);
// Where animate() leaves the morph weights [rig.rest_weights.size()].
const float *morph_weights(const float *palette, const model::Template &tmpl);
// vertices: [sizes_of(tmpl).vertex_floats]; palette as animate() left it
void skin(const Request &request, const float *palette, VertexFormat vertex_format, const Scratch &scratch,
          float *vertices);

// How a level's vertices lie in such memory. blend_radius: of the request that they were skinned for.
draw::Vertices vertices_in(const float *memory, const model::Template &tmpl, uint32_t level, VertexFormat vertex_format,
                           float blend_radius = 0);

}  // namespace claque::animcache
