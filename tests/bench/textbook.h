// Posing and skinning as textbooks write them, for comparison: a linear search for the key, the C library's acos and
// sin, 4 x 4 matrices, a loop over influences.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "lib/model/template.h"

namespace claque::bench
{

enum class Blend { one_clip, two_clips, upper_body, inertial };

constexpr float blend_weight = 0.4f;
constexpr float velocity_weight = 0.2f;  // inertial fade: the part of the velocity that continues

// Rotations of the upper half of the bones.
inline float mask_of(uint32_t joint) { return joint % 2 ? 1.0f : 0.0f; }

class TextbookPose
{
public:
    explicit TextbookPose(const model::Rig &rig);

    glm::quat sample(uint32_t clip, uint32_t joint, float time_s) const;
    // All bones of one body; times of the first and of the second clip.
    void pose(Blend blend, float time_s, float other_s, glm::mat4 *palette);

private:
    glm::quat blended(Blend blend, uint32_t joint, float time_s, float other_s) const;

    const model::Rig &rig_;
    std::vector<glm::mat4> globals_, binds_;
};

// out: three numbers per source vertex of positions, then of normals.
void textbook_skin(const model::Level &level, const glm::mat4 *palette, float *out);

}  // namespace claque::bench
