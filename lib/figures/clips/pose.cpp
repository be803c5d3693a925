#include "lib/figures/clips/pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "lib/math/trig.h"

namespace claque::figures
{

glm::quat turn(glm::vec3 axis, float degrees)
{
    const float half = degrees * pi / 360;
    const glm::vec3 v = glm::normalize(axis) * math::sin(half);
    return glm::quat(math::cos(half), v.x, v.y, v.z);
}

glm::quat shortest_rotation(glm::vec3 from, glm::vec3 to)
{
    const glm::vec3 a = glm::normalize(from), b = glm::normalize(to), axis = glm::cross(a, b);
    return glm::normalize(glm::quat(1 + glm::dot(a, b), axis.x, axis.y, axis.z));
}

glm::quat rotation_between_frames(glm::vec3 from, glm::vec3 from_second, glm::vec3 to, glm::vec3 to_second)
{
    const auto frame = [](glm::vec3 first, glm::vec3 second) {
        const glm::vec3 a = glm::normalize(first);
        const glm::vec3 c = glm::normalize(glm::cross(a, second));
        return glm::mat3(a, glm::cross(c, a), c);
    };
    return glm::normalize(glm::quat_cast(frame(to, to_second) * glm::transpose(frame(from, from_second))));
}

glm::quat nlerp(glm::quat from, glm::quat to, float share)
{
    if (glm::dot(from, to) < 0) to = -to;
    return glm::normalize(from * (1 - share) + to * share);
}

Pose::Pose()
{
    locals_.fill(glm::quat(1, 0, 0, 0));
    shifts_.fill(glm::vec3(0));
}

glm::quat Pose::world(Bone bone) const
{
    glm::quat q = local(bone);
    for (int p = skeleton().parents[static_cast<size_t>(bone)]; p >= 0; p = skeleton().parents[static_cast<size_t>(p)])
        q = locals_[static_cast<size_t>(p)] * q;
    return q;
}

glm::vec3 Pose::joint(Bone bone) const
{
    glm::vec3 p(0);
    for (int b = index_of(bone); b >= 0; b = skeleton().parents[static_cast<size_t>(b)]) {
        const Bone at = static_cast<Bone>(b);
        if (at != bone) p = local(at) * p;
        p += skeleton().offset(at) + shift(at);
    }
    return p;
}

void Pose::set_world(Bone bone, glm::quat rotation)
{
    const int parent = skeleton().parents[static_cast<size_t>(bone)];
    set(bone, parent < 0 ? rotation : glm::normalize(glm::conjugate(world(static_cast<Bone>(parent))) * rotation));
}

void Pose::reach(Bone upper, Bone lower, Bone end, glm::vec3 target, glm::vec3 pole, glm::vec3 flexed)
{
    const glm::vec3 rest_upper = skeleton().offset(lower), rest_lower = skeleton().offset(end);
    const float u = glm::length(rest_upper), l = glm::length(rest_lower);
    const glm::vec3 from = joint(upper);
    const glm::vec3 line = target - from;
    const float d = std::clamp(glm::length(line), std::fabs(u - l) * 1.02f, (u + l) * 0.9995f);
    const glm::vec3 ahead = glm::normalize(line);
    const glm::vec3 aside = glm::normalize(pole - ahead * glm::dot(pole, ahead));
    const float along = (u * u + d * d - l * l) / (2 * d);
    const float out = std::sqrt(std::max(0.0f, u * u - along * along));
    const glm::vec3 first = ahead * along + aside * out, second = ahead * d - first;
    const glm::vec3 hinge = glm::cross(aside, ahead);
    const glm::vec3 rest_line = glm::normalize(rest_upper + rest_lower);
    const glm::vec3 rest_hinge = glm::cross(flexed, rest_line);
    set_world(upper, rotation_between_frames(rest_upper, rest_hinge, first, hinge));
    set_world(lower, rotation_between_frames(rest_lower, rest_hinge, second, hinge));
}

}  // namespace claque::figures
