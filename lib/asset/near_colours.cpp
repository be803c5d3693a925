#include "lib/asset/near_colours.h"

#include <algorithm>

#include "lib/asset/hsb_ranges.h"
#include "lib/asset/zone_ranges.h"
#include "lib/asset/zone_roles.h"

namespace claque::asset
{

using model::HsbRange;
using model::none;

namespace
{

// Factors for textures that hold the colours: they cannot become lighter.
constexpr HsbRange skin_tint = {15, 40, 0, 0.1f, 0.8f, 1}, hair_tint = {15, 45, 0, 0.2f, 0.72f, 1},
                   faint_tint = {20, 50, 0, 0.06f, 0.85f, 1}, hard_tint = {20, 60, 0, 0.1f, 0.8f, 1},
                   cloth_tint = {0, 359, 0, 0.15f, 0.75f, 1};

// The part of a range that is human, and the colour itself.
HsbRange within(HsbRange range, const HsbRange &human, const Hsb &c)
{
    range.hue_min_deg = std::max(c.hue_deg - on_circle(c.hue_deg - range.hue_min_deg), human.hue_min_deg);
    range.hue_max_deg = std::min(c.hue_deg + on_circle(range.hue_max_deg - c.hue_deg), human.hue_max_deg);
    range.saturation_min = std::max(range.saturation_min, human.saturation_min);
    range.saturation_max = std::min(range.saturation_max, human.saturation_max);
    range.brightness_min = std::max(range.brightness_min, human.brightness_min);
    range.brightness_max = std::min(range.brightness_max, human.brightness_max);
    return including(range, c);
}

HsbRange hair_near(Hsb c)
{
    const bool grey = is_grey(c);
    if (grey) c.hue_deg = 30;
    HsbRange range = around(c, grey ? 10 : 12, 0.15f, 0.2f);
    range.brightness_max += 0.05f;
    if (grey) range.saturation_max = std::max(c.saturation, 0.2f);
    return within(range, human_hair, c);
}

// Grey stays grey.
HsbRange head_near(const Hsb &c)
{
    HsbRange range = around(c, 8, 0.1f, 0.1f);
    if (is_grey(c)) range.saturation_max = c.saturation;
    return including(range, c);
}

HsbRange cloth_near(const Hsb &c)
{
    if (!is_grey(c)) return around(c, 20, 0.2f, 0.2f);
    HsbRange range = around(c, 0, 0.1f, 0.2f);
    range.hue_min_deg = 0, range.hue_max_deg = 359;
    return range;
}

// The zone's colour is the one that is seen.
HsbRange range_of(Role role, const Hsb &c, bool is_human)
{
    switch (role) {
        case Role::skin:
            return is_human ? within(around(c, 6, 0.1f, 0.15f), human_skin, c) : around(c, 4, 0.05f, 0.05f);
        case Role::hair:
            return is_human ? hair_near(c) : around(c, 8, 0.1f, 0.12f);
        case Role::lips:
            return around(c, 4, 0.06f, 0.06f);
        case Role::figure:
        case Role::head:
            return head_near(c);
        case Role::kept:
            return around(c, 0, 0, 0);
        case Role::hard:
            return around(c, 10, 0.1f, 0.12f);
        case Role::cloth:
            break;
    }
    return cloth_near(c);
}

// The zone's colour multiplies a texture that holds the colours.
HsbRange tint_of(Role role, const Hsb &c, bool is_human)
{
    const HsbRange range = role == Role::kept               ? around(c, 0, 0, 0)
                           : role == Role::cloth            ? cloth_tint
                           : role == Role::hard             ? hard_tint
                           : role == Role::skin && is_human ? skin_tint
                           : role == Role::hair && is_human ? hair_tint
                                                            : faint_tint;
    const bool is_white = c.brightness > 0.85f && is_grey(c);
    if (role == Role::kept || is_white) return including(range, c);
    HsbRange scaled = around(c, 4, 0.05f, 0);
    scaled.brightness_min *= range.brightness_min;
    return scaled;
}

HsbRange near_range(Role role, const model::Zone &zone, const ZoneLook &look)
{
    const Hsb c = hsb_of(zone.colour);
    const std::array<float, 3> mean = look.mean();
    const bool is_human =
        role == Role::hair ? is_human_hair(seen_colour(zone, mean)) : is_human_skin(seen_colour(zone, mean));
    // Grey texels under a colour are light and dark alone.
    const bool colours_itself = !look.patterned || (is_grey(hsb_of(mean)) && !is_grey(c));
    return colours_itself ? range_of(role, c, is_human) : tint_of(role, c, is_human);
}

bool is_fixed(const HsbRange &r)
{
    return r.hue_min_deg == r.hue_max_deg && r.saturation_min == r.saturation_max &&
           r.brightness_min == r.brightness_max;
}

bool takes_part_in_skin(Role role) { return role == Role::skin || role == Role::figure || role == Role::lips; }

// Whether head or hands are of a skin's colour there: sleeves may cover hands, too.
bool shows_skin(const model::Zone &zone, const ZoneLook &look)
{
    for (const Place place : {Place::head, Place::hands})
        if (look.at(place) > 0 && is_human_skin(seen_colour(zone, look.mean(place)))) return true;
    return false;
}

// Materials of one colour that show skin share a zone: the first that is named so. A figure among them decides how far
// it varies.
void join_skins(model::Model &model, const std::vector<ZoneLook> &looks, std::vector<bool> &open,
                std::vector<Role> &roles)
{
    const std::vector<bool> of_materials = material_zones(model);
    const auto joins = [&](size_t z) {
        return open[z] && of_materials[z] && takes_part_in_skin(roles[z]) &&
               (roles[z] != Role::figure || shows_skin(model.zones[z], looks[z]));
    };
    size_t first = none;
    for (const bool named : {true, false})
        for (size_t z = 0; z < roles.size() && first == none; ++z)
            if (joins(z) && roles[z] != Role::lips && (!named || zone_kind_of(model.zones[z].name) == ZoneKind::skin))
                first = z;
    if (first == none) return;
    std::vector<uint32_t> to(roles.size());
    std::vector<model::Zone> zones;
    for (size_t z = 0; z < roles.size(); ++z) {
        const bool joined = z != first && joins(z) && model.zones[z].colour == model.zones[first].colour;
        if (joined && roles[z] == Role::figure) roles[first] = Role::figure;
        to[z] = joined ? none : static_cast<uint32_t>(zones.size());
        if (!joined) zones.push_back(model.zones[z]);
    }
    for (model::Material &material : model.materials)
        if (material.zone != none) material.zone = to[material.zone] == none ? to[first] : to[material.zone];
    for (size_t z = roles.size(); z-- > 0;)
        if (to[z] == none) open.erase(open.begin() + long(z)), roles.erase(roles.begin() + long(z));
    model.zones = std::move(zones);
}

}  // namespace

std::vector<bool> material_zones(const model::Model &model)
{
    std::vector<bool> out(model.zones.size());
    for (const model::Material &material : model.materials)
        if (material.zone != none) out[material.zone] = !is_fixed(model.zones[material.zone].range);  // a lamp's is
    return out;
}

void keep_colour(model::Zone &zone) { zone.range = around(hsb_of(zone.colour), 0, 0, 0); }

void give_ranges(model::Model &model, std::vector<bool> open, Colours colours)
{
    if (colours == Colours::wild) return;
    if (colours == Colours::own) {
        for (size_t z = 0; z < open.size(); ++z)
            if (open[z]) keep_colour(model.zones[z]);
        return;
    }
    if (std::find(open.begin(), open.end(), true) == open.end()) return;
    const std::vector<ZoneLook> apart = looks_of(model);
    std::vector<Role> roles = roles_of(model, apart);
    join_skins(model, apart, open, roles);
    const std::vector<ZoneLook> looks = looks_of(model);
    std::vector<size_t> skins;
    for (size_t z = 0; z < roles.size(); ++z)
        if ((roles[z] == Role::skin || roles[z] == Role::figure) &&
            is_human_skin(seen_colour(model.zones[z], looks[z].mean())))
            skins.push_back(z);
    if (skins.size() > 1)
        for (const size_t z : skins) roles[z] = Role::kept;
    for (size_t z = 0; z < roles.size(); ++z)
        if (open[z]) model.zones[z].range = near_range(roles[z], model.zones[z], looks[z]);
}

}  // namespace claque::asset
