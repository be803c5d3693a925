#include "lib/lod/seen.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "lib/lod/nearest.h"
#include "lib/lod/obstacles.h"

namespace claque::lod
{

namespace
{

constexpr size_t many = 2500;    // triangles: more are small enough to be judged by their middles
constexpr size_t at_once = 128;  // triangles of a task

// To the sides and the corners of a cube.
std::vector<Obstacles::Way> directions()
{
    std::vector<Obstacles::Way> found;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const double square = glm::dot(d, d);
        if (square == 1 || square == 3) found.emplace_back(glm::normalize(d));
    }
    return found;
}

}  // namespace

bool is_two_sided(const model::Model &model, const model::Part &part)
{
    return part.material != model::none && model.materials[part.material].double_sided;
}

std::vector<double> seen_of(const model::Model &model, const PosedParts &parts, const base::Jobs &jobs)
{
    std::vector<Side> sides;
    for (const PosedParts::Triangle &t : parts.triangles())
        sides.push_back({parts.corners(t), is_two_sided(model, parts.part(t.part))});
    return seen_of(sides, Care::full, jobs);
}

std::vector<double> seen_of(const std::vector<Side> &sides, Care care, const base::Jobs &jobs)
{
    std::vector<Corners3> triangles;
    glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
    for (const Side &side : sides) {
        triangles.push_back(side.corners);
        for (const glm::dvec3 p : side.corners) first = glm::min(first, p), last = glm::max(last, p);
    }
    std::vector<double> seen(sides.size());
    if (triangles.empty()) return seen;
    const double skin = 1e-5 * glm::length(last - first);  // what is as near as this is not in the way
    const Obstacles all(triangles);
    const std::array<glm::dvec3, 4> spots = {glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(4, 1, 1) / 6.0,
                                             glm::dvec3(1, 4, 1) / 6.0, glm::dvec3(1, 1, 4) / 6.0};
    const size_t spot_count = care == Care::haste || sides.size() > many ? 1 : spots.size();
    const auto look = [&](size_t at, std::vector<Obstacles::Way> &eyes) {
        const auto &c = sides[at].corners;
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        size_t count = 0;
        for (size_t s = 0; s < spot_count; ++s) {
            size_t from = 0;
            const glm::dvec3 place = point_on(c, spots[s]);
            for (Obstacles::Way &eye : eyes)
                from += (sides[at].both || glm::dot(normal, eye.along) > 0) && !all.meets(place, eye, skin);
            count += from > 1 ? from : 0;
        }
        return double(count) / double(spot_count * eyes.size());
    };
    jobs.try_each(static_cast<uint32_t>((sides.size() + at_once - 1) / at_once), [&](uint32_t job) {
        std::vector<Obstacles::Way> eyes = directions();
        for (size_t at = job * at_once; at < std::min<size_t>((job + 1) * at_once, sides.size()); ++at)
            seen[at] = look(at, eyes);
    });
    if (std::all_of(seen.begin(), seen.end(), [](double one) { return one == 0; })) seen.assign(seen.size(), 1);
    return seen;
}

std::vector<double> seen_areas(const model::Model &model, const PosedParts &parts)
{
    std::vector<double> areas = seen_of(model, parts);
    for (uint32_t t = 0; t < areas.size(); ++t) areas[t] *= area_of(parts, t);
    return areas;
}

}  // namespace claque::lod
