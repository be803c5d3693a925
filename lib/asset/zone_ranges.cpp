#include "lib/asset/zone_ranges.h"

#include <algorithm>

#include "lib/asset/hsb_ranges.h"

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
constexpr Word words[] = {{"brow", ZoneKind::hair},     {"beard", ZoneKind::hair},   {"moustache", ZoneKind::hair},
                          {"mustache", ZoneKind::hair}, {"goatee", ZoneKind::hair},  {"scalp", ZoneKind::hair},
                          {"hair", ZoneKind::hair},     {"fur", ZoneKind::hair},     {"lash", ZoneKind::eyes},
                          {"eye", ZoneKind::eyes},      {"pupil", ZoneKind::eyes},   {"iris", ZoneKind::eyes},
                          {"cornea", ZoneKind::eyes},   {"sclera", ZoneKind::eyes},  {"tearline", ZoneKind::eyes},
                          {"teeth", ZoneKind::teeth},   {"tooth", ZoneKind::teeth},  {"tongue", ZoneKind::teeth},
                          {"lips", ZoneKind::lips},     {"mouth", ZoneKind::lips},   {"nail", ZoneKind::lips},
                          {"skin", ZoneKind::skin},     {"face", ZoneKind::skin},    {"flesh", ZoneKind::skin},
                          {"metal", ZoneKind::metal},   {"steel", ZoneKind::metal},  {"iron", ZoneKind::metal},
                          {"brass", ZoneKind::metal},   {"bronze", ZoneKind::metal}, {"chrome", ZoneKind::metal},
                          {"gold", ZoneKind::metal},    {"silver", ZoneKind::metal}, {"glass", ZoneKind::metal},
                          {"leather", ZoneKind::hard},  {"shoe", ZoneKind::hard},    {"boot", ZoneKind::hard},
                          {"footwear", ZoneKind::hard}, {"sandal", ZoneKind::hard},  {"belt", ZoneKind::hard},
                          {"wood", ZoneKind::hard},     {"stone", ZoneKind::hard},   {"wheel", ZoneKind::hard},
                          {"hoof", ZoneKind::hard},     {"horn", ZoneKind::hard}};

// Words that hold one of those and mean another thing.
constexpr const char *others[] = {"brown",    "chair",     "surface", "interface", "facewear", "faceplate",
                                  "facemask", "furniture", "skinny",  "eclipse",   "ellipse",  "environment"};

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
        case ZoneKind::metal:
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

std::string lowered(std::string_view name)
{
    std::string lower;
    for (const char c : name) lower.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    return lower;
}

ZoneKind zone_kind_of(const std::string &name)
{
    std::string lower = lowered(name);
    for (const std::string other : others)
        for (size_t at = 0; (at = lower.find(other)) != std::string::npos;) lower.replace(at, other.size(), " ");
    for (const Word &word : words)
        if (lower.find(word.part) != std::string::npos) return word.zone_kind;
    return ZoneKind::cloth;
}

HsbRange default_range(const std::string &name, const std::array<float, 3> &colour, Texturing texturing)
{
    const Hsb c = hsb_of(colour);
    const ZoneKind zone_kind = zone_kind_of(name);
    const bool white = c.brightness > 0.85f && c.saturation < 0.1f;
    if (texturing == Texturing::textured && white) return including(tint(zone_kind), c);
    switch (zone_kind) {
        case ZoneKind::skin:
            return around(c, 6, 0.1f, 0.15f);
        case ZoneKind::lips:
            return around(c, 6, 0.1f, 0.1f);
        case ZoneKind::eyes:
        case ZoneKind::teeth:
            return around(c, 8, 0.04f, 0.05f);
        case ZoneKind::hair:
            return including({12, 42, 0.15f, 0.65f, 0.12f, 0.7f}, c);
        case ZoneKind::metal:
        case ZoneKind::hard:
            return around(c, 10, 0.1f, 0.12f);
        case ZoneKind::cloth:
            break;
    }
    return of_cloth(c);
}

}  // namespace claque::asset
