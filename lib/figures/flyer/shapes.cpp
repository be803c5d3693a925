#include "lib/figures/flyer/shapes.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "lib/math/trig.h"

namespace claque::figures::flyer
{

namespace
{

constexpr float spine_turn = 6.28318531f;

// The point at the fraction `u` of the ring, from the back over the right and the front.
glm::vec3 on_ring(const Ring &ring, float u, float swell)
{
    const float x = -math::sin(spine_turn * u), z = -math::cos(spine_turn * u);
    return ring.centre + ring.ex * (swell * x * ring.side) + ring.ez * (swell * z * (z > 0 ? ring.front : ring.back));
}

}  // namespace

uint32_t MeshBuilder::point(glm::vec3 p)
{
    p += glm::vec3(0);  // no negative zeros
    const auto [at, fresh] = points_.try_emplace({p.x, p.y, p.z}, 0);
    if (fresh) at->second = mesh_.add(p, Region::own);
    return at->second;
}

void MeshBuilder::sheet(Chart chart, Winding winding, const std::vector<std::vector<SheetVertex>> &meridians)
{
    std::vector<Chain> chains;
    for (const auto &meridian : meridians) {
        Chain chain;
        for (const SheetVertex &stop : meridian) chain.push_back(corner(stop));
        chains.push_back(chain);
    }
    // With the meridians running to the right, the next one is below.
    for (size_t i = 0; i + 1 < chains.size(); ++i) mesh_.sew(chart, winding, chains[i + 1], chains[i], Along::t);
}

void MeshBuilder::triangle(Chart chart, Winding winding, const SheetVertex &a, const SheetVertex &b,
                           const SheetVertex &c)
{
    mesh_.face(chart, winding, corner(a), corner(b), corner(c));
}

void MeshBuilder::spike(Chart chart, const std::array<glm::vec3, 4> &corners)
{
    const glm::vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0f;
    const std::array<glm::vec2, 4> st = {{{0, 0}, {1, 0}, {0.5f, 0.2f}, {0.5f, 1}}};
    for (const auto &[a, b, c] : {std::array<size_t, 3>{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
        const glm::vec3 normal = glm::cross(corners[b] - corners[a], corners[c] - corners[a]);
        const bool outward = glm::dot(normal, corners[a] - middle) > 0;
        const auto own = [&](size_t i) { return Corner{mesh_.add(corners[i], Region::own), st[i]}; };
        mesh_.face(chart, outward ? Winding::as_given : Winding::reversed, own(a), own(b), own(c));
    }
}

void add_ball(MeshBuilder &to, Chart chart, const Ball &ball, int columns, int rows)
{
    std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
    for (int i = 0; i <= columns; ++i) {
        const float yaw = ball.aside * (2 * static_cast<float>(i) / static_cast<float>(columns) - 1);
        std::vector<MeshBuilder::SheetVertex> stops;
        for (int k = 0; k <= rows; ++k) {
            const float pitch = ball.up * (2 * static_cast<float>(k) / static_cast<float>(rows) - 1);
            const glm::vec3 d(math::sin(yaw) * math::cos(pitch), math::sin(pitch), math::cos(yaw) * math::cos(pitch));
            stops.push_back({ball.centre + d * ball.radius, glm::vec2(yaw, pitch)});
        }
        meridians.push_back(stops);
    }
    to.sheet(chart, Winding::as_given, meridians);
}

void add_lid(MeshBuilder &to, Chart chart, const Ball &ball, int columns, const std::vector<float> &pitches)
{
    std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
    for (int i = 0; i <= columns; ++i) {
        const float aside = ball.aside * (2 * static_cast<float>(i) / static_cast<float>(columns) - 1);
        std::vector<MeshBuilder::SheetVertex> stops;
        for (const float pitch : pitches) {
            const glm::vec3 d(math::sin(aside), math::cos(aside) * math::sin(pitch),
                              math::cos(aside) * math::cos(pitch));
            stops.push_back({ball.centre + d * ball.radius, glm::vec2(aside, pitch)});
        }
        meridians.push_back(stops);
    }
    to.sheet(chart, Winding::as_given, meridians);
}

void add_tube(MeshBuilder &to, const Tube &tube, const std::vector<Ring> &rings)
{
    const float n = static_cast<float>(tube.around);
    const float swell = 2 / (1 + math::cos(spine_turn / 2 / n));
    std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
    for (int k = 0; k <= tube.around; ++k) {
        const float u = static_cast<float>(k % tube.around) / n;
        std::vector<MeshBuilder::SheetVertex> meridian;
        for (const Ring &ring : rings) {
            const float depth = tube.pleat * (1 - ring.t), pleat = k % 2 == 0 ? 1 + depth : 1 - depth;
            meridian.push_back({mirrored(on_ring(ring, u, swell * (tube.pleat > 0 ? pleat : 1)), tube.side),
                                glm::vec2(static_cast<float>(k) / n, ring.t)});
        }
        meridians.push_back(meridian);
    }
    to.sheet(tube.chart, winding_of(tube.side), meridians);
}

std::vector<Ring> rings_along(const std::vector<PathRing> &beads, glm::vec3 forward)
{
    std::vector<Ring> rings;
    float t = 0;
    glm::vec3 last_up(0);
    for (size_t i = 0; i < beads.size(); ++i) {
        const glm::vec3 before = beads[i > 0 ? i - 1 : 0].centre;
        const glm::vec3 after = beads[i + 1 < beads.size() ? i + 1 : i].centre;
        glm::vec3 up = glm::normalize(before - after);  // the path runs downwards, rings are seen from above
        if (!rings.empty() && glm::dot(up, last_up) < 0) up = -up;  // a hem that is turned in
        last_up = up;
        const glm::vec3 ez = glm::normalize(forward - up * glm::dot(forward, up));
        if (i > 0) t -= std::max(glm::distance(beads[i].centre, before), std::fabs(beads[i].side - beads[i - 1].side));
        rings.push_back({beads[i].centre, beads[i].side, beads[i].front, beads[i].back, t, glm::cross(up, ez), ez});
    }
    return {rings.rbegin(), rings.rend()};
}

}  // namespace claque::figures::flyer
