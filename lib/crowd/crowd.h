// The state of a crowd as the host sets it: actors with transforms, plays and colours, one row per individual in
// separate columns (S0 3, S1 1). Folders that only read, such as lib/frame, include this file; edits.h has the calls
// that change it.
#pragma once

#include "lib/base/span.h"
#include "lib/crowd/changes.h"
#include "lib/crowd/tables.h"

namespace claque::crowd
{

struct Crowd {
    explicit Crowd(std::pmr::memory_resource *memory, uint64_t seed = 0) : tables(memory, seed), readers(memory) {}
    Crowd(const Crowd &) = delete;
    Crowd &operator=(const Crowd &) = delete;

    uint64_t seed() const { return tables.seed; }
    std::pmr::memory_resource *memory() const { return tables.actors.all.memory(); }
    uint64_t bytes() const { return bytes_of(tables); }  // held for the individuals
    uint64_t hash() const;                               // of the bytes that save.h writes
    // Changes whenever an actor is made or destroyed or a group's membership changes.
    uint64_t structure_version() const { return structure; }

    // Actors, by row, including free rows.
    uint32_t row_of(Id id) const;  // throws CLQ_STALE_ID
    Id id_of(uint32_t row) const { return tables.actors.all.id_of(row); }
    uint32_t actor_count() const { return tables.actors.all.used_count(); }
    uint32_t row_count() const { return tables.actors.all.size(); }
    uint32_t row_capacity() const { return tables.actors.all.capacity(); }  // grows in steps
    bool alive(uint32_t row) const { return tables.actors.all.in_use(row); }
    const Actor &actor(uint32_t row) const { return tables.actors.all.slot(row); }
    const Transform &transform_of(uint32_t row) const
    {
        return tables.actors.transforms[row];
    }  // in its group's space, if any
    Transform world_transform_of(uint32_t row) const
    {
        const uint32_t of = group_of(row);
        return of == model::none ? transform_of(row) : composed(group(of).transform, transform_of(row));
    }
    const Play &play_of(uint32_t row) const { return tables.actors.plays[row]; }
    const Extent &extent_of(uint32_t row) const { return tables.actors.extents[row]; }
    const math::RoughSphere &bound_of(uint32_t row) const { return tables.actors.bounds[row]; }
    // Rows with events of clips enabled, ascending.
    base::Span<const uint32_t> watched() const { return base::Span<const uint32_t>(tables.actors.watched); }

    // Templates and colours.
    base::Span<const model::Template *const> templates() const
    {
        return base::Span<const model::Template *const>(tables.templates);
    }
    bool has_template(const model::Template &tmpl) const;
    const model::Template &template_of(uint32_t row) const { return *tables.templates[actor(row).tmpl]; }
    const uint8_t *zone_rgb(uint32_t row) const  // 3 per zone, or null: the template's own
    {
        const Actor &of = actor(row);
        return of.colours == model::none ? nullptr : tables.colours[of.tmpl].row(of.colours);
    }
    size_t colour_bytes() const;  // upper bound, of all individuals' own colours

    // Groups, by row, including free rows.
    uint32_t group_row_of(Id id) const;  // throws CLQ_STALE_ID
    Id group_id_of(uint32_t row) const { return tables.groups.all.id_of(row); }
    uint32_t group_count() const { return tables.groups.all.size(); }
    const Group &group(uint32_t row) const { return tables.groups.all.slot(row); }
    uint32_t group_of(uint32_t row) const { return tables.groups.of[row]; }  // of an actor: its group's row, or none

    // Data that only some actors have.
    const Extra *extra_of(uint32_t row) const  // or null
    {
        const uint32_t of = tables.extras.of[row];
        return of == model::none ? nullptr : &tables.extras.all[of];
    }
    size_t hooked_count() const { return tables.extras.all.size(); }  // upper bound of the actors with callbacks
    double (*ground() const)(void *user, const double point[3]) { return ground_height; }
    void *ground_user() const { return ground_data; }

    // Callers add descriptions to these directly.
    Behaviours &behaviours() { return tables.behaviours; }
    const Behaviours &behaviours() const { return tables.behaviours; }
    Layers &layers() { return tables.layers; }
    const Layers &layers() const { return tables.layers; }
    const Follows &follows() const { return tables.follows; }

    Tables tables;
    uint64_t next_version = 1;
    uint64_t structure = 1;
    double (*ground_height)(void *user, const double point[3]) = nullptr;  // the host's; null: none
    void *ground_data = nullptr;
    Array<Changes *> readers;  // of what changes; each unregisters before it ends
};

// The Reference Point in the world at a time: where the host, the group or the track puts it. And its position alone.
Transform reference_of(const Crowd &crowd, uint32_t row, double time_s);
glm::dvec3 reference_position_of(const Crowd &crowd, uint32_t row, double time_s);
// Actors appear and disappear with their track.
inline bool is_present(const Crowd &crowd, uint32_t row, double time_s)
{
    const Follow *follow = crowd.follows().of(row);
    if (!follow) return true;
    const double track_time_s = track_time(*follow, time_s);
    return track::is_present(piece_at(*follow, track_time_s), track_time_s);
}

}  // namespace claque::crowd
