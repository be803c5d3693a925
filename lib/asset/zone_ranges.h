// The wide colour ranges of zones whose files give none: of keyed zones, and of all that are asked to be wild
// (near_colours.h keeps the others near their files). S2 5.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "lib/model/model.h"

namespace claque::asset
{

enum class Texturing { untextured, textured };

// What a zone's name says about how far its colour may vary.
enum class ZoneKind { skin, hair, eyes, teeth, lips, metal, hard, cloth };
ZoneKind zone_kind_of(const std::string &name);
std::string lowered(std::string_view name);  // of ASCII letters

// A range that includes `colour` (as for glColor). Skin, lips, eyes and teeth stay near it. Hair takes natural colours.
// Hard materials (metal, leather, wood, stone) vary a little. Everything else takes most hues at about its own
// saturation and brightness. A nearly white colour on a texture means that the texture holds the colours, and gives
// light tints.
model::HsbRange default_range(const std::string &name, const std::array<float, 3> &colour, Texturing texturing);

}  // namespace claque::asset
