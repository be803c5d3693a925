// The pieces and painters of the patrician: a rich Roman woman in a stola girded under the breast, a palla round hips
// and left shoulder, her hair dressed high. Sizes are those of a figure 1.75 m tall; scenes scale her down.
#pragma once

#include "lib/figures/parts.h"
#include "lib/figures/weights.h"

namespace claque::figures::patrician
{

// The figure's own charts; of pairs the right one is next.
constexpr Chart gown_front = own_chart(0), gown_back = own_chart(1), gown_inside = own_chart(2);
constexpr Chart bodice_front = own_chart(3), bodice_back = own_chart(4);
constexpr Chart palla = own_chart(5), bun = own_chart(6);
constexpr Chart earring = own_chart(7);
static_assert(on(Side::right, earring) == own_chart(8));

// The boundary of skin and stola, as `neckline` of parts.h, but lower and wider.
inline const std::array<glm::vec3, 5> bodice_neckline = {{{0, 1.388f, 0.1040f},
                                                          {0.066f, 1.414f, 0.0860f},
                                                          {0.100f, 1.458f, -0.022f},
                                                          {0.058f, 1.444f, -0.092f},
                                                          {0, 1.440f, -0.0990f}}};

constexpr Region heavy_cloth = own_region(0);  // gown and palla below the waist

constexpr float hand_size = 0.90f, foot_size = 0.90f;  // relative to the citizen's

void add_lady_head(Mesh &mesh);  // the shared head as a woman's, with hair, bun and earrings
void add_stola(Mesh &mesh);      // the gown with the palla's lower part, bodice and sleeves
void add_palla(Mesh &mesh);      // the part over the left shoulder
void add_limbs(Mesh &mesh);      // slender arms, and feet without the legs, which are hidden

BoneWeights weigh_heavy_cloth(const Point &point);

}  // namespace claque::figures::patrician
