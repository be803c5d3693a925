#include "tests/reference/triangles.h"

#include <algorithm>
#include <utility>

#include "tests/reference/grid.h"

namespace claque::reference
{
namespace
{

// Corners in the order that the specification gives for triangle i of a part.
std::vector<std::array<uint32_t, 3>> corners_of(const Part &part)
{
    std::vector<std::array<uint32_t, 3>> corners;
    const std::vector<uint32_t> &v = part.indices;
    if (part.mode == 4)
        for (size_t i = 0; i + 2 < v.size(); i += 3) corners.push_back({v[i], v[i + 1], v[i + 2]});
    if (part.mode == 5)
        for (size_t i = 0; i + 2 < v.size(); ++i) corners.push_back({v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
    if (part.mode == 6)
        for (size_t i = 0; i + 2 < v.size(); ++i) corners.push_back({v[i + 1], v[i + 2], v[0]});
    return corners;
}

bool alike(const Facet &a, const Facet &b, double distance)
{
    // Moving the corners by d changes the area by no more than half of d times the circumference, about; small
    // triangles of circumference c have areas of c * c / 21 at most.
    const double circumference = std::sqrt(21 * std::max(length(a.area), length(b.area)));
    const double give = distance * (4 * circumference + 2 * distance);
    return length(a.centre - b.centre) <= distance && length(a.area - b.area) <= give;
}

}  // namespace

Triangles triangles_of(const Character &character, double size)
{
    const Shape shape = evaluate(character, rest, 0);
    const std::vector<Vec3> &positions = shape.positions;
    Triangles triangles;
    size_t first = 0;
    for (const Part &part : character.parts) {
        for (const auto &corner : corners_of(part)) {
            Triangle triangle{first + corner[0], first + corner[1], first + corner[2]};
            const auto is_mirrored = [&](size_t vertex) { return shape.mirrored[vertex]; };
            if (std::count_if(triangle.begin(), triangle.end(), is_mirrored) >= 2) std::swap(triangle[1], triangle[2]);
            const Facet f = facet(positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]);
            triangles.all.push_back(triangle);
            triangles.has_area.push_back(length(f.area) > 1e-10 * size * size);
        }
        first += part.positions.size();
    }
    return triangles;
}

std::vector<bool> vertices_of(const Triangles &triangles, size_t vertex_count)
{
    std::vector<bool> used(vertex_count, false);
    for (size_t i = 0; i < triangles.all.size(); ++i)
        for (const size_t v : triangles.all[i]) used[v] = used[v] || triangles.has_area[i];
    return used;
}

Facet facet(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    return {(a + b + c) * (1.0 / 3), cross(b - a, c - a) * 0.5};
}

SurfaceMatching match(const std::vector<Facet> &expected, const std::vector<bool> &required,
                      const std::vector<Facet> &actual, double distance)
{
    SurfaceMatching result;
    std::vector<Vec3> centres;
    for (const Facet &f : expected) centres.push_back(f.centre);
    const Grid grid(centres, distance);
    std::vector<bool> found(expected.size(), false);
    for (const Facet &f : actual) {
        bool has_partner = false, has_turned = false;
        for (const size_t candidate : grid.near(f.centre)) {
            const Facet turned{f.centre, f.area * -1};
            has_turned = has_turned || alike(turned, expected[candidate], distance);
            if (alike(f, expected[candidate], distance)) has_partner = found[candidate] = true;
        }
        result.strays += has_partner ? 0 : 1;
        result.turned += !has_partner && has_turned ? 1 : 0;
    }
    for (size_t i = 0; i < found.size(); ++i) result.missing += required[i] && !found[i] ? 1 : 0;
    result.same = result.strays == 0 && result.missing == 0 && actual.size() <= expected.size();
    result.text = std::to_string(expected.size()) + " triangles expected, " + std::to_string(actual.size()) +
                  " there: " + std::to_string(result.strays) + " stray (" + std::to_string(result.turned) +
                  " with the front behind), " + std::to_string(result.missing) + " missing";
    return result;
}

}  // namespace claque::reference
