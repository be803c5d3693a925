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
    Matter matter;
};

// The first that occurs decides: eyebrows are hair, eyes are not.
constexpr Word words[] = {
    {"brow", Matter::hair},    {"beard", Matter::hair}, {"moustache", Matter::hair}, {"mustache", Matter::hair},
    {"hair", Matter::hair},    {"fur", Matter::hair},   {"lash", Matter::eyes},      {"eye", Matter::eyes},
    {"pupil", Matter::eyes},   {"iris", Matter::eyes},  {"teeth", Matter::teeth},    {"tooth", Matter::teeth},
    {"lips", Matter::lips},    {"mouth", Matter::lips}, {"tongue", Matter::lips},    {"skin", Matter::skin},
    {"face", Matter::skin},    {"flesh", Matter::skin}, {"nail", Matter::skin},      {"metal", Matter::hard},
    {"steel", Matter::hard},   {"iron", Matter::hard},  {"gold", Matter::hard},      {"silver", Matter::hard},
    {"leather", Matter::hard}, {"shoe", Matter::hard},  {"boot", Matter::hard},      {"sandal", Matter::hard},
    {"belt", Matter::hard},    {"wood", Matter::hard},  {"stone", Matter::hard},     {"glass", Matter::hard},
    {"wheel", Matter::hard},   {"hoof", Matter::hard},  {"horn", Matter::hard}};

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
    out.hue_first_deg = on_circle(c.hue_deg - hue_deg);
    out.hue_last_deg = on_circle(c.hue_deg + hue_deg);
    out.saturation_first = unit(c.saturation - saturation);
    out.saturation_last = unit(c.saturation + saturation);
    out.brightness_first = unit(c.brightness - brightness);
    out.brightness_last = unit(c.brightness + brightness);
    return out;
}

// The range, stretched to hold the colour. Both ends of the hues may move; they never pass each other.
HsbRange with(HsbRange range, const Hsb &c)
{
    range.saturation_first = std::min(range.saturation_first, c.saturation);
    range.saturation_last = std::max(range.saturation_last, c.saturation);
    range.brightness_first = std::min(range.brightness_first, c.brightness);
    range.brightness_last = std::max(range.brightness_last, c.brightness);
    const float width = on_circle(range.hue_last_deg - range.hue_first_deg);
    const float above = on_circle(c.hue_deg - range.hue_first_deg);
    if (c.saturation > 0 && above > width) {
        if (above - width < 360 - above) range.hue_last_deg = c.hue_deg;
        else range.hue_first_deg = c.hue_deg;
    }
    return range;
}

// Under a texture that has the colours: a shade of white that leaves them recognisable.
HsbRange tint(Matter matter)
{
    switch (matter) {
        case Matter::skin:
        case Matter::lips:
            return {15, 40, 0, 0.12f, 0.75f, 1};
        case Matter::hair:
            return {15, 45, 0, 0.35f, 0.5f, 1};
        case Matter::eyes:
        case Matter::teeth:
            return {30, 60, 0, 0.04f, 0.92f, 1};
        case Matter::hard:
            return {20, 60, 0, 0.1f, 0.8f, 1};
        case Matter::cloth:
            break;
    }
    return {0, 359, 0, 0.22f, 0.8f, 1};
}

HsbRange of_cloth(const Hsb &c)
{
    // Grey, black and white clothes take on a little colour; coloured ones most others.
    HsbRange out = around(c, 160, 0.15f, 0.2f);
    if (c.saturation < 0.12f) out.saturation_last = std::min(1.0f, c.saturation + 0.3f);
    return out;
}

}  // namespace

Matter matter_of(const std::string &name)
{
    std::string lower;
    for (const char c : name) lower.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    for (const Word &word : words)
        if (lower.find(word.part) != std::string::npos) return word.matter;
    return Matter::cloth;
}

HsbRange default_range(const std::string &name, const std::array<float, 3> &colour, Surface surface)
{
    const Hsb c = hsb_of(colour);
    const Matter matter = matter_of(name);
    const bool white = c.brightness > 0.85f && c.saturation < 0.1f;
    if (surface == Surface::textured && white) return with(tint(matter), c);
    switch (matter) {
        case Matter::skin:
            return around(c, 6, 0.1f, 0.15f);
        case Matter::lips:
            return around(c, 6, 0.1f, 0.1f);
        case Matter::eyes:
        case Matter::teeth:
            return around(c, 8, 0.04f, 0.05f);
        case Matter::hair:
            return with({12, 42, 0.15f, 0.65f, 0.12f, 0.7f}, c);
        case Matter::hard:
            return around(c, 10, 0.1f, 0.12f);
        case Matter::cloth:
            break;
    }
    return of_cloth(c);
}

}  // namespace claque::asset
