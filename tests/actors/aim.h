// Cameras that are aimed at one point, and whether they see others.
#pragma once

#include "lib/frame/view.h"

namespace actors
{

inline double along(const glm::dvec3 &a, const glm::dvec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Unit, the k-th of a random series.
glm::dvec3 random_direction(uint32_t k);

// The k-th camera, one of whose planes is square to `out` and `inside` beyond `corner`: it sees the point, and
// nothing that is farther than that behind it. The six planes take turns.
claque::frame::Camera aimed(uint32_t k, const glm::dvec3 &corner, const glm::dvec3 &out, double inside);

// A camera's frustum in double, by the inequalities of clip space.
class Camera
{
public:
    explicit Camera(const claque::frame::Camera &camera);
    bool sees(const glm::dvec3 &point) const;

private:
    glm::dvec3 eye_;
    glm::dvec3 rows_[4];  // of the projection after the rotation
    double constants_[4];
};

}  // namespace actors
