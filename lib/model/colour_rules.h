// The rules of colour maps (claque/colours.h), in one place for maps that hosts make and for those that stand in files: which
// one is broken first, where, and in words.
#pragma once

#include <claque/colours.h>

#include <string>

namespace claque::model
{

// Which member of a class, zone or dye a sentence is about.
enum class ColourField { whole, name, tmpl, zone, dyes, uniform, like, apart, hue, saturation, brightness, weight };

struct BrokenColourRule {
    bool broken = false;
    uint32_t colour_class = CLQ_NONE, zone = CLQ_NONE, dye = CLQ_NONE;  // none: about what holds it
    ColourField field = ColourField::whole;
    std::string text;
};

constexpr uint32_t most_colour_classes = 256, most_colour_zones = 255, most_zone_dyes = 64, most_dyes = 4096;

BrokenColourRule first_broken_rule(const clq_colour_map_def &def);

// Index of the zone of this name in a class, or CLQ_NONE.
uint32_t find_zone(const clq_colour_class &colours, const char *name);

}  // namespace claque::model
