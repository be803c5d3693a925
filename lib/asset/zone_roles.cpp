#include "lib/asset/zone_roles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "lib/asset/hsb_ranges.h"
#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

using model::none;

namespace
{

// Of the triangles of all heads or hands: less of it is a detail.
constexpr double covering = 0.2;
// Of a zone's own triangles: with so much of it elsewhere a texture of skin may show other things too.
constexpr double mixed = 0.3;
// Of a zone's own triangles: with so much of it there it belongs to the head.
constexpr double on_head = 0.6;
constexpr float most_blond_deg = 50;  // hue of hair
constexpr float alike = 0.12f;        // in each channel

Role role_named(ZoneKind kind)
{
    switch (kind) {
        case ZoneKind::skin:
            return Role::skin;
        case ZoneKind::hair:
            return Role::hair;
        case ZoneKind::lips:
            return Role::lips;
        case ZoneKind::eyes:
        case ZoneKind::teeth:
        case ZoneKind::metal:
            return Role::kept;
        case ZoneKind::hard:
            return Role::hard;
        case ZoneKind::cloth:
            break;
    }
    return Role::cloth;
}

// By the meshes and nodes that show one zone alone; cloth: they differ, or say nothing.
std::vector<Role> roles_of_parts(const model::Model &model)
{
    constexpr uint32_t several = none - 1;
    std::map<uint32_t, uint32_t> zone_of_node;
    const auto zone_of = [&](const model::Part &part) {
        return part.hidden || part.material == none ? none : model.materials[part.material].zone;
    };
    for (const model::Part &part : model.parts) {
        const auto [place, is_new] = zone_of_node.emplace(part.node, zone_of(part));
        if (!is_new && place->second != zone_of(part)) place->second = several;
    }
    std::vector<Role> out(model.zones.size(), Role::cloth);
    std::vector<bool> seen(model.zones.size());
    for (const model::Part &part : model.parts) {
        const uint32_t zone = zone_of(part);
        if (zone == none) continue;
        Role role = Role::cloth;
        if (zone_of_node[part.node] != several) {
            role = role_named(zone_kind_of(part.name));
            if (role == Role::cloth && part.node != none)
                role = role_named(zone_kind_of(std::string(model.rig.node_names[part.node])));
        }
        out[zone] = !seen[zone] || out[zone] == role ? role : Role::cloth;
        seen[zone] = true;
    }
    return out;
}

// Finds roles by colour and place, where no name told them.
class Recogniser
{
public:
    Recogniser(const model::Model &model, const std::vector<ZoneLook> &looks, std::vector<Role> &roles)
        : model_(model), looks_(looks), roles_(roles)
    {
        for (const ZoneLook &look : looks)
            for (size_t p = 0; p < place_count; ++p) triangles_[p] += look.triangles[p];
    }

    void run()
    {
        if (!any_skin(Place::hands)) take_skin(Place::hands);
        if (!any_skin(Place::head) && !any_skin(Place::hands)) take_skin(Place::head);
        const bool placeless = triangles_[0] + triangles_[1] == 0;
        for (size_t z = 0; z < roles_.size(); ++z) {
            if (roles_[z] != Role::cloth) continue;
            const ZoneLook &look = looks_[z];
            const bool bare = covers(z, Place::hands) || covers(z, Place::head);
            if (look.patterned && (bare || is_most(z))) roles_[z] = Role::figure;
            else if (bare && is_like_skin(z)) roles_[z] = Role::skin;
            else if ((bare || (placeless && is_most(z))) && is_grey(hsb_of(model_.zones[z].colour)))
                roles_[z] = Role::head;
            else if (double(look.at(Place::head)) > on_head * double(look.all())) roles_[z] = Role::head;
        }
    }

private:
    bool covers(size_t z, Place place) const
    {
        return looks_[z].at(place) > 0 &&
               double(looks_[z].at(place)) >= covering * double(triangles_[static_cast<size_t>(place)]);
    }

    bool is_most(size_t z) const { return 2 * looks_[z].all() >= triangles_[0] + triangles_[1] + triangles_[2]; }

    bool any_skin(Place place) const
    {
        for (size_t z = 0; z < roles_.size(); ++z)
            if (roles_[z] == Role::skin && covers(z, place)) return true;
        return false;
    }

    // Of the zones without a telling name that cover the place, the one of skin colour that covers most of it.
    void take_skin(Place place)
    {
        size_t best = roles_.size();
        for (size_t z = 0; z < roles_.size(); ++z) {
            if (roles_[z] != Role::cloth || !covers(z, place)) continue;
            if (!is_human_skin(seen_colour(model_.zones[z], looks_[z].mean(place)))) continue;
            if (best == roles_.size() || looks_[z].at(place) > looks_[best].at(place)) best = z;
        }
        if (best == roles_.size()) return;
        const ZoneLook &look = looks_[best];
        const bool elsewhere = double(look.at(Place::elsewhere)) > mixed * double(look.all());
        const bool other = !is_human_skin(seen_colour(model_.zones[best], look.mean(Place::elsewhere)));
        roles_[best] = look.patterned && elsewhere && other ? Role::figure : Role::skin;
    }

    // Whether a zone of skin has about this zone's colour: a face in a material of its own.
    bool is_like_skin(size_t zone) const
    {
        const std::array<float, 3> own = seen_colour(model_.zones[zone], looks_[zone].mean());
        for (size_t z = 0; z < roles_.size(); ++z) {
            if (roles_[z] != Role::skin) continue;
            const std::array<float, 3> other = seen_colour(model_.zones[z], looks_[z].mean());
            float most = 0;
            for (size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(own[k] - other[k]));
            if (most <= alike) return true;
        }
        return false;
    }

    const model::Model &model_;
    const std::vector<ZoneLook> &looks_;
    std::vector<Role> &roles_;
    std::array<size_t, place_count> triangles_{};
};

}  // namespace

std::array<float, 3> seen_colour(const model::Zone &zone, const std::array<float, 3> &mean)
{
    return {zone.colour[0] * mean[0], zone.colour[1] * mean[1], zone.colour[2] * mean[2]};
}

bool is_human_skin(const std::array<float, 3> &rgb)
{
    const Hsb c = hsb_of(rgb);
    return c.hue_deg >= human_skin.hue_min_deg && c.hue_deg <= human_skin.hue_max_deg &&
           c.saturation >= human_skin.saturation_min && c.saturation <= human_skin.saturation_max &&
           c.brightness >= human_skin.brightness_min;
}

bool is_human_hair(const std::array<float, 3> &rgb)
{
    const Hsb c = hsb_of(rgb);
    return is_grey(c) || (c.hue_deg <= most_blond_deg && c.saturation <= human_hair.saturation_max);
}

std::vector<Role> roles_of(const model::Model &model, const std::vector<ZoneLook> &looks)
{
    std::vector<Role> roles = roles_of_parts(model);
    for (size_t z = 0; z < roles.size(); ++z) {
        const ZoneKind kind = zone_kind_of(model.zones[z].name);
        if (kind != ZoneKind::cloth) roles[z] = role_named(kind);
    }
    Recogniser(model, looks, roles).run();
    return roles;
}

}  // namespace claque::asset
