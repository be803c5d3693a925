// The pieces and painters of the plebeian: a lean young working man in an exomis, the tunic that leaves the right
// shoulder and breast bare, girded with a rope above bare knees, his folded cloak slung over the left shoulder.
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

void add_lean_head(Mesh &mesh);  // the shared head, made narrower and younger, with longer hair
void add_exomis(Mesh &mesh);     // trunk and skirt; shares the points of the neck with the head that is there
// Cloth that lies on the thighs: beside them it goes with them, before and behind with the bones of skirts.
BoneWeights weigh_skirt(const Point &point);

void add_cloak(Mesh &mesh);  // a folded band from the rope in front over the left shoulder to the rope behind
void add_bare_leg(Mesh &mesh, Side side);  // from inside the short skirt to the sole, with a knee that bends bare

Paint paint_lean_head(const Texel &texel);  // face with a light beard, neck, ears, and hair by the next
Paint paint_hair(const Texel &texel);
Paint paint_exomis(const Texel &texel);  // trunk, skirt and shoulders: cloth, rope and bare skin
Paint paint_cloak(const Texel &texel);

// The height above which hair grows.
float hair_edge(glm::vec3 p);

}  // namespace plebeian

Paint paint_plebeian(const Texel &texel);

}  // namespace claque::figures
