#include "meshsplit/reach_support.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "lib/math/trig.h"

namespace claque::meshsplit
{

namespace
{

// The transposed rotation about a unit axis: the support of the rotated set along u is that of the set along the
// result.
glm::dvec3 rotated_back(const glm::dvec3 &u, const glm::dvec3 &axis, double angle)
{
    const double c = math::cos(angle), s = math::sin(angle);
    return u * c - glm::cross(axis, u) * s + axis * (glm::dot(axis, u) * (1 - c));
}

double turned_by(const model::Dof &dof) { return std::min(double(dof.max) - double(dof.min), 2 * math::pi); }

// About half of the spacing of the directions, which falls with the square root of their number.
size_t steps_of(const model::Dof &dof, size_t directions)
{
    const double widest = 1.5 / std::sqrt(double(directions));
    return static_cast<size_t>(std::ceil(turned_by(dof) / widest));
}

}  // namespace

AffineMap after(const AffineMap &a, const AffineMap &b) { return {a.turn * b.turn, a.turn * b.move + a.move}; }

void merge(const Directions &directions, const Support &set, const AffineMap &map, Support &out)
{
    const glm::dmat3 back = glm::transpose(map.turn);
    for (size_t i = 0; i < directions.count(); ++i) {
        const double h = directions.find(back * directions[i]).of(set.data()) + glm::dot(directions[i], map.move);
        out[i] = std::max(out[i], h);
    }
}

double farthest(const Directions &directions, const Support &set, const glm::dvec3 &centre)
{
    double maximum = 0;
    for (size_t i = 0; i < set.size(); ++i) maximum = std::max(maximum, set[i] - glm::dot(directions[i], centre));
    return maximum * directions.max_weight();
}

uint64_t DofSweep::bytes(const model::Dof &dof, size_t directions)
{
    if (dof.kind != model::DofKind::rotation) return 2 * sizeof(double) * directions;
    return directions * ((steps_of(dof, directions) + 1) * sizeof(DirectionBlend) + sizeof(double));
}

DofSweep::DofSweep(const Directions &directions, const model::Dof &dof)
{
    if (dof.kind == model::DofKind::rotation) {
        plan_turns(directions, dof);
        return;
    }
    for (size_t i = 0; i < directions.count(); ++i) {
        const double along = glm::dot(directions[i], glm::dvec3(dof.axis));
        shift_.push_back(std::max(along * double(dof.min), along * double(dof.max)));
    }
}

// A point at distance rho from the axis has the support a + rho * cos(angle - phi) along a direction perpendicular to
// the axis. Between two angles 2 w apart this exceeds both ends by at most rho * (1 - cos w).
void DofSweep::plan_turns(const Directions &directions, const model::Dof &dof)
{
    const double range = turned_by(dof);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(dof.axis));
    const int steps = static_cast<int>(steps_of(dof, directions.count()));
    angles_ = size_t(steps) + 1;
    turned_.reserve(directions.count() * angles_), between_.reserve(directions.count());
    // A nearly unit axis gives a nearly unit quaternion: its matrix is off by this fraction.
    const double slack = 2.5 * std::fabs(glm::dot(glm::dvec3(dof.axis), glm::dvec3(dof.axis)) - 1);
    const double bulge = slack + (steps > 0 ? 1 - math::cos(0.5 * range / steps) : 0);
    for (size_t i = 0; i < directions.count(); ++i) {
        const double along = glm::dot(directions[i], axis);
        between_.push_back(bulge * std::sqrt(std::max(0.0, 1 - along * along)));
        for (int k = 0; k <= steps; ++k) {
            const double angle = double(dof.min) + (steps > 0 ? range * k / steps : 0);
            turned_.push_back(directions.find(rotated_back(directions[i], axis, angle)));
        }
    }
}

void DofSweep::sweep(double reach, Support &set, Support &scratch) const
{
    if (turned_.empty()) {
        for (size_t i = 0; i < set.size(); ++i) set[i] += shift_[i];
        return;
    }
    scratch = set;
    const DirectionBlend *blend = turned_.data();
    for (size_t i = 0; i < set.size(); ++i) {
        double maximum = blend->of(scratch.data());
        for (size_t k = 1; k < angles_; ++k) maximum = std::max(maximum, blend[k].of(scratch.data()));
        set[i] = maximum + between_[i] * reach;
        blend += angles_;
    }
}

}  // namespace claque::meshsplit
