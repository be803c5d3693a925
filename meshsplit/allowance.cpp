#include "meshsplit/allowance.h"

#include <algorithm>

#include "lib/base/error.h"
#include "lib/model/model_size.h"
#include "meshsplit/reach_point_sets.h"
#include "meshsplit/spheres.h"

namespace claque::meshsplit
{

using base::big;
using base::fail;

namespace
{

// Bytes of the support functions of one point set and of the sweeps of one degree of freedom, in both resolutions.
constexpr uint64_t bytes_per_point_set = 8ull * (162 + 642) + 512;
constexpr uint64_t bytes_per_candidate = 3 * 24;  // a growing array
// Precise evaluations of a free node (reach_nodes.cpp) are of the whole skeleton.
constexpr uint64_t evaluations_per_node = 24;
constexpr uint64_t parts_of_transform = 8, transforms_per_vertex = 8, bytes_per_search = 2048;
// The list of poses and the times of a clip, twice: extents are found beside the search.
constexpr uint64_t bytes_per_pose = 2 * (16 + 8);

}  // namespace

Allowance::Allowance(const model::Model &model)
    : source_(model::source_bytes(model)),
      bytes_(multiple * source_ + always_bytes),
      transforms_(transforms_per_byte * source_ + always_transforms)
{
    take(model::held_bytes(model), "the model itself");
}

void Allowance::take(uint64_t bytes, const char *what)
{
    if (bytes > bytes_ - taken_)
        fail(CLQ_LIMIT, "%s would take %llu bytes, and %llu of %llu are left: %llu for each of the %llu bytes read",
             what, big(bytes), big(bytes_ - taken_), big(bytes_), big(multiple), big(source_));
    taken_ += bytes;
}

void Allowance::take_transforms(uint64_t count, const char *what)
{
    if (count > transforms_)
        fail(CLQ_LIMIT, "%s would take %llu transforms: for the %llu bytes read %llu are the most", what, big(count),
             big(source_), big(transforms_));
}

SearchLimits search_limits(const model::Template &tmpl, const Allowance &allowance)
{
    const model::Rig &rig = tmpl.rig;
    SearchLimits out;
    uint64_t free = 0;
    if (!rig.dofs.empty())
        for (const uint8_t is_free : free_nodes(rig)) free += is_free;
    // What one pose costs: a bounded sphere, or the bound of a node's motion, is a part of a transform.
    uint64_t pose = (parts_of_transform + 1) * rig.node_count(), fixed = 0, listed = 1;
    for (const model::Level &level : tmpl.levels) pose += level.part_spheres.size() + rig.palette.size();
    uint64_t steps = parts_of_transform * evaluations_per_node * free * rig.node_count();
    for (uint32_t c = 0; c < rig.clips.size(); ++c) {
        const uint64_t samples = sample_count(rig, c);
        steps += samples * (pose + parts_of_transform * rig.clips[c].channel_count);
        listed += samples;
    }
    const uint64_t maximum = 4 * allowance.transforms();
    if (!rig.dofs.empty()) fixed = bytes_per_point_set * rig.palette.size();
    for (const model::Dof &dof : rig.dofs) fixed += DofSweep::bytes(dof, 162) + DofSweep::bytes(dof, 642);
    const uint64_t bytes = allowance.bytes() / 8 * 5;  // motion is made at the same time, of a quarter
    const uint64_t held = fixed + bytes_per_pose * listed;
    out.search = steps <= maximum && held <= bytes;
    if (!out.search) return out;
    // A walk also visits poses between those that are listed.
    const uint64_t per_visit = bytes_per_candidate * (free + 2);
    out.poses = std::min(8 * maximum / std::max<uint64_t>(pose, 1), (bytes - held) / per_visit);
    out.search = listed <= out.poses;
    out.vertices = allowance.transforms() / transforms_per_vertex;
    out.precise = std::max<uint64_t>(64, bytes_per_search * allowance.transforms() / std::max<uint64_t>(fixed, 1));
    return out;
}

}  // namespace claque::meshsplit
