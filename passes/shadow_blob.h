// The coarse level of shadows: an ellipse on the ground with the mean and covariance of the shadow.
#pragma once

#include "passes/shadow_batch.h"
#include "passes/shadow_plane.h"

namespace claque::passes
{

constexpr uint32_t blob_corners = 12, blob_indices_count = 3 * (blob_corners - 2);
extern const uint32_t blob_indices[blob_indices_count];

// Moments of points on a plane, in two directions of its own.
class PlanarMoments
{
public:
    explicit PlanarMoments(const ShadowPlane &plane);
    void add(const float *p);
    // The corners of the ellipse, 3 numbers each. Requires at least one point.
    void ellipse(float (&out)[3 * blob_corners]) const;

private:
    glm::dvec3 u_, v_, first_ = glm::dvec3(0);
    double count_ = 0, sum_u_ = 0, sum_v_ = 0, sum_uu_ = 0, sum_uv_ = 0, sum_vv_ = 0;
};

}  // namespace claque::passes
