#include "lib/crowd/extras.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/crowd.h"
#include "lib/crowd/reserve.h"

namespace claque::crowd
{

using base::fail;
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

uint32_t Crowd::extra_slot(uint32_t row)
{
    if (extras_of_[row] != none) return extras_of_[row];
    if (first_free_extra_ == none) reserve_one(extras_);
    uint32_t slot = first_free_extra_;
    if (slot == none) {
        slot = static_cast<uint32_t>(extras_.size());
        extras_.emplace_back();
    } else {
        first_free_extra_ = extras_[slot].next_free;
        extras_[slot] = Extra();
    }
    return extras_of_[row] = slot;
}

void Crowd::clear_extra(uint32_t row)
{
    const uint32_t slot = extras_of_[row];
    if (slot == none) return;
    for (uint32_t i = extras_[slot].first_attached; i != none;) {
        Attachment &attached = attached_[i];
        const uint32_t next = attached.next;
        free_attached(i);
        i = next;
    }
    extras_[slot] = Extra();
    extras_[slot].next_free = first_free_extra_;
    first_free_extra_ = slot;
    extras_of_[row] = none;
}

void Crowd::free_attached(uint32_t index)
{
    Attachment &attached = attached_[index];
    const uint32_t generation = attached.generation + 1;
    attached = Attachment();
    attached.generation = generation;
    if (generation == 0xfffffffeu) return;
    attached.next = first_free_attached_;
    first_free_attached_ = index;
}

// S0 4.1, 4.3: everything that an actor is, wherever its Skeleton Root goes.
void Crowd::measure(uint32_t row)
{
    const model::Template &tmpl = template_of(row);
    Extent &extent = extents_[row];
    const LayerState *layer_state = layers_.of(row);
    const bool blends = layer_state || behaviours_.blends(row);
    const float added = layer_state ? layer_state->max_additive_weight() : 0;
    extent.sklsroot = blends ? blended_reach_of(tmpl, added) : tmpl.sklsroot.radius;
    extent.slack = 0;
    if (extras_of_[row] != none) {
        const Extra &extra = extras_[extras_of_[row]];
        for (uint32_t i = extra.first_attached; i != none; i = attached_[i].next)
            extent.sklsroot = std::max(
                extent.sklsroot, blends ? blended_reach_of(tmpl, attached_[i], added) : reach_of(tmpl, attached_[i]));
        extent.slack = std::max(extra.max_up, extra.max_down);
    }
    const double way = behaviours_.has_root_path_play(row)
                           ? static_cast<double>(behaviours_.path(behaviours_.root_path_play(row).path).reach)
                           : 0.0;
    extent.refpoint = up(length(tmpl.sklsroot.centre) + static_cast<double>(extent.sklsroot) + way);
    touch_group(row);
}

void Crowd::touch_group(uint32_t row)
{
    if (groups_of_[row] != none) groups_[groups_of_[row]].version = next_version_++;
}

Id Crowd::attach(Id id, uint32_t node, const model::Sphere &sphere)
{
    const uint32_t row = row_of(id);
    const model::Template &tmpl = template_of(row);
    if (node >= tmpl.rig.node_count())
        fail(CLQ_ARGUMENT, "node %u of %u of template '%s'", node, tmpl.rig.node_count(), tmpl.name.c_str());
    if (!std::isfinite(length(sphere.centre)) || !(sphere.radius >= 0) || !std::isfinite(sphere.radius))
        fail(CLQ_ARGUMENT, "an attached object's sphere has radius %g or a centre that is not finite",
             static_cast<double>(sphere.radius));
    if (first_free_attached_ == none) reserve_one(attached_);
    const uint32_t slot = extra_slot(row);
    uint32_t index = first_free_attached_;
    if (index == none) {
        index = static_cast<uint32_t>(attached_.size());
        attached_.emplace_back();
    } else {
        first_free_attached_ = attached_[index].next;
    }
    Attachment &attached = attached_[index];
    attached.row = row;
    attached.node = node;
    attached.sphere = sphere;
    ++attached.generation;
    attached.next = extras_[slot].first_attached;
    extras_[slot].first_attached = index;
    measure(row);
    return {index + 1, attached.generation};
}

void Crowd::detach(Id id)
{
    const uint32_t index = id.index1 - 1;
    if (id.index1 == 0 || index >= attached_.size() || attached_[index].generation != id.generation ||
        !(id.generation & 1))
        fail(CLQ_STALE_ID, "no attached object has index %u and generation %u", id.index1, id.generation);
    const uint32_t row = attached_[index].row;
    uint32_t *link = &extras_[extras_of_[row]].first_attached;
    while (*link != index) link = &attached_[*link].next;
    *link = attached_[index].next;
    free_attached(index);
    measure(row);
}

void Crowd::set_hooks(Id id, const clq_actor_hooks &hooks)
{
    const uint32_t row = row_of(id);
    if (!hooks.before && !hooks.after && extras_of_[row] == none) return;
    extras_[extra_slot(row)].hooks = hooks;
}

void Crowd::follow_ground(Id id, float max_up, float max_down)
{
    const uint32_t row = row_of(id);
    if (!(max_up >= 0) || !(max_down >= 0) || !std::isfinite(max_up) || !std::isfinite(max_down))
        fail(CLQ_ARGUMENT, "an actor follows the ground %g up and %g down: 0 or more is wanted",
             static_cast<double>(max_up), static_cast<double>(max_down));
    Extra &extra = extras_[extra_slot(row)];
    extra.max_up = max_up, extra.max_down = max_down;
    measure(row);
}

void Crowd::set_priority(Id id, float priority)
{
    const uint32_t row = row_of(id);
    if (!(priority >= 0 && priority <= 1))
        fail(CLQ_ARGUMENT, "a priority of %g: 0 to 1 is wanted", static_cast<double>(priority));
    extents_[row].priority = priority;
}

void Crowd::set_ground(double (*height)(void *user, const double point[3]), void *user)
{
    ground_ = height;
    ground_user_ = user;
}

void Crowd::play_root_path(Id id, const RootPathPlay &root_play)
{
    const uint32_t row = row_of(id);
    if (root_play.path != none && root_play.path >= behaviours_.path_count())
        fail(CLQ_ARGUMENT, "path %u of %u", root_play.path + 1, behaviours_.path_count());
    if (!std::isfinite(root_play.speed) || !std::isfinite(root_play.phase_s) || !std::isfinite(root_play.start_s))
        fail(CLQ_ARGUMENT, "speed, phase and start of a root's motion are %g, %g and %g: they must be finite",
             static_cast<double>(root_play.speed), static_cast<double>(root_play.phase_s), root_play.start_s);
    behaviours_.play_root_path(row, root_play);
    new_version(row);
    measure(row);
}

}  // namespace claque::crowd
