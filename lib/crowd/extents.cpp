// Bounding radii of actors with attached objects, at all positions of the Skeleton Root (S0 4.1, 4.3).
#include <algorithm>
#include <cmath>

#include "lib/crowd/extras.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using model::none;

namespace
{

double length(const glm::vec3 &v)
{
    const glm::dvec3 d(v);
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

float up(double x) { return static_cast<float>(x * (1 + 1e-6)); }

float blended_reach_of(const model::Template &tmpl, const Attachment &attached, float added)
{
    const double own = length(attached.sphere.centre) + static_cast<double>(attached.sphere.radius);
    if (attached.node >= tmpl.blend_reach.size()) return up(4 * double(tmpl.sklsroot.radius) + 2 * own);
    const model::BlendReach &reach = tmpl.blend_reach[attached.node];
    return up(double(reach.distance.at(added)) + double(reach.scale.at(added)) * own);
}

}  // namespace

float blended_reach_of(const model::Template &tmpl, float added)
{
    if (tmpl.blend_reach.empty()) return up(4 * double(tmpl.sklsroot.radius));
    return up(double(tmpl.blend_radius.at(added)));
}

float reach_of(const model::Template &tmpl, const Attachment &attached)
{
    const double own = length(attached.sphere.centre) + static_cast<double>(attached.sphere.radius);
    if (attached.node >= tmpl.node_reach.size()) return up(2 * double(tmpl.sklsroot.radius) + own);
    const model::NodeReach &reach = tmpl.node_reach[attached.node];
    return up(double(reach.distance) + double(reach.scale) * own);
}

// S0 4.1, 4.3: the radii of an actor with all its parts, at all positions of its Skeleton Root.
void measure(Crowd &crowd, uint32_t row) noexcept
{
    const model::Template &tmpl = crowd.template_of(row);
    const Behaviours &behaviours = crowd.behaviours();
    Extent &extent = crowd.tables.actors.extents[row];
    const LayerState *layer_state = crowd.layers().of(row);
    const Follow *follow = crowd.follows().of(row);
    const bool blends = layer_state || follow || behaviours.blends(row);
    const float added = layer_state ? layer_state->max_additive_weight() : 0;
    extent.sklsroot = blends ? blended_reach_of(tmpl, added) : tmpl.sklsroot.radius;
    if (follow) extent.sklsroot = up(double(extent.sklsroot) + double(room_of(*follow)));
    extent.slack = 0;
    if (const Extra *extra = crowd.extra_of(row)) {
        const base::SlotMap<Attachment> &all = crowd.tables.extras.attached;
        for (uint32_t i = extra->first_attached; i != none; i = all[i].next)
            extent.sklsroot =
                std::max(extent.sklsroot, blends ? blended_reach_of(tmpl, all[i], added) : reach_of(tmpl, all[i]));
        extent.slack = std::max(extra->max_up, extra->max_down);
    }
    const double way = behaviours.has_root_path_play(row)
                           ? static_cast<double>(behaviours.path(behaviours.root_path_play(row).path).reach)
                           : 0.0;
    extent.refpoint = up(length(tmpl.sklsroot.centre) + static_cast<double>(extent.sklsroot) + way);
    touch_group(crowd, row);
    note(crowd, row);
}

}  // namespace claque::crowd
