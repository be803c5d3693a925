// Colour ranges round a colour, in hue, saturation and brightness.
#pragma once

#include <array>

#include "lib/model/model.h"

namespace claque::asset
{

struct Hsb {
    float hue_deg, saturation, brightness;
};
Hsb hsb_of(const std::array<float, 3> &rgb);  // hue 0 for greys

inline bool is_grey(const Hsb &c) { return c.saturation < 0.12f; }  // its hue is hardly seen

float on_circle(float degrees);  // [0, 360)

// From so much below the colour to so much above it; saturation and brightness within [0, 1].
model::HsbRange around(const Hsb &c, float hue_deg, float saturation, float brightness);

// The range, extended to include the colour. Both ends of the hue may move; they never pass each other.
model::HsbRange including(model::HsbRange range, const Hsb &c);

}  // namespace claque::asset
