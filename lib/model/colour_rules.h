// The rules of colour maps (claque/colours.h), in one place for maps that hosts make and for those that stand in files: which
// one is broken first, where, and in words.
#pragma once

#include <claque/colours.h>

#include <string>

namespace claque::model
{

// Which member of a class, zone or dye a sentence is about.
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
    uint32_t colour_class = CLQ_NONE, zone = CLQ_NONE, palette_entry = CLQ_NONE;  // none: about what holds it
    ColourField field = ColourField::whole;
    std::string text;
};

constexpr uint32_t max_colour_classes = 256, max_colour_zones = 255, max_palette_entries = 64, max_map_entries = 4096;

BrokenColourRule first_broken_rule(const clq_colour_map_def &def);

// Index of the zone of this name in a class, or CLQ_NONE.
uint32_t find_zone(const clq_colour_class &colours, const char *name);

}  // namespace claque::model
