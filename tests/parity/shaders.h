// S2's shaders (2.2, 2.5) in GLSL 1.20, lit per vertex: a matrix palette of up to eight influences and one lookup in
// the colour atlas.
#pragma once

#include <string>

#include "tests/parity/scene_in.h"

namespace parity_test
{

enum class What { colour, actor, zone, vertices };

// Where light times the zone's colour is limited to 1 (docs/parity.md): at vertices by knots, at vertices of one zone
// at a time, or at pixels, which is not what OpenGL 1.1 does.
enum class Limiting { knots, zones, pixels };

// Options of a compiled program.
struct Variant {
    What what = What::colour;
    size_t joints = 1, sets = 1;  // sets of four influences
    bool normals_by_inverse = false, double_sided = false, holes = false;
    Limiting limiting = Limiting::knots;
    bool unlit = false;
    int subpixel_bits = 0;  // to which the vertex shader rounds positions in the picture; 0: it does not
    bool operator<(const Variant &o) const;
};

enum Attribute {
    at_position,
    at_normal,
    at_uv,
    at_colour,
    at_joints,
    at_weights = at_joints + 2,
    attribute_count = at_weights + 2
};
extern const char *const attribute_names[attribute_count];

std::string vertex_shader(const Variant &variant, const Lighting &lighting);
std::string fragment_shader(const Variant &variant, const Lighting &lighting, const Fog &fog);

// The most light that any vertex can get in any channel.
double most_light(const Lighting &lighting);

// Knots where they lie closely enough, else zones.
Limiting limiting_for(const Lighting &lighting);

}  // namespace parity_test
