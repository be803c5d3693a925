#include "lib/asset/zone_ranges.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

using model::HsbRange;

namespace
{

struct Word {
    const char *part;
    ZoneKind zone_kind;
};

// The first word that occurs in the name decides: eyebrows are hair, not eyes.
constexpr Word words[] = {
    {"brow", ZoneKind::hair},    {"beard", ZoneKind::hair}, {"moustache", ZoneKind::hair}, {"mustache", ZoneKind::hair},
    {"hair", ZoneKind::hair},    {"fur", ZoneKind::hair},   {"lash", ZoneKind::eyes},      {"eye", ZoneKind::eyes},
    {"pupil", ZoneKind::eyes},   {"iris", ZoneKind::eyes},  {"teeth", ZoneKind::teeth},    {"tooth", ZoneKind::teeth},
    {"lips", ZoneKind::lips},    {"mouth", ZoneKind::lips}, {"tongue", ZoneKind::lips},    {"skin", ZoneKind::skin},
    {"face", ZoneKind::skin},    {"flesh", ZoneKind::skin}, {"nail", ZoneKind::skin},      {"metal", ZoneKind::hard},
    {"steel", ZoneKind::hard},   {"iron", ZoneKind::hard},  {"gold", ZoneKind::hard},      {"silver", ZoneKind::hard},
    {"leather", ZoneKind::hard}, {"shoe", ZoneKind::hard},  {"boot", ZoneKind::hard},      {"sandal", ZoneKind::hard},
    {"belt", ZoneKind::hard},    {"wood", ZoneKind::hard},  {"stone", ZoneKind::hard},     {"glass", ZoneKind::hard},
    {"wheel", ZoneKind::hard},   {"hoof", ZoneKind::hard},  {"horn", ZoneKind::hard}};

struct Hsb {
    float hue_deg, saturation, brightness;
};

Hsb hsb_of(const std::array<float, 3> &c)
{
    const float high = std::max({c[0], c[1], c[2]}), low = std::min({c[0], c[1], c[2]}), span = high - low;
    Hsb out{0, high > 0 ? span / high : 0, high};
    if (span > 0) {
        const float sixth = high == c[0]   ? (c[1] - c[2]) / span
                            : high == c[1] ? (c[2] - c[0]) / span + 2
                                           : (c[0] - c[1]) / span + 4;
        out.hue_deg = 60 * (sixth < 0 ? sixth + 6 : sixth);
    }
    return out;
}

float on_circle(float degrees) { return degrees - 360 * std::floor(degrees / 360); }

HsbRange around(const Hsb &c, float hue_deg, float saturation, float brightness)
{
    const auto unit = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    HsbRange out;
    out.hue_min_deg = on_circle(c.hue_deg - hue_deg);
    out.hue_max_deg = on_circle(c.hue_deg + hue_deg);
    out.saturation_min = unit(c.saturation - saturation);
    out.saturation_max = unit(c.saturation + saturation);
    out.brightness_min = unit(c.brightness - brightness);
    out.brightness_max = unit(c.brightness + brightness);
    return out;
}

// The range, extended to include the colour. Both ends of the hue may move; they never pass each other.
HsbRange with(HsbRange range, const Hsb &c)
{
    range.saturation_min = std::min(range.saturation_min, c.saturation);
    range.saturation_max = std::max(range.saturation_max, c.saturation);
    range.brightness_min = std::min(range.brightness_min, c.brightness);
    range.brightness_max = std::max(range.brightness_max, c.brightness);
    const float width = on_circle(range.hue_max_deg - range.hue_min_deg);
    const float above = on_circle(c.hue_deg - range.hue_min_deg);
    if (c.saturation > 0 && above > width) {
        if (above - width < 360 - above) range.hue_max_deg = c.hue_deg;
        else range.hue_min_deg = c.hue_deg;
    }
    return range;
}

// For textures that hold the colours: shades of white that keep them recognisable.
HsbRange tint(ZoneKind zone_kind)
{
    switch (zone_kind) {
        case ZoneKind::skin:
        case ZoneKind::lips:
            return {15, 40, 0, 0.12f, 0.75f, 1};
        case ZoneKind::hair:
            return {15, 45, 0, 0.35f, 0.5f, 1};
        case ZoneKind::eyes:
        case ZoneKind::teeth:
            return {30, 60, 0, 0.04f, 0.92f, 1};
        case ZoneKind::hard:
            return {20, 60, 0, 0.1f, 0.8f, 1};
        case ZoneKind::cloth:
            break;
    }
    return {0, 359, 0, 0.22f, 0.8f, 1};
}

HsbRange of_cloth(const Hsb &c)
{
    // Grey, black and white clothes take a little colour; coloured clothes take most hues.
    HsbRange out = around(c, 160, 0.15f, 0.2f);
    if (c.saturation < 0.12f) out.saturation_max = std::min(1.0f, c.saturation + 0.3f);
    return out;
}

}  // namespace

ZoneKind zone_kind_of(const std::string &name)
{
    std::string lower;
    for (const char c : name) lower.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    for (const Word &word : words)
        if (lower.find(word.part) != std::string::npos) return word.zone_kind;
    return ZoneKind::cloth;
}

HsbRange default_range(const std::string &name, const std::array<float, 3> &colour, Texturing texturing)
{
    const Hsb c = hsb_of(colour);
    const ZoneKind zone_kind = zone_kind_of(name);
    const bool white = c.brightness > 0.85f && c.saturation < 0.1f;
    if (texturing == Texturing::textured && white) return with(tint(zone_kind), c);
    switch (zone_kind) {
        case ZoneKind::skin:
            return around(c, 6, 0.1f, 0.15f);
        case ZoneKind::lips:
            return around(c, 6, 0.1f, 0.1f);
        case ZoneKind::eyes:
        case ZoneKind::teeth:
            return around(c, 8, 0.04f, 0.05f);
        case ZoneKind::hair:
            return with({12, 42, 0.15f, 0.65f, 0.12f, 0.7f}, c);
        case ZoneKind::hard:
            return around(c, 10, 0.1f, 0.12f);
        case ZoneKind::cloth:
            break;
    }
    return of_cloth(c);
}

}  // namespace claque::asset
