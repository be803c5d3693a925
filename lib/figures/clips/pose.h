// A pose while a clip is being made: rotations about the figure's own axes, and two-bone limbs that reach for a point.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "lib/figures/skeleton.h"

namespace claque::figures
{

constexpr float pi = 3.14159265f;

glm::quat turn(glm::vec3 axis, float degrees);
inline glm::quat pitch(float degrees) { return turn({1, 0, 0}, degrees); }  // forwards: a nod, a raised heel
inline glm::quat yaw(float degrees) { return turn({0, 1, 0}, degrees); }    // to the figure's left
inline glm::quat roll(float degrees) { return turn({0, 0, 1}, degrees); }   // raises what is on the left

// The shortest turn of one direction into another; not for opposite ones.
glm::quat shortest_rotation(glm::vec3 from, glm::vec3 to);

// The same turn seen in a mirror: for the right side.
inline glm::quat mirrored(glm::quat q) { return glm::quat(q.w, q.x, -q.y, -q.z); }

// The rotation that carries two directions (not parallel, the first exactly) to two others.
glm::quat rotation_between_frames(glm::vec3 from, glm::vec3 from_second, glm::vec3 to, glm::vec3 to_second);

// On the shorter way from one to another.
glm::quat nlerp(glm::quat from, glm::quat to, float share);

class Pose
{
public:
    Pose();

    glm::quat local(Bone bone) const { return locals_[static_cast<size_t>(bone)]; }
    glm::vec3 shift(Bone bone) const { return shifts_[static_cast<size_t>(bone)]; }
    void set(Bone bone, glm::quat rotation) { locals_[static_cast<size_t>(bone)] = rotation; }
    // Of the left bone; mirrored on the right.
    void set(Side side, Bone left, glm::quat rotation)
    {
        set(on(side, left), side == Side::left ? rotation : mirrored(rotation));
    }
    // Off the place where the joint is in its parent.
    void set_shift(Bone bone, glm::vec3 metres) { shifts_[static_cast<size_t>(bone)] = metres; }
    void shift_pelvis(glm::vec3 metres) { set_shift(Bone::pelvis, metres); }

    glm::quat world(Bone bone) const;
    glm::vec3 joint(Bone bone) const;  // in model space
    void set_world(Bone bone, glm::quat rotation);

    // Puts the joint after `lower` on `target` (or as near as the limb is long) by turning `upper` and `lower`; the
    // joint between them points along `pole`. `flexed` is where it points in the rest pose.
    void reach(Bone upper, Bone lower, Bone end, glm::vec3 target, glm::vec3 pole, glm::vec3 flexed);

private:
    std::array<glm::quat, bone_count> locals_;
    std::array<glm::vec3, bone_count> shifts_;
};

}  // namespace claque::figures
