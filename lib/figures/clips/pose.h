// A pose under construction: rotations about the figure's own axes, and two-bone limbs that reach for a point.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "lib/figures/skeleton.h"

namespace claque::figures
{

constexpr float pi = 3.14159265f;

glm::quat turn(glm::vec3 axis, float degrees);
inline glm::quat pitch(float degrees) { return turn({1, 0, 0}, degrees); }  // forwards: a nod, a raised heel
inline glm::quat yaw(float degrees) { return turn({0, 1, 0}, degrees); }    // to the figure's left
inline glm::quat roll(float degrees) { return turn({0, 0, 1}, degrees); }   // raises the left side

// The shortest rotation from one direction to another; not defined for opposite ones.
glm::quat shortest_rotation(glm::vec3 from, glm::vec3 to);

// The mirrored rotation, for the right side.
inline glm::quat mirrored(glm::quat q) { return glm::quat(q.w, q.x, -q.y, -q.z); }

// The rotation from two directions to two others (not parallel; the first is mapped exactly).
glm::quat rotation_between_frames(glm::vec3 from, glm::vec3 from_second, glm::vec3 to, glm::vec3 to_second);

// Normalised linear interpolation along the shorter arc.
glm::quat nlerp(glm::quat from, glm::quat to, float share);

class Pose
{
public:
    Pose();

    glm::quat local(Bone bone) const { return locals_[static_cast<size_t>(bone)]; }
    glm::vec3 shift(Bone bone) const { return shifts_[static_cast<size_t>(bone)]; }
    void set(Bone bone, glm::quat rotation) { locals_[static_cast<size_t>(bone)] = rotation; }
    // Sets the rotation of a left bone; mirrored for the right side.
    void set(Side side, Bone left, glm::quat rotation)
    {
        set(on(side, left), side == Side::left ? rotation : mirrored(rotation));
    }
    // Moves a joint away from its rest position in its parent.
    void set_shift(Bone bone, glm::vec3 metres) { shifts_[static_cast<size_t>(bone)] = metres; }
    void shift_pelvis(glm::vec3 metres) { set_shift(Bone::pelvis, metres); }

    glm::quat world(Bone bone) const;
    glm::vec3 joint(Bone bone) const;  // in model space
    void set_world(Bone bone, glm::quat rotation);

    // Rotates `upper` and `lower` so that the joint `end` is at `target`, or as near as the limb's length allows. The
    // joint between them points along `pole`; `flexed` is its direction in the rest pose.
    void reach(Bone upper, Bone lower, Bone end, glm::vec3 target, glm::vec3 pole, glm::vec3 flexed);

private:
    std::array<glm::quat, bone_count> locals_;
    std::array<glm::vec3, bone_count> shifts_;
};

}  // namespace claque::figures
