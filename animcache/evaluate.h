// Poses and skins one individual into given memory: the same steps whether a cache keeps the result or not, so that a
// cache changes what a frame costs but never what it shows.
#pragma once

#include "animcache/keypose.h"
#include "animcache/settings.h"
#include "lib/base/span.h"
#include "lib/draw/draw_list.h"
#include "lib/math/simd.h"
#include "lib/pose/layer.h"
#include "lib/pose/leg.h"
#include "lib/pose/upper.h"

namespace claque::animcache
{

// Which pose an individual shows. A version is unique to one play of one individual, so it implies template and clip
// too.
struct PoseKey {
    uint64_t version = 0;  // 0 is no pose
    double clip_time_s = 0;
    double tick_s = 0;              // of the control mechanisms' output; 0 without mechanisms
    uint64_t behaviour_levels = 0;  // of these mechanisms
    uint32_t clip = model::none;    // the choice of an idle mechanism differs within one version
    uint32_t skeletal_level = 0;    // S0 5.2: the active nodes of the skeleton
    uint32_t layers = 0;            // blended; 0: the clip alone. A function of tick and version
    bool interpolated = false;      // between the two nearest key-poses (S3 4); has vertices only
    bool operator==(const PoseKey &o) const
    {
        return version == o.version && clip_time_s == o.clip_time_s && tick_s == o.tick_s &&
               behaviour_levels == o.behaviour_levels && clip == o.clip && skeletal_level == o.skeletal_level &&
               layers == o.layers && interpolated == o.interpolated;
    }
};

// Where the matrices of rigid parts are multiplied (S0 6.2.2, fTrack).
enum class RigidMode : uint8_t {
    vertices = 0,  // on the CPU, with vertices transformed by them: a palette is kept
    matrices = 1   // by GL's matrix stack: each node's matrix relative to its parent is kept
};

// What one candidate of an update requests from the caches.
struct Request {
    const model::Template *tmpl = nullptr;  // null: no view sees the candidate, so nothing is requested
    uint32_t row = 0;                       // in the crowd
    uint32_t slot = 0;                      // in the caches: the same in each update
    uint32_t level = 0;                     // of the template
    PoseKey pose;
    RigidMode rigid_mode = RigidMode::vertices;
    double shown_s = 0;                    // tick of the pose, on the host's clock
    float period_s = 0;                    // between ticks; 0: every frame
    float distance = 0;                    // to the nearest eye: when not all can be renewed, the nearest come first
    bool drawn = true;                     // false: posed because others depend on it, but no view sees it
    const float *dofs = nullptr;           // [rig.dofs.size()], output of control mechanisms if due; null: at rest
    base::Span<const pose::Layer> layers;  // replace the clip of `pose`, unless empty
    pose::FootTarget feet[2];              // of an actor on a track
    uint32_t foot_count = 0;
    pose::UpperTarget upper;  // and where it looks
    // with layers: radius of a sphere round sklsroot.centre that holds every blend of this version
    float blend_radius = 0;
    KeyPoseSelection key_pose;  // if it shows key-poses

    // Written by Caches: the matrices and vertices in this update, in a cache or in memory of this update alone. Null:
    // not needed, or no memory.
    float *palette = nullptr;
    float *vertices = nullptr;

    // Individuals that show kept key-poses need no matrices.
    bool needs_palette() const
    {
        return key_pose.mode != KeyPoseMode::interpolated &&
               !(key_pose.mode == KeyPoseMode::intermittent && key_pose.served());
    }
};

// Sizes of memory in floats, for one template or the maximum over several.
struct Sizes {
    size_t nodes = 0;
    size_t palette_floats = 0;  // matrices of the palette, or of the nodes; then morph weights, then padding
    size_t vertex_floats = 0;   // positions and normals of the largest level, copies included (S1 4), and padding
    size_t scratch_floats = 0;  // skinning: morphed vertices, matrices of normals
    size_t spare_floats = 0;    // vertices of a second key-pose, if key-poses are interpolated; else 0
    void grow_to(const Sizes &other);
};

Sizes sizes_of(const model::Template &tmpl, VertexFormat vertex_format);
// The maximum over several templates, with the needs of the settings' key-pose modes.
Sizes sizes_of(base::Span<const model::Template *const> templates, const Settings &settings);
// Positions and normals of a level, with padding.
size_t vertex_floats(const model::Level &level, VertexFormat vertex_format);

// Working memory of one task.
struct Scratch {
    math::Trs *locals = nullptr;
    math::Columns *globals = nullptr;
    float *floats = nullptr;
    float *palette = nullptr;   // of individuals without a palette of their own
    float *vertices = nullptr;  // of a second key-pose; null if none are interpolated
    const Sizes *sizes = nullptr;
};

// palette: [sizes_of(tmpl).palette_floats]. Returns the number of nodes whose matrices it built (S0 6.2.2, fCoh).
uint32_t animate(const Request &request, const Scratch &scratch, float *palette);
// Where animate() writes the morph weights [rig.rest_weights.size()].
const float *morph_weights(const float *palette, const model::Template &tmpl);
// vertices: [sizes_of(tmpl).vertex_floats]; palette as animate() wrote it
void skin(const Request &request, const float *palette, VertexFormat vertex_format, const Scratch &scratch,
          float *vertices);

// How a level's vertices are laid out in such memory. blend_radius: of the request that they were skinned for.
draw::Vertices vertices_in(const float *memory, const model::Template &tmpl, uint32_t level, VertexFormat vertex_format,
                           float blend_radius = 0);

}  // namespace claque::animcache
