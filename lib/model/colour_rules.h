// The rules of colour maps (claque/colours.h), for maps from hosts and from files. The check reports the first broken
// rule, its position and a text.
#pragma once

#include <claque/colours.h>

#include <string>

namespace claque::model
{

// The member of a class, zone or palette entry that a message is about.
enum class ColourField {
    whole,
    name,
    tmpl,
    zone,
    palette,
    colour_space,
    linked_to,
    variation,
    hue,
    saturation,
    brightness,
    weight
};

struct BrokenColourRule {
    bool broken = false;
    // The position of the error; CLQ_NONE: in the structure that holds it.
    uint32_t colour_class = CLQ_NONE, zone = CLQ_NONE, palette_entry = CLQ_NONE;
    ColourField field = ColourField::whole;
    std::string text;
};

constexpr uint32_t max_colour_classes = 256, max_colour_zones = 255, max_palette_entries = 64, max_map_entries = 4096;

BrokenColourRule first_broken_rule(const clq_colour_map_def &def);

// Index of the zone of this name in a class, or CLQ_NONE.
uint32_t find_zone(const clq_colour_class &colours, const char *name);

}  // namespace claque::model
