#include <algorithm>
#include <functional>

#include "samples/view/designer/designer.h"

namespace view
{
namespace
{

constexpr size_t most_entries = 64;

size_t chosen_index(const Designer &d)
{
    size_t first = d.design.classes.size();
    for (size_t k = d.design.classes.size(); k-- > 0;) {
        const ColourClass &one = *d.design.classes[k];
        if (one.name == d.colour_class && (!one.tmpl || one.tmpl == d.tmpl)) return k;
        if (one.tmpl == d.tmpl) first = k;
    }
    return first;
}

std::string free_name(const Design &design, const std::string &wanted)
{
    const auto taken = [&](const std::string &name) {
        return std::any_of(design.classes.begin(), design.classes.end(),
                           [&](const SharedClass &one) { return one->name == name; });
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number) name = wanted + " " + std::to_string(number);
    return name;
}

ColourClass new_class(const Designer &d)
{
    ColourClass made;
    made.name = free_name(d.design, d.tmpl.empty() ? "people" : d.tmpl + "s");
    made.tmpl = d.tmpl;
    return made;
}

void edit_class(Designer &d, const std::string &by, const std::function<void(ColourClass &)> &edit)
{
    Design next = d.design;
    const size_t at = chosen_index(d);
    ColourClass made = at < next.classes.size() ? *next.classes[at] : new_class(d);
    edit(made);
    const auto shared = std::make_shared<const ColourClass>(std::move(made));
    if (at < next.classes.size()) next.classes[at] = shared;
    else next.classes.push_back(shared);
    d.colour_class = shared->name;
    take_design(d, std::move(next), by);
}

void edit_zone(Designer &d, const clq_hsb_range &own, const std::string &by,
               const std::function<void(ZoneColours &)> &edit)
{
    edit_class(d, by, [&](ColourClass &colours) {
        if (!colours.find(d.zone)) {
            ZoneColours made;
            made.zone = d.zone;
            made.palette.push_back({own, 1});
            colours.zones.push_back(made);
        }
        edit(*colours.find(d.zone));
    });
}

// With a palette of its own: a linked zone gets the one that it shows.
void edit_palette(Designer &d, const clq_hsb_range &own, const std::string &by,
                  const std::function<void(ZoneColours &)> &edit)
{
    const std::vector<clq_palette_entry> palette = palette_of(d, own);
    edit_zone(d, own, by, [&](ZoneColours &zone) {
        if (zone.palette.empty()) zone.palette = palette;
        edit(zone);
    });
}

clq_palette_entry &entry_of(const Designer &d, ZoneColours &zone)
{
    return zone.palette[std::min(d.entry, zone.palette.size() - 1)];
}

}  // namespace

const ColourClass *chosen_class(const Designer &designer)
{
    const size_t at = chosen_index(designer);
    return at < designer.design.classes.size() ? designer.design.classes[at].get() : nullptr;
}

const ZoneColours *chosen_zone(const Designer &designer)
{
    const ColourClass *colours = chosen_class(designer);
    return colours ? colours->find(designer.zone) : nullptr;
}

const std::vector<clq_palette_entry> *shown_palette(const Designer &designer)
{
    const ZoneColours *zone = chosen_zone(designer);
    if (!zone || !zone->palette.empty()) return zone ? &zone->palette : nullptr;
    const ZoneColours *leader = chosen_class(designer)->find(zone->linked_to);
    return leader ? &leader->palette : nullptr;
}

std::vector<clq_palette_entry> palette_of(const Designer &d, const clq_hsb_range &own)
{
    const auto *shown = shown_palette(d);
    return shown ? *shown : std::vector<clq_palette_entry>{{own, 1}};
}

std::vector<std::string> leaders_for(const ColourClass &colours, const std::string &zone)
{
    std::vector<std::string> names;
    for (const ZoneColours &one : colours.zones) {
        if (one.linked_to == zone) return {};  // it leads itself
        if (one.zone != zone && one.linked_to.empty()) names.push_back(one.zone);
    }
    return names;
}

void take_design(Designer &designer, Design next, const std::string &by)
{
    if (next == designer.design) return;
    designer.history.change(designer.design, by);
    designer.design = std::move(next);
}

uint32_t shown_set(const Designer &designer)
{
    const auto worn = designer.sets.find(designer.tmpl);
    return worn == designer.sets.end() ? 0 : worn->second;
}

SharedMap painted_map(const Designer &designer)
{
    for (const SharedMap &map : designer.design.maps)
        if (map->tmpl == designer.tmpl && map->texture_set == shown_set(designer) && map->texture == designer.texture)
            return map;
    return nullptr;
}

void set_zone_map(Designer &designer, SharedMap map, const std::string &by)
{
    Design next = designer.design;
    SharedMap *place = nullptr;
    for (SharedMap &one : next.maps)
        if (one->tmpl == map->tmpl && one->texture_set == map->texture_set && one->texture == map->texture)
            place = &one;
    if (place) *place = std::move(map);
    else next.maps.push_back(std::move(map));
    take_design(designer, std::move(next), by);
}

bool undo(Designer &designer) { return designer.history.undo(designer.design); }
bool redo(Designer &designer) { return designer.history.redo(designer.design); }

void add_class(Designer &designer)
{
    ColourClass made = new_class(designer);
    designer.colour_class = made.name;
    Design next = designer.design;
    next.classes.push_back(std::make_shared<const ColourClass>(std::move(made)));
    take_design(designer, std::move(next), "");
}

void remove_class(Designer &designer)
{
    Design next = designer.design;
    const size_t at = chosen_index(designer);
    if (at < next.classes.size()) next.classes.erase(next.classes.begin() + static_cast<std::ptrdiff_t>(at));
    take_design(designer, std::move(next), "");
}

void name_class(Designer &designer, const std::string &name)
{
    const ColourClass *now = chosen_class(designer);
    if (!now || name.empty() || free_name(designer.design, name) != name) return;
    edit_class(designer, "class name", [&](ColourClass &colours) { colours.name = name; });
}

void set_range(Designer &designer, const clq_hsb_range &own, const clq_hsb_range &range, const std::string &by)
{
    edit_palette(designer, own, by, [&](ZoneColours &zone) { entry_of(designer, zone).range = range; });
}

void set_weight(Designer &designer, const clq_hsb_range &own, float weight, const std::string &by)
{
    edit_palette(designer, own, by, [&](ZoneColours &zone) { entry_of(designer, zone).weight = weight; });
}

void set_space(Designer &designer, const clq_hsb_range &own, clq_colour_space space)
{
    edit_palette(designer, own, "", [&](ZoneColours &zone) { zone.space = space; });
}

void add_entry(Designer &designer, const clq_hsb_range &own)
{
    edit_palette(designer, own, "", [&](ZoneColours &zone) {
        if (zone.palette.size() >= most_entries) return;
        zone.palette.push_back({entry_of(designer, zone).range, 1});
        designer.entry = zone.palette.size() - 1;
    });
}

void remove_entry(Designer &designer)
{
    const ZoneColours *zone = chosen_zone(designer);
    if (!zone || zone->palette.size() < 2) return;
    edit_zone(designer, {}, "", [&](ZoneColours &edited) {
        const size_t at = std::min(designer.entry, edited.palette.size() - 1);
        edited.palette.erase(edited.palette.begin() + static_cast<std::ptrdiff_t>(at));
        designer.entry = std::min(at, edited.palette.size() - 1);
    });
}

void link_zone(Designer &designer, const clq_hsb_range &own, const std::string &leader)
{
    const std::vector<clq_palette_entry> palette = palette_of(designer, own);
    const ColourClass *colours = chosen_class(designer);
    const ZoneColours *led = chosen_zone(designer), *from = led && colours ? colours->find(led->linked_to) : nullptr;
    const clq_colour_space space = from && led->palette.empty() ? from->space : led ? led->space : CLQ_COLOUR_SPACE_HSB;
    edit_zone(designer, own, "", [&](ZoneColours &zone) {
        zone.linked_to = leader;
        zone.palette = leader.empty() ? palette : std::vector<clq_palette_entry>();
        zone.space = leader.empty() ? space : CLQ_COLOUR_SPACE_HSB;
        if (leader.empty()) zone.variation = 0;
    });
    designer.entry = 0;
}

void set_variation(Designer &designer, float variation, const std::string &by)
{
    const ZoneColours *zone = chosen_zone(designer);
    if (!zone || zone->linked_to.empty()) return;
    edit_zone(designer, {}, by, [&](ZoneColours &edited) { edited.variation = variation; });
}

void forget_zone(Designer &designer)
{
    const ZoneColours *zone = chosen_zone(designer);
    if (!zone) return;
    const ZoneColours gone = *zone;
    edit_class(designer, "", [&](ColourClass &colours) {
        for (ZoneColours &one : colours.zones) {
            if (one.linked_to != gone.zone) continue;
            one.linked_to.clear();
            one.variation = 0;
            if (!one.palette.empty()) continue;
            one.palette = gone.palette;
            one.space = gone.space;
        }
        colours.zones.erase(std::find_if(colours.zones.begin(), colours.zones.end(),
                                         [&](const ZoneColours &one) { return one.zone == gone.zone; }));
    });
    designer.entry = 0;
}

}  // namespace view
