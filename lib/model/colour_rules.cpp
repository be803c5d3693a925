#include "lib/model/colour_rules.h"

#include <cstring>

#include "lib/base/error.h"

namespace claque::model
{

namespace
{

using base::text_of;
using Field = ColourField;

constexpr float heaviest = 1e6f;

bool named(const char *name) { return name && *name; }

// Walks through a map until a rule is broken. Each step is true where all is well.
class Walk
{
public:
    explicit Walk(const clq_colour_map_def &def) : def_(def) {}

    BrokenColourRule go()
    {
        if (!count("classes", def_.class_count, most_colour_classes, def_.classes, 1)) return found_;
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
            if (found_.dye != CLQ_NONE) where += text_of(", dye %u", found_.dye + 1);
            where += ": ";
        }
        found_.text = where + sentence;
        return false;
    }

    bool count(const char *what, uint32_t n, uint32_t most, const void *array, uint32_t least = 0)
    {
        if (n < least || n > most)
            return refuse(Field::whole, text_of("%u %s: %u to %u are wanted", n, what, least, most));
        if (n > 0 && !array) return refuse(Field::whole, text_of("%s is NULL with a count of %u", what, n));
        return true;
    }

    bool walk_class(const clq_colour_class &colours)
    {
        found_.zone = found_.dye = CLQ_NONE;
        if (!named(colours.name)) return refuse(Field::name, "it has no name");
        for (uint32_t i = 0; i < found_.colour_class; ++i)
            if (std::strcmp(def_.classes[i].name, colours.name) == 0)
                return refuse(Field::name, text_of("class %u has this name already", i + 1));
        if (!count("zones", colours.zone_count, most_colour_zones, colours.zones)) return false;
        for (uint32_t i = 0; i < colours.zone_count; ++i) {
            found_.zone = i;
            if (!walk_zone(colours, i)) return false;
        }
        return true;
    }

    bool walk_zone(const clq_colour_class &colours, uint32_t index)
    {
        found_.dye = CLQ_NONE;
        const clq_zone_colours &zone = colours.zones[index];
        if (!named(zone.zone)) return refuse(Field::zone, "it has no name");
        if (find_zone(colours, zone.zone) < index) return refuse(Field::zone, "it stands twice in its class");
        unsigned uniform = 0;  // what C let a host put there
        std::memcpy(&uniform, &zone.uniform, sizeof uniform);
        if (uniform > CLQ_UNIFORM_PERCEIVED)
            return refuse(Field::uniform,
                          text_of("uniform is %u: neither CLQ_UNIFORM_HSB nor CLQ_UNIFORM_PERCEIVED", uniform));
        if (!count("dyes", zone.dye_count, most_zone_dyes, zone.dyes)) return false;
        if (!walk_like(colours, zone)) return false;
        dyes_ += zone.dye_count;
        if (dyes_ > most_dyes) return refuse(Field::dyes, text_of("more than %u dyes in all classes", most_dyes));
        for (uint32_t i = 0; i < zone.dye_count; ++i) {
            found_.dye = i;
            if (!walk_dye(zone.dyes[i])) return false;
        }
        return true;
    }

    bool walk_like(const clq_colour_class &colours, const clq_zone_colours &zone)
    {
        if (!(zone.apart >= 0 && zone.apart <= 1))
            return refuse(Field::apart, text_of("apart is %g: 0 to 1 is wanted", double(zone.apart)));
        if (!zone.like) {
            if (zone.dye_count == 0) return refuse(Field::whole, "it has neither a dye nor a zone that it is like");
            if (zone.apart > 0) return refuse(Field::apart, "it is like no zone that it could be apart from");
            return true;
        }
        if (!named(zone.like)) return refuse(Field::like, "the zone that it is like has no name");
        if (std::strcmp(zone.like, zone.zone) == 0) return refuse(Field::like, "it is like itself");
        const uint32_t leader = find_zone(colours, zone.like);
        if (leader != CLQ_NONE && colours.zones[leader].like)
            return refuse(Field::like, text_of("it is like '%s', which is itself like '%s': name that one", zone.like,
                                               colours.zones[leader].like));
        return true;
    }

    bool walk_dye(const clq_dye &dye)
    {
        const clq_hsb_range &r = dye.range;
        if (!within(Field::hue, "hue", r.hue_first_deg, r.hue_last_deg, 360)) return false;
        if (!within(Field::saturation, "saturation", r.saturation_first, r.saturation_last, 1)) return false;
        if (!within(Field::brightness, "brightness", r.brightness_first, r.brightness_last, 1)) return false;
        if (!(dye.weight > 0 && dye.weight <= heaviest))
            return refuse(Field::weight, text_of("weight is %g: more than 0 and at most %g is wanted",
                                                 double(dye.weight), double(heaviest)));
        return true;
    }

    bool within(Field field, const char *name, float first, float last, float most)
    {
        if (!(first >= 0 && first <= most && last >= 0 && last <= most))
            return refuse(
                field, text_of("%s is %g to %g: 0 to %g is wanted", name, double(first), double(last), double(most)));
        if (field != Field::hue && first > last)
            return refuse(field, text_of("%s is %g to %g, the wrong way round; only hues wrap", name, double(first),
                                         double(last)));
        return true;
    }

    const clq_colour_map_def &def_;
    BrokenColourRule found_;
    uint32_t dyes_ = 0;
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
