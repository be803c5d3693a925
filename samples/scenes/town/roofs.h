// Roofs with eaves, a thickness, and a dark underside that is visible from the street.
#pragma once

#include "samples/scenes/town/site.h"

namespace scenes::town
{

// Over walls of half_length along the ridge (which runs along the site) and half_span across it, up to `eaves`.
struct RoofShape {
    double half_length, half_span, eaves, pitch, overhang;
    double ridge() const { return eaves + pitch * half_span; }
};

constexpr double roof_thickness_m = 0.16;

// The tiles, which show from any distance; or the undersides and boards, which show only near.
enum class RoofPart : uint8_t { tiles, edges };

void gable_roof(Geometry &tiles, const Site &site, const RoofShape &shape, RoofPart part, Rgb colour);
void hip_roof(Geometry &tiles, const Site &site, const RoofShape &shape, RoofPart part, Rgb colour);
// The walls under the ends of a gable roof.
void gable_walls(Geometry &facades, const Site &site, const RoofShape &shape, Rgb colour, Bay bay);

}  // namespace scenes::town
