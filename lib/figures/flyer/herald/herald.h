// The pieces of the herald: a winged youth in a pleated tunic with a trumpet and a scroll, 1.6 m from crown to toes,
// with wings 3.5 m across. Each function adds one level of one piece.
#pragma once

#include "lib/figures/flyer/shapes.h"

namespace claque::figures::flyer::herald
{

constexpr Chart head_chart = own_chart(0), far_head_chart = own_chart(1), eye_chart = own_chart(2),
                lid_chart = own_chart(3), jaw_chart = own_chart(4), mouth_chart = own_chart(5),
                brow_chart = own_chart(6), neck_chart = own_chart(7), chest_chart = own_chart(8),
                collar_chart = own_chart(9), skirt_chart = own_chart(10), lining_chart = own_chart(11),
                wing_back_chart = own_chart(12), wing_front_chart = own_chart(13), sleeve_chart = own_chart(14),
                arm_chart = own_chart(15), trumpet_chart = own_chart(16), scroll_chart = own_chart(17),
                leg_chart = own_chart(18), talaria_chart = own_chart(19), wreath_chart = own_chart(20),
                far_limb_chart = own_chart(21);

const glm::vec3 head_centre(0, 0.675f, 0), eye_left(0.0385f, 0.6930f, 0.0575f), jaw_joint(0, 0.625f, 0.010f);
constexpr float eye_radius = 0.0270f;

// The height of the hairline over the head's centre, by the angle from straight ahead.
float hairline(float angle);
// Converts a chart's s, 0 in front to 1 behind, to an angle, and back.
float angle_of(float s);
float s_of(float angle);

void add_head(Mesh &mesh, int level);
void add_far_head(Mesh &mesh, int level);
void add_eye_left(Mesh &mesh, int level);
void add_eye_right(Mesh &mesh, int level);
void add_lids(Mesh &mesh, int level);
void add_jaw(Mesh &mesh, int level);
void add_brow(Mesh &mesh, int level);
void add_neck(Mesh &mesh, int level);
void add_chest(Mesh &mesh, int level);
void add_skirt(Mesh &mesh, int level);
void add_wing_left(Mesh &mesh, int level);
void add_wing_right(Mesh &mesh, int level);
void add_arm_left(Mesh &mesh, int level);
void add_arm_right(Mesh &mesh, int level);
void add_legs(Mesh &mesh, int level);
void add_far_trumpet(Mesh &mesh);
// Levels that include deactivated pieces: from the distance where limbs are deactivated, chest with head and arms, and
// hips with legs; finally everything.
void add_bust(Mesh &mesh, int level);
void add_lower_half(Mesh &mesh, int level);
void add_whole(Mesh &mesh, int level);

Paint paint(const Texel &texel);

// The surface of the head at an angle and a height over its centre.
enum class Sculpt : uint8_t {
    near,  // with sockets for the eyes and a hollow for the jaw
    jaw,   // fills that hollow
    far    // smooth, for faces that are only painted
};
glm::vec3 on_head(float angle, float height, Sculpt sculpt);

}  // namespace claque::figures::flyer::herald
