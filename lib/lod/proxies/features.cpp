#include "lib/lod/proxies/features.h"

namespace claque::lod
{

namespace
{

// Returns the squared distance of two means.
double squared_distance(const Attributes &a, const Attributes &b)
{
    double sum = 0;
    for (size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        const bool left = j == b.size() || (i < a.size() && a[i].id <= b[j].id);
        const bool right = i == a.size() || (j < b.size() && b[j].id <= a[i].id);
        const double difference = (left ? a[i].value : 0) - (right ? b[j].value : 0);
        sum += difference * difference;
        i += left, j += right;
    }
    return sum;
}

}  // namespace

Features merged(const Features &a, const Features &b)
{
    Features out;
    out.area = a.area + b.area;
    const double of_a = out.area > 0 ? a.area / out.area : 0.5, of_b = 1 - of_a;
    for (size_t i = 0, j = 0; i < a.mean.size() || j < b.mean.size();) {
        const bool left = j == b.mean.size() || (i < a.mean.size() && a.mean[i].id <= b.mean[j].id);
        const bool right = i == a.mean.size() || (j < b.mean.size() && b.mean[j].id <= a.mean[i].id);
        out.mean.push_back({left ? a.mean[i].id : b.mean[j].id,
                            (left ? of_a * a.mean[i].value : 0) + (right ? of_b * b.mean[j].value : 0)});
        i += left, j += right;
    }
    return out;
}

double variance_of(const Features &a, const Features &b)
{
    const double areas = a.area + b.area;
    return areas > 0 ? a.area * b.area / areas * squared_distance(a.mean, b.mean) : 0;
}

glm::dvec3 optimal_position(const PlaneQuadric &planes, glm::dvec3 p, glm::dvec3 q)
{
    const glm::dvec3 middle = 0.5 * (p + q);
    glm::dvec3 best = middle, found;
    const double reach = 2 * glm::length(q - p);
    if (planes.find_minimum(middle, found) && glm::length(found - middle) <= reach) best = found;
    for (const glm::dvec3 other : {p, q, middle})
        if (planes.at(other) < planes.at(best)) best = other;
    return best;
}

bool flips(const TriangleFrame &was, const TriangleFrame &is, double sliver)
{
    if (was.area < sliver || is.area < sliver) return false;
    return glm::dot(was.normal, is.normal) < 0.2;
}

}  // namespace claque::lod
