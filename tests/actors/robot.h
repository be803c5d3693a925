// An actor of rigid boxes for tests: ten nodes, eight degrees of freedom, a clip, and levels of detail in which arms
// and head are merged into the body (S0 3, 5).
#pragma once

#include <memory>

#include "lib/frame/frame.h"
#include "lib/model/model.h"

namespace actors
{

using namespace claque;

// Nodes: body, chest, neck, head, arm and hand on either side, two legs.
enum Node : uint32_t { body, chest, neck, head, arm_left, hand_left, arm_right, hand_right, leg_left, leg_right };
enum Dof : uint32_t {
    chest_yaw,
    neck_yaw,
    neck_pitch,
    head_slide,
    arm_left_lift,
    arm_right_lift,
    leg_left_swing,
    leg_right_swing
};

constexpr float hands_stop_m = 20, limbs_stop_m = 60;  // S0 5.2: hands are deactivated first, then all but the body

model::Model robot_model();
std::unique_ptr<model::Template> make_robot();

// A crowd of robots with its frame and views, as a host has them.
struct World {
    explicit World(const frame::Settings &settings = frame::Settings(), uint64_t seed = 7);

    crowd::Id add(const glm::dvec3 &at, float yaw_rad = 0, uint64_t seed = 1);
    frame::View &look(const glm::dvec3 &eye, const glm::dvec3 &target, float fov_y_rad = 1.0472f,
                      float aspect = 4.0f / 3);
    void update(double time_s);
    uint64_t hash() const;  // of the lists of all views
    frame::ActorVisibility seen(crowd::Id id) const { return frame.visibility(crowd, id.index1 - 1); }

    std::unique_ptr<model::Template> tmpl;
    crowd::Crowd crowd;
    frame::Frame frame;
    std::vector<std::unique_ptr<frame::View>> views;
    std::vector<crowd::Id> ids;
};

// A rotation about the upright axis.
glm::quat turned(float yaw_rad);
// In [0, 1): the k-th number of a random series.
double random_unit(uint64_t series, uint64_t k);

}  // namespace actors
