#include "animcache/caches.h"

#include "animcache/keypose_vertices.h"
#include "lib/base/held_bytes.h"
#include "lib/base/slack.h"
#include "lib/pose/pose.h"

namespace claque::animcache
{

namespace
{

constexpr uint32_t slices = Caches::slice_count;

// The part of n that belongs to a slice, in order.
template <class Body>
void for_slice(uint32_t n, uint32_t slice, const Body &body)
{
    const uint32_t first = static_cast<uint32_t>(uint64_t(n) * slice / slices);
    const uint32_t last = static_cast<uint32_t>(uint64_t(n) * (slice + 1) / slices);
    for (uint32_t i = first; i < last; ++i) body(i);
}

}  // namespace

Caches::Caches(std::pmr::memory_resource *memory, const Settings &settings)
    : settings_(settings),
      blocks_(memory, settings.budget_bytes),
      arena_(memory),
      requests_(memory),
      requests_before_(memory),
      replaced_(memory),
      entries_(memory),
      animate_(memory),
      skin_(memory),
      waiting_(memory),
      built_(memory),
      scratch_(memory, slices),
      key_poses_(memory, settings.key_poses, settings.vertex_format)
{
}

Caches::~Caches() = default;

void Caches::reserve(uint32_t slot_count, base::Span<const model::Template *const> templates, bool can_undo,
                     uint32_t request_count)
{
    const uint32_t requests = std::min(slot_count, request_count);
    scratch_.reserve(sizes_of(templates, settings_));
    key_poses_.reserve(requests, templates);
    if (can_undo) base::reserve_with_slack(requests_before_, requests), base::reserve_with_slack(replaced_, requests);
    else base::reserve_with_slack(requests_, requests);
    base::reserve_with_slack(animate_, requests);
    base::reserve_with_slack(skin_, requests);
    if (settings_.can_defer) base::reserve_with_slack(waiting_, requests);
    if (entries_.size() < slot_count) {
        base::reserve_with_slack(entries_, slot_count);
        entries_.resize(slot_count);
    }
    built_.resize(slices);
}

uint64_t Caches::book_bytes() const
{
    return base::held_bytes(requests_, requests_before_, replaced_, entries_, animate_, skin_, waiting_, built_) +
           blocks_.book_bytes() + arena_.book_bytes() + scratch_.bytes() + key_poses_.book_bytes();
}

bool Caches::is_due(const Request &request) const
{
    if (!request.needs_palette()) return false;
    const Entry &entry = entries_[request.slot];
    return settings_.mode == Mode::none || !entry.palette || !(entry.palette_key == request.pose);
}

// GL's matrix stack moves rigid parts; vertices need a palette.
bool Caches::needs_vertices(const Request &request) const
{
    if (!request.drawn || request.rigid_mode == RigidMode::matrices) return false;
    return request.needs_palette() ? request.palette != nullptr : request.key_pose.mode == KeyPoseMode::interpolated;
}

void Caches::keep_pose(Entry &entry, const Request &request)
{
    entry.animated_at = frame_number_;
    if (request.palette != entry.palette) return;
    entry.palette_key = request.pose;
    entry.palette_radius = request.blend_radius;
    entry.shown_s = request.shown_s;
    entry.renewed_s = pose_budget_.time_s;
}

// From here on the update cannot be undone.
void Caches::commit()
{
    for (const Request &request : requests_)
        if (request.tmpl && request.needs_palette() && !is_due(request))
            entries_[request.slot].shown_s = request.shown_s;
    for (const uint32_t i : replaced_) {
        Entry &entry = entries_[requests_[i].slot];
        release(entry, &Entry::palette);
        release(entry, &Entry::vertices);
        entry.tmpl = requests_[i].tmpl;
    }
    replaced_.clear();
    key_poses_.commit();
    listed_from_ = ~uint64_t(0);
    last_listed_ = frame_number_;
}

void Caches::animate(const base::Jobs &jobs)
{
    commit();
    // Poses without a cache are made in every update, whatever the budget.
    for (uint32_t i = 0; without_room_ > 0 && i < requests_.size(); ++i)
        if (requests_[i].palette && !entries_[requests_[i].slot].palette) animate_.push_back(i);
    jobs.for_each(slices, [this](uint32_t slice) {
        const Scratch scratch = scratch_.slice(slice);
        built_[slice] = 0;
        for_slice(static_cast<uint32_t>(animate_.size()), slice, [&](uint32_t i) {
            const Request &request = requests_[animate_[i]];
            built_[slice] += animcache::animate(request, scratch, request.palette);
            keep_pose(entries_[request.slot], request);
        });
    });
    counters_.animated = static_cast<uint32_t>(animate_.size());
    if (settings_.can_defer && counters_.animated > pose_budget_.budget)
        counters_.over_budget = counters_.animated - pose_budget_.budget;
    for (const uint32_t built : built_) counters_.matrices_built += built;
}

void Caches::skin(const Request &request, const Scratch &scratch)
{
    if (request.key_pose.mode == KeyPoseMode::interpolated)
        interpolate(request, settings_.vertex_format, scratch, request.vertices);
    else animcache::skin(request, request.palette, settings_.vertex_format, scratch, request.vertices);
    Entry &entry = entries_[request.slot];
    if (request.vertices != entry.vertices) return;
    entry.vertices_key = request.pose;
    entry.vertices_radius = request.blend_radius;
    entry.vertices_level = request.level;
}

void Caches::skin(const base::Jobs &jobs)
{
    key_poses_.make(jobs, scratch_);
    jobs.for_each(slices, [this](uint32_t slice) {
        const Scratch scratch = scratch_.slice(slice);
        for_slice(static_cast<uint32_t>(skin_.size()), slice, [&](uint32_t i) { skin(requests_[skin_[i]], scratch); });
    });
    counters_.skinned = static_cast<uint32_t>(skin_.size()) - counters_.on_demand;
    counters_.cache_bytes = blocks_.used_bytes();
    counters_.cache_pool_bytes = blocks_.reserved_bytes();
    counters_.arena_bytes = arena_.reserved_bytes();
    counters_.key_poses = key_poses_.counters();
}

const math::Affine *Caches::palette_for_spheres(const Request &request, uint32_t slice, uint64_t &products) const
{
    const math::Affine *kept = reinterpret_cast<const math::Affine *>(request.palette);
    if (!kept || request.rigid_mode == RigidMode::vertices) return kept;
    const Scratch scratch = scratch_.slice(slice);
    math::Affine *palette = reinterpret_cast<math::Affine *>(scratch.palette);
    const model::Level &level = request.tmpl->levels[request.level];
    pose::palette_from_locals(request.tmpl->rig, level, kept, scratch.globals, palette);
    products += level.active.empty() ? request.tmpl->rig.node_count() : level.nodes.size();
    return palette;
}

const math::Affine *Caches::locals_of(const Request &request)
{
    if (request.rigid_mode != RigidMode::matrices) return nullptr;
    return reinterpret_cast<const math::Affine *>(request.palette);
}

draw::Pose Caches::pose_of(const Request &request)
{
    if (request.rigid_mode == RigidMode::matrices || !request.palette) return {};
    return {reinterpret_cast<const math::Affine *>(request.palette), morph_weights(request.palette, *request.tmpl)};
}

draw::Vertices Caches::vertices_of(const Request &request) const
{
    const model::Template &tmpl = *request.tmpl;
    if (request.key_pose.mode == KeyPoseMode::intermittent && request.key_pose.served())
        return vertices_in(request.key_pose.kept[0], tmpl, request.level, settings_.vertex_format);
    if (!request.vertices) return {};
    const Entry &entry = entries_[request.slot];
    const float radius = request.vertices == entry.vertices ? entry.vertices_radius : request.blend_radius;
    return vertices_in(request.vertices, tmpl, request.level, settings_.vertex_format, radius);
}

}  // namespace claque::animcache
