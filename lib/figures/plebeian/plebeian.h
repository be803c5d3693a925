// The pieces and painters of the plebeian: a lean young working man in an exomis, the tunic that leaves the right
// shoulder and breast bare, girded with a rope above bare knees, with a folded cloak over the left shoulder.
#pragma once

#include "lib/figures/painters.h"
#include "lib/figures/parts.h"
#include "lib/figures/weights.h"

namespace claque::figures
{

namespace plebeian
{

constexpr Chart cloak = own_chart(0);
constexpr Region short_skirt = own_region(0);

void add_lean_head(Mesh &mesh);  // the shared head made narrower and younger, with longer hair
void add_exomis(Mesh &mesh);     // trunk and skirt; shares the neck's points with the existing head
// Cloth on the thighs: at their sides it follows the thighs, in front and behind the bones of skirts.
BoneWeights weigh_skirt(const Point &point);

void add_cloak(Mesh &mesh);  // a folded band from the rope in front over the left shoulder to the rope behind
// From inside the short skirt to the sole, with a bare knee that bends.
void add_bare_leg(Mesh &mesh, Side side);

Paint paint_lean_head(const Texel &texel);  // face with a light beard, neck and ears; hair by paint_hair
Paint paint_hair(const Texel &texel);
Paint paint_exomis(const Texel &texel);  // trunk, skirt and shoulders: cloth, rope and bare skin
Paint paint_cloak(const Texel &texel);

// The height above which hair grows.
float hair_edge(glm::vec3 p);

}  // namespace plebeian

Paint paint_plebeian(const Texel &texel);

}  // namespace claque::figures
