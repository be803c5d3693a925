#include "lib/lod/surface/visibility.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/surface/nearest.h"
#include "lib/lod/surface/occluders.h"
#include "lib/lod/surface/stacking.h"

namespace claque::lod
{

namespace
{

constexpr size_t sparse_triangles = 2500;  // larger meshes are sampled only at the triangles' centres
constexpr size_t task_triangles = 128;     // triangles per task

// The directions to the sides and the corners of a cube.
std::vector<Occluders::Ray> directions()
{
    std::vector<Occluders::Ray> found;
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

std::vector<double> visibility_of(const model::Model &model, const PosedParts &parts, const base::Jobs &jobs)
{
    std::vector<VisibilityQuery> queries;
    std::vector<Corners3> triangles;
    for (const PosedParts::Triangle &t : parts.triangles()) {
        triangles.push_back(parts.corners(t));
        queries.push_back(
            {triangles.back(), is_two_sided(model, parts.part(t.part)), has_holes(model, parts.part(t.part))});
    }
    check_stacking(triangles, model.name);
    return visibility_of(queries, VisibilityQuality::full, jobs);
}

std::vector<double> visibility_of(const std::vector<VisibilityQuery> &queries, VisibilityQuality quality,
                                  const base::Jobs &jobs)
{
    std::vector<Corners3> triangles;
    glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
    for (const VisibilityQuery &query : queries) {
        if (!query.has_holes) triangles.push_back(query.corners);
        for (const glm::dvec3 p : query.corners) min = glm::min(min, p), max = glm::max(max, p);
    }
    std::vector<double> visibility(queries.size());
    if (queries.empty()) return visibility;
    if (triangles.empty()) triangles.emplace_back();    // a point
    const double skin = 1e-5 * glm::length(max - min);  // occluders nearer than this do not count
    const Occluders all(triangles);
    const std::array<glm::dvec3, 4> sample_weights = {glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(4, 1, 1) / 6.0,
                                                      glm::dvec3(1, 4, 1) / 6.0, glm::dvec3(1, 1, 4) / 6.0};
    const size_t sample_count =
        quality == VisibilityQuality::fast || queries.size() > sparse_triangles ? 1 : sample_weights.size();
    const auto visibility_at = [&](size_t at, std::vector<Occluders::Ray> &eyes) {
        const auto &c = queries[at].corners;
        const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
        size_t count = 0;
        for (size_t s = 0; s < sample_count; ++s) {
            size_t from = 0;
            const glm::dvec3 point = point_on(c, sample_weights[s]);
            for (Occluders::Ray &eye : eyes)
                from += (queries[at].two_sided || glm::dot(normal, eye.dir) > 0) && !all.intersects(point, eye, skin);
            count += from > 1 ? from : 0;
        }
        return double(count) / double(sample_count * eyes.size());
    };
    jobs.try_each(static_cast<uint32_t>((queries.size() + task_triangles - 1) / task_triangles), [&](uint32_t job) {
        std::vector<Occluders::Ray> eyes = directions();
        for (size_t at = job * task_triangles; at < std::min<size_t>((job + 1) * task_triangles, queries.size()); ++at)
            visibility[at] = visibility_at(at, eyes);
    });
    if (std::all_of(visibility.begin(), visibility.end(), [](double one) { return one == 0; }))
        visibility.assign(visibility.size(), 1);
    return visibility;
}

std::vector<double> visible_areas(const model::Model &model, const PosedParts &parts)
{
    std::vector<double> areas = visibility_of(model, parts);
    for (uint32_t t = 0; t < areas.size(); ++t) areas[t] *= area_of(parts, t);
    return areas;
}

}  // namespace claque::lod
