#include "passes/shadow_blob.h"

#include <algorithm>
#include <cmath>

namespace claque::passes
{
namespace
{

// The half length of a rod is 1.73 standard deviations, the radius of a disc 2.
constexpr double blob_reach = 1.8;
constexpr double h = 0.5, s = 0.86602540378443865;
constexpr double circle[blob_corners][2] = {{1, 0},  {s, h},   {h, s},   {0, 1},  {-h, s}, {-s, h},
                                            {-1, 0}, {-s, -h}, {-h, -s}, {0, -1}, {h, -s}, {s, -h}};

}  // namespace

const uint32_t blob_indices[blob_indices_count] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5,  0, 5,  6,
                                                   0, 6, 7, 0, 7, 8, 0, 8, 9, 0, 9, 10, 0, 10, 11};

PlanarMoments::PlanarMoments(const ShadowPlane &plane)
{
    const glm::dvec3 &n = plane.normal;
    const glm::dvec3 other = std::fabs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    u_ = glm::cross(n, other);
    u_ = u_ / std::sqrt(glm::dot(u_, u_));
    v_ = glm::cross(n, u_);
}

void PlanarMoments::add(const float *p)
{
    const glm::dvec3 at(p[0], p[1], p[2]);
    if (count_ == 0) first_ = at;
    const double u = glm::dot(u_, at - first_), v = glm::dot(v_, at - first_);
    ++count_;
    sum_u_ += u, sum_v_ += v;
    sum_uu_ += u * u, sum_uv_ += u * v, sum_vv_ += v * v;
}

void PlanarMoments::ellipse(float (&out)[3 * blob_corners]) const
{
    const double mean_u = sum_u_ / count_, mean_v = sum_v_ / count_;
    const double uu = std::max(sum_uu_ / count_ - mean_u * mean_u, 0.0);
    const double uv = sum_uv_ / count_ - mean_u * mean_v;
    const double vv = std::max(sum_vv_ / count_ - mean_v * mean_v, 0.0);
    // The Cholesky factor of the covariance matrix, lower triangular.
    const double a = std::sqrt(uu), b = a > 0 ? uv / a : 0, c = std::sqrt(std::max(vv - b * b, 0.0));
    for (uint32_t k = 0; k < blob_corners; ++k) {
        const double u = mean_u + blob_reach * a * circle[k][0];
        const double v = mean_v + blob_reach * (b * circle[k][0] + c * circle[k][1]);
        const glm::dvec3 p = first_ + u_ * u + v_ * v;
        for (int r = 0; r < 3; ++r) out[3 * k + static_cast<uint32_t>(r)] = static_cast<float>(p[r]);
    }
}

}  // namespace claque::passes
