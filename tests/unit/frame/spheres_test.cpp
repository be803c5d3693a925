// Parts that a matrix moves into view are found, whatever the matrix does to lengths and angles: against the points of
// their spheres themselves.
#include "lib/frame/spheres.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace
{

using namespace claque;

struct Numbers {
    uint64_t state;
    double operator()(double low, double high)
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * double(state >> 40) / double(1 << 24);
    }
    glm::dvec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

// The point of a ball after a matrix that lies farthest along a direction.
glm::dvec3 farthest(const math::Affine &m, const model::Sphere &ball, const glm::dvec3 &along)
{
    const glm::dvec3 x(m.column(0)), y(m.column(1)), z(m.column(2)), at(m.column(3));
    const glm::dvec3 back = glm::normalize(glm::dvec3(glm::dot(x, along), glm::dot(y, along), glm::dot(z, along)));
    const glm::dvec3 p = glm::dvec3(ball.centre) + double(ball.radius) * back;
    return x * p.x + y * p.y + z * p.z + at;
}

// One of one part, or of several along a chain of nodes, each with two spheres.
struct Body {
    model::Template tmpl{std::pmr::get_default_resource()};
    std::vector<math::Affine> palette;
    Body(uint32_t parts, bool similar, Numbers &random)
    {
        tmpl.similar_only = similar;
        model::Level &level = tmpl.levels.emplace_back(std::pmr::get_default_resource());
        for (uint32_t k = 0; k < parts; ++k) {
            tmpl.rig.parents.push_back(k == 0 ? model::none : k - 1);
            level.parts.push_back({k, 2 * k, 2, 1});
            for (uint32_t i = 2 * k; i < 2 * k + 2; ++i) {
                model::PartSphere sphere;
                sphere.entry = i;
                sphere.bind = {glm::vec3(random.vector(1)), float(random(0.05, 0.5))};
                level.part_spheres.push_back(sphere);
                palette.push_back(similar ? turned(random) : skewed(random));
            }
        }
    }
    static math::Affine turned(Numbers &random)
    {
        math::Trs trs;
        const glm::dvec3 axis = glm::normalize(random.vector(1) + glm::dvec3(0, 2, 0));
        const double half = random(0, 3);
        trs.rotation = glm::quat(float(std::cos(half)), glm::vec3(std::sin(half) * axis));
        trs.scale = glm::vec3(float(random(0.3, 3)));
        trs.translation = glm::vec3(random.vector(2));
        return math::affine_of(trs);
    }
    // One axis is much longer than the others, which it is not square to.
    static math::Affine skewed(Numbers &random)
    {
        math::Affine out;
        const int longest = int(random(0, 3));
        for (int k = 0; k < 4; ++k) out.set_column(k, glm::vec3(random.vector(k == 3 ? 2 : k == longest ? 4 : 0.5)));
        return out;
    }
};

void expect_found(uint32_t parts, bool similar)
{
    Numbers random{parts + (similar ? 100u : 0u)};
    uint32_t hidden = 0;
    for (int i = 0; i < 300; ++i) {
        const Body body(parts, similar, random);
        const model::Level &level = body.tmpl.levels[0];
        for (uint32_t part = 0; part < parts; ++part)
            for (uint32_t sphere = 2 * part; sphere < 2 * part + 2; ++sphere) {
                math::Frustum frustum;
                frustum.count = 1;
                const glm::dvec3 along = glm::normalize(random.vector(1));
                const glm::dvec3 p = farthest(body.palette[sphere], level.part_spheres[sphere].bind, along);
                for (const double inside : {1e-4, -100.0}) {
                    frustum.planes[0] = {along, inside - glm::dot(along, p)};
                    const frame::ToFrustum to{glm::dmat3(1), glm::dvec3(0), 1};
                    const uint64_t seen =
                        frame::parts_in_view(body.tmpl, level, body.palette.data(), to, frustum).parts;
                    if (inside > 0)
                        EXPECT_TRUE(seen >> part & 1) << "part " << part << " of " << parts << ", body " << i;
                    else hidden += !(seen >> part & 1);
                }
            }
    }
    EXPECT_EQ(hidden, 600 * parts) << "what lies far outside is out of view";
}

TEST(Spheres, OfMatricesThatAreNoSimilaritiesHoldTheirParts)
{
    for (const uint32_t parts : {1u, 2u, 5u}) expect_found(parts, false);
}

TEST(Spheres, OfSimilaritiesHoldTheirParts)
{
    for (const uint32_t parts : {1u, 2u, 5u}) expect_found(parts, true);
}

// A plane that misses the smallest ball round both balls of a part by three thousandths of its radius hides the part.
TEST(Spheres, OfSimilaritiesAreNoLargerThanTheyNeedToBe)
{
    Numbers random{7};
    for (const uint32_t parts : {1u, 3u})
        for (int i = 0; i < 300; ++i) {
            const Body body(parts, true, random);
            const model::Level &level = body.tmpl.levels[0];
            for (uint32_t part = 0; part < parts; ++part) {
                glm::dvec3 centres[2];
                double radii[2];
                for (uint32_t k = 0; k < 2; ++k) {
                    const model::PartSphere &sphere = level.part_spheres[2 * part + k];
                    const math::Affine &m = body.palette[sphere.entry];
                    centres[k] = glm::dvec3(math::transform_point(m, sphere.bind.centre));
                    radii[k] = double(sphere.bind.radius) * glm::length(glm::dvec3(m.column(0)));
                }
                const double apart = glm::length(centres[1] - centres[0]);
                const double radius = std::max({radii[0], radii[1], (apart + radii[0] + radii[1]) / 2});
                const double part_of_way = std::clamp((radius - radii[0]) / apart, 0.0, 1.0);
                const glm::dvec3 centre = centres[0] + part_of_way * (centres[1] - centres[0]);
                const glm::dvec3 along = glm::normalize(random.vector(1));
                math::Frustum frustum;
                frustum.count = 1;
                frustum.planes[0] = {along, -glm::dot(along, centre) - 1.003 * radius};
                const frame::ToFrustum to{glm::dmat3(1), glm::dvec3(0), 1};
                const uint64_t seen = frame::parts_in_view(body.tmpl, level, body.palette.data(), to, frustum).parts;
                EXPECT_FALSE(seen >> part & 1) << part << " of " << parts << ", body " << i;
            }
        }
}

}  // namespace
