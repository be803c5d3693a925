#include "lib/figures/flyer/shapes.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace claque::figures::flyer
{

namespace
{

constexpr float turn = 6.28318531f;

// At `u` of the way round, from the back over the right and the front.
glm::vec3 on_ring(const Ring &ring, float u, float swell)
{
    const float x = -std::sin(turn * u), z = -std::cos(turn * u);
    return ring.centre + ring.ex * (swell * x * ring.side) + ring.ez * (swell * z * (z > 0 ? ring.front : ring.back));
}

}  // namespace

uint32_t Sculptor::point(glm::vec3 p)
{
    p += glm::vec3(0);  // no negative zeros
    const auto [at, fresh] = points_.try_emplace({p.x, p.y, p.z}, 0);
    if (fresh) at->second = mesh_.add(p, Region::own);
    return at->second;
}

void Sculptor::sheet(Chart chart, Winding winding, const std::vector<std::vector<Stop>> &meridians)
{
    std::vector<Chain> chains;
    for (const auto &meridian : meridians) {
        Chain chain;
        for (const Stop &stop : meridian) chain.push_back(corner(stop));
        chains.push_back(chain);
    }
    // Seen with the meridians lying to the right, the next one is below.
    for (size_t i = 0; i + 1 < chains.size(); ++i) mesh_.sew(chart, winding, chains[i + 1], chains[i], Along::t);
}

void Sculptor::triangle(Chart chart, Winding winding, const Stop &a, const Stop &b, const Stop &c)
{
    mesh_.face(chart, winding, corner(a), corner(b), corner(c));
}

void add_tube(Sculptor &to, const Tube &tube, const std::vector<Ring> &rings)
{
    const float n = static_cast<float>(tube.around);
    const float swell = 2 / (1 + std::cos(turn / 2 / n));
    std::vector<std::vector<Sculptor::Stop>> meridians;
    for (int k = 0; k <= tube.around; ++k) {
        const float u = static_cast<float>(k % tube.around) / n;
        std::vector<Sculptor::Stop> meridian;
        for (const Ring &ring : rings) {
            const float depth = tube.pleat * (1 - ring.t), pleat = k % 2 == 0 ? 1 + depth : 1 - depth;
            meridian.push_back({mirrored(on_ring(ring, u, swell * (tube.pleat > 0 ? pleat : 1)), tube.side),
                                glm::vec2(static_cast<float>(k) / n, ring.t)});
        }
        meridians.push_back(meridian);
    }
    to.sheet(tube.chart, winding_of(tube.side), meridians);
}

std::vector<Ring> strung(const std::vector<Bead> &beads, glm::vec3 forward)
{
    std::vector<Ring> rings;
    float t = 0;
    glm::vec3 last_up(0);
    for (size_t i = 0; i < beads.size(); ++i) {
        const glm::vec3 before = beads[i > 0 ? i - 1 : 0].centre;
        const glm::vec3 after = beads[i + 1 < beads.size() ? i + 1 : i].centre;
        glm::vec3 up = glm::normalize(before - after);  // beads run downwards, rings are looked at from above
        if (!rings.empty() && glm::dot(up, last_up) < 0) up = -up;  // a hem that is turned in
        last_up = up;
        const glm::vec3 ez = glm::normalize(forward - up * glm::dot(forward, up));
        if (i > 0) t -= std::max(glm::distance(beads[i].centre, before), std::fabs(beads[i].side - beads[i - 1].side));
        rings.push_back({beads[i].centre, beads[i].side, beads[i].front, beads[i].back, t, glm::cross(up, ez), ez});
    }
    return {rings.rbegin(), rings.rend()};
}

}  // namespace claque::figures::flyer
