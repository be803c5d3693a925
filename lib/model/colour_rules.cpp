#include "lib/model/colour_rules.h"

#include <cstring>

#include "lib/base/error.h"

namespace claque::model
{

namespace
{

using base::text_of;
using Field = ColourField;

constexpr float max_weight = 1e6f;

bool named(const char *name) { return name && *name; }

// Checks a map up to the first broken rule. Each step returns true if its rule holds.
class Walk
{
public:
    explicit Walk(const clq_colour_map_def &def) : def_(def) {}

    BrokenColourRule go()
    {
        if (!count("classes", def_.class_count, max_colour_classes, def_.classes, 1)) return found_;
        for (uint32_t i = 0; i < def_.class_count; ++i) {
            found_.colour_class = i;
            if (!walk_class(def_.classes[i])) return found_;
        }
        return {};
    }

private:
    bool refuse(Field field, const std::string &sentence)
    {
        found_.broken = true;
        found_.field = field;
        std::string where;
        if (found_.colour_class != CLQ_NONE) {
            const clq_colour_class &colours = def_.classes[found_.colour_class];
            where = named(colours.name) ? text_of("class '%s'", colours.name)
                                        : text_of("class %u", found_.colour_class + 1);
            if (found_.zone != CLQ_NONE && named(colours.zones[found_.zone].zone))
                where += text_of(", zone '%s'", colours.zones[found_.zone].zone);
            else if (found_.zone != CLQ_NONE) where += text_of(", zone %u", found_.zone + 1);
            if (found_.palette_entry != CLQ_NONE) where += text_of(", palette entry %u", found_.palette_entry + 1);
            where += ": ";
        }
        found_.text = where + sentence;
        return false;
    }

    bool count(const char *what, uint32_t n, uint32_t maximum, const void *array, uint32_t minimum = 0)
    {
        if (n < minimum || n > maximum)
            return refuse(Field::whole, text_of("%u %s: %u to %u are wanted", n, what, minimum, maximum));
        if (n > 0 && !array) return refuse(Field::whole, text_of("%s is NULL with a count of %u", what, n));
        return true;
    }

    bool walk_class(const clq_colour_class &colours)
    {
        found_.zone = found_.palette_entry = CLQ_NONE;
        if (!named(colours.name)) return refuse(Field::name, "it has no name");
        for (uint32_t i = 0; i < found_.colour_class; ++i)
            if (std::strcmp(def_.classes[i].name, colours.name) == 0)
                return refuse(Field::name, text_of("class %u has this name already", i + 1));
        if (!count("zones", colours.zone_count, max_colour_zones, colours.zones)) return false;
        for (uint32_t i = 0; i < colours.zone_count; ++i) {
            found_.zone = i;
            if (!walk_zone(colours, i)) return false;
        }
        return true;
    }

    bool walk_zone(const clq_colour_class &colours, uint32_t index)
    {
        found_.palette_entry = CLQ_NONE;
        const clq_zone_colours &zone = colours.zones[index];
        if (!named(zone.zone)) return refuse(Field::zone, "it has no name");
        if (find_zone(colours, zone.zone) < index) return refuse(Field::zone, "it stands twice in its class");
        unsigned colour_space = 0;  // a C host may store any value in the enum
        std::memcpy(&colour_space, &zone.colour_space, sizeof colour_space);
        if (colour_space > CLQ_COLOUR_SPACE_OKLAB)
            return refuse(
                Field::colour_space,
                text_of("colour_space is %u: neither CLQ_COLOUR_SPACE_HSB nor CLQ_COLOUR_SPACE_OKLAB", colour_space));
        if (!count("palette entries", zone.palette_count, max_palette_entries, zone.palette)) return false;
        if (!walk_link(colours, zone)) return false;
        palette_entries_ += zone.palette_count;
        if (palette_entries_ > max_map_entries)
            return refuse(Field::palette, text_of("more than %u palette entries in all classes", max_map_entries));
        for (uint32_t i = 0; i < zone.palette_count; ++i) {
            found_.palette_entry = i;
            if (!walk_palette_entry(zone.palette[i])) return false;
        }
        return true;
    }

    bool walk_link(const clq_colour_class &colours, const clq_zone_colours &zone)
    {
        if (!(zone.variation >= 0 && zone.variation <= 1))
            return refuse(Field::variation, text_of("variation is %g: 0 to 1 is wanted", double(zone.variation)));
        if (!zone.linked_to) {
            if (zone.palette_count == 0)
                return refuse(Field::whole, "it has neither a palette entry nor a zone that it is linked to");
            if (zone.variation > 0) return refuse(Field::variation, "it has a variation and is linked to no zone");
            return true;
        }
        if (!named(zone.linked_to)) return refuse(Field::linked_to, "the zone that it is linked to has no name");
        if (std::strcmp(zone.linked_to, zone.zone) == 0) return refuse(Field::linked_to, "it is linked to itself");
        const uint32_t leader = find_zone(colours, zone.linked_to);
        if (leader != CLQ_NONE && colours.zones[leader].linked_to)
            return refuse(Field::linked_to,
                          text_of("it is linked to '%s', which is itself linked to '%s': name that one", zone.linked_to,
                                  colours.zones[leader].linked_to));
        return true;
    }

    bool walk_palette_entry(const clq_palette_entry &palette_entry)
    {
        const clq_hsb_range &r = palette_entry.range;
        if (!within(Field::hue, "hue", r.hue_min_deg, r.hue_max_deg, 360)) return false;
        if (!within(Field::saturation, "saturation", r.saturation_min, r.saturation_max, 1)) return false;
        if (!within(Field::brightness, "brightness", r.brightness_min, r.brightness_max, 1)) return false;
        if (!(palette_entry.weight > 0 && palette_entry.weight <= max_weight))
            return refuse(Field::weight, text_of("weight is %g: more than 0 and at most %g is wanted",
                                                 double(palette_entry.weight), double(max_weight)));
        return true;
    }

    bool within(Field field, const char *name, float first, float last, float maximum)
    {
        if (!(first >= 0 && first <= maximum && last >= 0 && last <= maximum))
            return refuse(field, text_of("%s is %g to %g: 0 to %g is wanted", name, double(first), double(last),
                                         double(maximum)));
        if (field != Field::hue && first > last)
            return refuse(field, text_of("%s is %g to %g, the wrong way round; only hues wrap", name, double(first),
                                         double(last)));
        return true;
    }

    const clq_colour_map_def &def_;
    BrokenColourRule found_;
    uint32_t palette_entries_ = 0;
};

}  // namespace

BrokenColourRule first_broken_rule(const clq_colour_map_def &def) { return Walk(def).go(); }

uint32_t find_zone(const clq_colour_class &colours, const char *name)
{
    for (uint32_t i = 0; i < colours.zone_count; ++i)
        if (colours.zones[i].zone && std::strcmp(colours.zones[i].zone, name) == 0) return i;
    return CLQ_NONE;
}

}  // namespace claque::model
