#include "lib/figures/clips/stance.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/figures/mesh.h"

namespace claque::figures
{

namespace
{

constexpr glm::vec3 heel_point(0.090f, 0, -0.072f);  // contact point of the sole, left foot

// The slope of a thigh in the pelvis: metres ahead and outwards for each metre down.
struct Slope {
    float ahead, out;
};
Slope thigh_slope(const Pose &pose, Side side)
{
    const glm::vec3 d = pose.local(on(side, Bone::thigh)) * glm::vec3(0, -1, 0);
    const float down = std::max(-d.y, 0.25f);
    return {d.z / down, (side == Side::left ? d.x : -d.x) / down};
}

glm::quat lean(glm::vec3 to) { return shortest_rotation(glm::vec3(0, -1, 0), to); }

}  // namespace

void stand_on(Pose &pose, Side side, const Footing &f)
{
    const glm::vec3 rest_ankle = mirrored(skeleton().joint(Bone::foot), side);
    // The heel is raised about the toe joint, so that the toes stay exactly in place.
    const glm::vec3 ball = mirrored(skeleton().joint(Bone::toes), side), heel = mirrored(heel_point, side);
    const glm::vec3 pivot = f.heel_up_deg > 0 ? ball : heel;
    const glm::quat outwards = yaw(side == Side::left ? f.yaw_deg : -f.yaw_deg);
    const glm::quat foot = outwards * pitch(f.heel_up_deg);
    const glm::vec3 centre = rest_ankle * glm::vec3(1, 0, 1);
    const glm::vec3 ankle = centre + outwards * (pivot - centre + pitch(f.heel_up_deg) * (rest_ankle - pivot)) +
                            mirrored(glm::vec3(f.outwards, f.lift, f.ahead), side);
    const glm::vec3 knee = outwards * glm::vec3(side == Side::left ? f.knee_out : -f.knee_out, 0, 1);
    pose.reach(on(side, Bone::thigh), on(side, Bone::shin), on(side, Bone::foot), ankle, knee, glm::vec3(0, 0, 1));
    pose.set_world(on(side, Bone::foot), foot);
    if (f.heel_up_deg > 0) pose.set(on(side, Bone::toes), pitch(-f.heel_up_deg * f.toes_flat));
}

void drape(Pose &pose, float sway_deg)
{
    const Slope left = thigh_slope(pose, Side::left), right = thigh_slope(pose, Side::right);
    for (const Side side : {Side::left, Side::right}) {
        const Slope own = side == Side::left ? left : right, other = side == Side::left ? right : left;
        // Cloth is one piece: each quarter is pulled a little by the other leg.
        const float before = std::max({0.80f * own.ahead, 0.25f * other.ahead, 0.30f * own.ahead});
        const float behind = std::min({0.80f * own.ahead, 0.25f * other.ahead, 0.30f * own.ahead});
        const float out = (side == Side::left ? 1.0f : -1.0f) * std::max(0.0f, 0.7f * own.out);
        pose.set(on(side, Bone::skirt_front), roll(sway_deg) * lean({out, -1, before}));
        pose.set(on(side, Bone::skirt_back), roll(sway_deg) * lean({out, -1, behind}));
    }
}

void hang_arm(Pose &pose, Side side, float forward, float out, float elbow, float inwards)
{
    const glm::vec3 hinge = glm::normalize(glm::cross(glm::vec3(0, 0, -1), arm_direction()));
    pose.set(side, Bone::upper_arm, pitch(-forward) * roll(out - 45) * turn(arm_direction(), inwards));
    pose.set(side, Bone::forearm, turn(hinge, elbow));
}

void curl_hand(Pose &pose, Side side, float curl)
{
    const glm::vec3 axis = -arm_thumbward();  // rotates the fingers towards the palm
    pose.set(side, Bone::fingers, turn(axis, 80 * curl));
    pose.set(side, Bone::fingertips, turn(axis, 122 * curl));
    // The thumb lies across the bent fingers.
    const auto in_hand = [](float along, float across, float up) {
        return arm_direction() * along + arm_thumbward() * across + arm_dorsal() * up;
    };
    const glm::vec3 open = in_hand(0.076f, 0.042f, -0.013f), closed = in_hand(0.066f, -0.024f, -0.036f);
    const float share = curl > 0 ? curl : 0;
    pose.set(side, Bone::thumb, shortest_rotation(open, open * (1 - share) + closed * share));
}

void reach_hand(Pose &pose, Side side, glm::vec3 wrist, glm::vec3 pole)
{
    pose.reach(on(side, Bone::upper_arm), on(side, Bone::forearm), on(side, Bone::hand), mirrored(wrist, side),
               mirrored(pole, side), glm::vec3(0, 0, -1));
}

}  // namespace claque::figures
