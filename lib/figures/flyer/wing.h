// Wings: an arm of short feathers, and behind it the long ones, whose tips form the outline. Arched along the span,
// thick along the leading edge, thin at the tips. Given for the left wing; the right one is its mirror image.
#pragma once

#include "lib/figures/flyer/shapes.h"

namespace claque::figures::flyer
{

struct Wing {
    glm::vec3 root;
    glm::vec2 scale;  // of a wing with a span of 1.7 m and feathers of up to 0.9 m
    Chart back, front;
};

// Four levels.
void add_wing(Mesh &mesh, const Wing &wing, Side side, int level);

// Three rows of coverts like tiles, then the long feathers with their shafts, darker in `bands` stripes, the last one
// at the tips.
struct Plumage {
    int bands = 1;
    Zone shoulder = Zone::border, feathers = Zone::wings;
};
Paint paint_wing(const Texel &texel, const Plumage &plumage);

}  // namespace claque::figures::flyer
