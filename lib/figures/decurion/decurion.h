// The pieces of the decurion: an older, stout town councillor in a tunic and a toga to the shins. The toga's bordered
// fold hangs in front of the thighs, and its roll runs from the right side to the left shoulder.
#pragma once

#include "lib/figures/clips/pose.h"
#include "lib/figures/parts.h"

namespace claque::figures::decurion
{

// The figure's own charts; of pairs the right one is next.
constexpr Chart toga_front = own_chart(0), toga_back = own_chart(1), toga_inside = own_chart(2);
constexpr Chart chest_front = own_chart(3), chest_back = own_chart(4);
constexpr Chart balteus = own_chart(5);  // the roll across the breast, over the left shoulder and down the back
constexpr Chart umbo = own_chart(6);     // the pouch that is pulled out over the roll

// Cloth round the trunk. It extends as far as an arm and must not follow it.
constexpr Region wrap = own_region(0);
// Cloth below the sinus, which divides between the shins in a stride.
constexpr Region skirts = own_region(1);

// The edge of the sinus, the toga's great fold, at each of twelve columns: its height, and its distance from the cloth
// below. Column 0 is in front, 3 at the left side, 6 at the back, where there is no fold.
struct SinusEdge {
    float y, out;
};
constexpr int columns = 12;
inline const std::array<SinusEdge, columns> sinus = {{{0.655f, 0.032f},
                                                      {0.705f, 0.030f},
                                                      {0.790f, 0.028f},
                                                      {0.870f, 0.020f},
                                                      {0.840f, 0.004f},
                                                      {0.800f, 0.000f},
                                                      {0.770f, 0.000f},
                                                      {0.740f, 0.006f},
                                                      {0.715f, 0.018f},
                                                      {0.675f, 0.026f},
                                                      {0.632f, 0.032f},
                                                      {0.628f, 0.034f}}};

void add_aged_head(Mesh &mesh);  // the shared head, aged
void add_toga(Mesh &mesh);       // the cloth from the shins to the shoulders, the visible tunic, and sleeves
void add_balteus(Mesh &mesh);    // with the umbo
void add_limbs(Mesh &mesh);      // arms, and feet without the legs, which are hidden

void keep_clear(Pose &pose);  // moves the arms of a clip's pose out of the stout body and the toga

}  // namespace claque::figures::decurion
