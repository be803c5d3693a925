// The animated structure of a Model or Template: a node tree, its clips, and the entries of the matrix palette. S0 3
// (articulated structure of Skeleton nodes), S1 4 (matrix palette). Stored as structure of arrays, so that a frame
// reads memory in order.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <string>
#include <string_view>
#include <vector>

#include "lib/math/affine.h"
#include "lib/model/clip_annotations.h"

namespace claque::model
{

template <class T>
using Array = std::pmr::vector<T>;

constexpr uint32_t none = 0xffffffffu;

enum class ChannelTarget : uint8_t { translation = 0, rotation = 1, scale = 2, morph_weights = 3 };
enum class Interpolation : uint8_t { step = 0, linear = 1, cubic_spline = 2 };

// The animation of one property of one node. `times[first_time .. +key_count)` ascend strictly, in seconds on the
// clip's own axis. Values begin at `first_value`; the target gives the components per key (3, 4 as x y z w, 3, or the
// morph target count). Cubic splines have three such groups per key (in-tangent, value, out-tangent), as in glTF. For
// morph_weights `node` is the index of a MorphSet.
struct Channel {
    uint32_t node = 0;
    ChannelTarget target = ChannelTarget::translation;
    Interpolation interpolation = Interpolation::linear;
    uint16_t component_count = 3;
    uint32_t first_time = 0;
    uint32_t key_count = 0;
    uint32_t first_value = 0;
};

struct Clip {
    uint32_t first_channel = 0;
    uint32_t channel_count = 0;
    float start_s = 0;     // the first key of any channel
    float duration_s = 0;  // the last key of any channel minus start_s; 0 for a single pose
};

// A matrix of the palette: the node's matrix in model space times inverse_bind. Rigid parts use (node, identity).
struct PaletteEntry {
    uint32_t node = 0;
    math::Affine inverse_bind;
};

// The morph targets of one mesh node, and their range in a pose's list of weights.
struct MorphSet {
    uint32_t node = 0;
    uint32_t first_weight = 0;
    uint32_t target_count = 0;
};

enum class DofKind : uint8_t { rotation = 0, translation = 1, morph = 2 };

// One degree of freedom of a node (S0 3): a number that control mechanisms write. It acts on the node's own transform,
// at rest or from a clip, between its rotation and its scale: a rotation about `axis` or a translation along it, in the
// order of the list. A morph one is added to the weight of one target of the node's morph set.
struct Dof {
    uint32_t node = 0;  // morph: the index of a MorphSet instead
    DofKind kind = DofKind::rotation;
    uint32_t morph_target = 0;            // morph: index within the set
    glm::vec3 axis = glm::vec3(0, 1, 0);  // unit, in the node's own frame
    float min = 0, max = 0;               // its range, min <= max: radians, model units or weight
    float rest = 0;                       // within the range; the value without any write
};

struct Rig {
    explicit Rig(std::pmr::memory_resource *memory = std::pmr::get_default_resource())
        : parents(memory),
          rest(memory),
          node_names(memory),
          palette(memory),
          morph_sets(memory),
          rest_weights(memory),
          clips(memory),
          clip_names(memory),
          channels(memory),
          times(memory),
          values(memory),
          deactivation_m(memory),
          dofs(memory),
          dof_names(memory),
          markers(memory),
          marker_names(memory),
          root_curves(memory),
          root_samples(memory)
    {
    }
    Rig(const Rig &other, std::pmr::memory_resource *memory);
    Rig(Rig &&) = default;
    Rig(const Rig &) = delete;
    Rig &operator=(Rig &&) = default;

    // Nodes, parents before children; parents[i] is none for roots. Roots lie in model space: everything above a
    // skeleton in the file (axes, a scale of 100) is an ordinary node.
    Array<uint32_t> parents;
    Array<math::Trs> rest;
    Array<std::pmr::string> node_names;  // may be empty strings

    Array<PaletteEntry> palette;

    Array<MorphSet> morph_sets;
    Array<float> rest_weights;  // one per weight of all sets

    Array<Clip> clips;
    Array<std::pmr::string> clip_names;
    Array<Channel> channels;
    Array<float> times;
    Array<float> values;

    // S0 5.2: the distance from which a node and its descendants are not evaluated; infinity: never. One per node, or
    // empty: never for all.
    Array<float> deactivation_m;

    Array<Dof> dofs;
    Array<std::pmr::string> dof_names;  // one per degree of freedom, may be empty strings

    Array<Marker> markers;
    Array<std::pmr::string> marker_names;  // one per marker
    Array<RootCurve> root_curves;
    Array<float> root_samples;

    uint32_t node_count() const { return static_cast<uint32_t>(parents.size()); }
    uint32_t find_node(std::string_view name) const;  // none if no node has this name
    uint32_t find_clip(std::string_view name) const;
    uint32_t find_dof(std::string_view name) const;
    // Infinity if the node is never deactivated.
    float deactivation_of(uint32_t node) const;
};

// From the first key of any channel to the last one; both 0 without channels.
void set_span(const Rig &rig, Clip &clip);

// Throws base::Error (CLQ_ARGUMENT) that names the first broken rule unless every index, order and length above is
// valid and every number is finite. Rotations at rest have length 1 within 0.001, because any other length would scale
// the node's children without their normals and spheres. A rig that passes is safe to evaluate.
void check(const Rig &rig);

}  // namespace claque::model
