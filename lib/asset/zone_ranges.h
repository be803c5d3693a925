// From which colours a zone's individuals draw where its file does not say: a policy, and the only place for it. S2 5.
#pragma once

#include <array>
#include <string>

#include "lib/model/model.h"

namespace claque::asset
{

enum class Texturing { untextured, textured };

// What a name says about how far a colour may go.
enum class ZoneKind { skin, hair, eyes, teeth, lips, hard, cloth };
ZoneKind zone_kind_of(const std::string &name);

// A range that holds `colour` (as GL takes it) itself. Skin, lips, eyes and teeth stay near it, hair goes through
// natural colours, hard things (metal, leather, wood, stone) shift a little, everything else takes most hues at about
// its own saturation and brightness. Nearly white under a texture means that the texture has the colours: light tints.
model::HsbRange default_range(const std::string &name, const std::array<float, 3> &colour, Texturing texturing);

}  // namespace claque::asset
