// The pieces of the citizen. Each function adds its piece to the mesh in the rest pose: arms 45 degrees down, palms
// towards the body, thumbs forward. Positions are those of a figure 1.75 m tall.
#pragma once

#include "lib/figures/mesh.h"

namespace claque::figures
{

// The boundary of skin and tunic, left half: in front, its corner, on the shoulder, the corner behind, the nape.
inline const std::array<glm::vec3, 5> neckline = {{{0, 1.424f, 0.086f},
                                                   {0.050f, 1.440f, 0.070f},
                                                   {0.086f, 1.472f, -0.022f},
                                                   {0.052f, 1.458f, -0.098f},
                                                   {0, 1.462f, -0.104f}}};

// Head and neck, hair and ears; open at the neckline, whose points it shares with the tunic.
void add_head(Mesh &mesh);
void add_tunic(Mesh &mesh);           // with sleeves and belt; closed inside, open at the neck
void add_arm(Mesh &mesh, Side side);  // from inside the sleeve to the wrist, and the hand
void add_leg(Mesh &mesh, Side side);  // from inside the skirt to the sole

// Returns the ring of the wrist, to which the arm is joined.
std::vector<uint32_t> add_hand(Mesh &mesh, Side side);

// Joins the foot to the ankle's ring: 8 points, from the back over the figure's right, front and left.
void add_foot(Mesh &mesh, Side side, const std::vector<uint32_t> &ankle);

// A ring of `count` points round `centre`: from -ez towards -ex, ez, ex. Half widths may differ in the four directions.
struct Girth {                              // half widths
    float front, back, along_x, against_x;  // along ez, -ez, ex, -ex
};
std::vector<uint32_t> add_ring(Mesh &mesh, Region region, Side side, int count, glm::vec3 centre, glm::vec3 ex,
                               glm::vec3 ez, Girth girth);

}  // namespace claque::figures
