#include "meshsplit/enclosing.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::meshsplit
{

namespace
{

constexpr int core_size = 12, steps = 200;

double reach(const glm::dvec3 &centre, const Ball &ball) { return glm::distance(centre, ball.centre) + ball.radius; }

double square(const glm::dvec3 &v) { return glm::dot(v, v); }

const Ball &farthest(const glm::dvec3 &centre, const std::vector<Ball> &balls)
{
    const Ball *far = &balls[0];
    double maximum = reach(centre, *far), most_square = square(centre - far->centre);
    for (const Ball &ball : balls) {
        // A ball of equal radius that is nearer reaches no further; this saves the square root.
        const double here = square(centre - ball.centre);
        if (ball.radius == far->radius && here <= most_square) continue;
        const double r = std::sqrt(here) + ball.radius;
        if (r > maximum) maximum = r, most_square = here, far = &ball;
    }
    return *far;
}

// Moves the centre towards the farthest ball in ever smaller steps.
glm::dvec3 centre_of(const std::vector<Ball> &balls)
{
    glm::dvec3 centre = balls[0].centre;
    for (int step = 1; step <= steps; ++step) {
        const Ball &far = farthest(centre, balls);
        const double way = glm::distance(centre, far.centre);
        if (way > 0) centre += (far.centre - centre) * ((way + far.radius) / way / (step + 1));
    }
    return centre;
}

glm::dvec3 middle_of(const std::vector<Ball> &balls)
{
    glm::dvec3 low = balls[0].centre, high = low;
    for (const Ball &ball : balls) {
        low = glm::min(low, ball.centre - ball.radius);
        high = glm::max(high, ball.centre + ball.radius);
    }
    return 0.5 * (low + high);
}

}  // namespace

// A few balls, found one after the other, determine the centre.
model::Sphere enclosing(const std::vector<Ball> &balls)
{
    glm::dvec3 centre = middle_of(balls), best = centre;
    double least = reach(centre, farthest(centre, balls));
    std::vector<Ball> core;
    std::vector<const Ball *> known;
    for (int i = 0; i < core_size; ++i) {
        const Ball &far = farthest(centre, balls);
        if (std::find(known.begin(), known.end(), &far) != known.end()) break;  // converged
        known.push_back(&far), core.push_back(far);
        centre = centre_of(core);
        const double radius = reach(centre, farthest(centre, balls));
        if (radius < least) least = radius, best = centre;
    }
    model::Sphere out;
    out.centre = glm::vec3(best);
    const double radius = reach(glm::dvec3(out.centre), farthest(glm::dvec3(out.centre), balls));
    out.radius = static_cast<float>(radius * (1 + 1e-5) + 2e-6 * glm::length(best));
    return out;
}

}  // namespace claque::meshsplit
