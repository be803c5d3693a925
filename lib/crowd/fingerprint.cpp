#include "lib/base/hash.h"
#include "lib/crowd/crowd.h"

namespace claque::crowd
{

namespace
{

// Field by field: padding between fields may hold anything.
template <class T>
uint64_t add(uint64_t h, const T &value)
{
    return base::fnv(h, &value, sizeof value);
}

}  // namespace

uint64_t Crowd::fingerprint() const
{
    uint64_t h = base::fnv_start;
    h = add(add(add(add(h, seed_), next_version_), alive_), first_free_);
    for (const model::Template *tmpl : templates_) {
        h = base::fnv(h, tmpl->name.data(), tmpl->name.size() + 1);
        h = add(add(h, tmpl->zone_count()), tmpl->rig.node_count());
    }
    for (const Group &group : groups_) {
        h = add(add(add(add(h, group.generation), group.members), group.enabled), group.place.scale);
        for (int k = 0; k < 3; ++k) h = add(h, group.place.position[k]);
        for (int k = 0; k < 4; ++k) h = add(h, group.place.orientation[k]);
    }
    for (uint32_t row = 0; row < row_count(); ++row) {
        const Actor &a = actors_[row];
        const Place &p = places_[row];
        const Play &c = plays_[row];
        h = add(add(add(add(h, a.tmpl), a.generation), a.seed), a.play_version);
        for (int k = 0; k < 3; ++k) h = add(h, p.position[k]);
        for (int k = 0; k < 4; ++k) h = add(h, p.orientation[k]);
        h = add(h, groups_of_[row]);
        h = add(add(add(add(add(h, p.scale), c.clip), c.start_s), c.speed), c.phase_s);
        const uint8_t *rgb = zone_rgb(row);
        h = add(h, rgb != nullptr);
        if (rgb) h = base::fnv(h, rgb, colours_[a.tmpl].stride());
    }
    return h;
}

}  // namespace claque::crowd
