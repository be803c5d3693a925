// The pieces of the owl that carries letters: 1.5 m from tufts to tail, wings 3.1 m across. It has the nodes of the
// herald, with feet as its arms and a tail as its legs.
#pragma once

#include "lib/figures/flyer/wing.h"

namespace claque::figures::flyer::owl
{

constexpr Chart head_chart = own_chart(0), far_head_chart = own_chart(1), eye_chart = own_chart(2),
                lid_chart = own_chart(3), beak_chart = own_chart(4), tuft_chart = own_chart(5),
                ruff_chart = own_chart(6), chest_chart = own_chart(7), belly_chart = own_chart(8),
                collar_chart = own_chart(9), foot_chart = own_chart(10), talon_chart = own_chart(11),
                tail_chart = own_chart(12), wing_back_chart = own_chart(13), wing_front_chart = own_chart(14),
                letter_chart = own_chart(15), far_body_chart = own_chart(16);

const glm::vec3 head_centre(0, 0.460f, 0), eye_left(0.0950f, 0.4800f, 0.0840f), jaw_joint(0, 0.435f, 0.150f);
constexpr float eye_radius = 0.0720f;

void add_head(Mesh &mesh, int level);
void add_far_head(Mesh &mesh, int level);
void add_eye_left(Mesh &mesh, int level);
void add_eye_right(Mesh &mesh, int level);
void add_lids(Mesh &mesh, int level);
void add_beak(Mesh &mesh, int level);   // the lower half
void add_tufts(Mesh &mesh, int level);  // as brows
void add_ruff(Mesh &mesh, int level);
void add_chest(Mesh &mesh, int level);
void add_belly(Mesh &mesh, int level);
void add_tail(Mesh &mesh, int level);
void add_wing_left(Mesh &mesh, int level);
void add_wing_right(Mesh &mesh, int level);
void add_foot_left(Mesh &mesh, int level);
void add_foot_right(Mesh &mesh, int level);  // with the letter
void add_bust(Mesh &mesh, int level);
void add_lower_half(Mesh &mesh, int level);
void add_whole(Mesh &mesh, int level);

Paint paint(const Texel &texel);

}  // namespace claque::figures::flyer::owl
