#include "meshsplit/reach_directions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace claque::meshsplit
{

namespace
{

constexpr int side_cells = 24;

// Returns the cell of a cube map that contains a direction.
size_t cell_of(const glm::dvec3 &v)
{
    const glm::dvec3 size = glm::abs(v);
    const int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double scale = size[k] > 0 ? 0.5 * side_cells / size[k] : 0;
    const auto place = [&](double x) { return std::clamp(int(x * scale + 0.5 * side_cells), 0, side_cells - 1); };
    const int side = 2 * k + (v[k] < 0);
    return size_t((side * side_cells + place(v[(k + 1) % 3])) * side_cells + place(v[(k + 2) % 3]));
}

}  // namespace

Directions::Directions(int splits)
{
    Corners faces = icosahedron();
    for (int i = 0; i < splits; ++i) faces = split(faces);
    connect(faces);
    fill_cells();
}

Directions::Corners Directions::icosahedron()
{
    const double golden = 0.5 * (1 + std::sqrt(5.0));
    for (int k = 0; k < 3; ++k)
        for (const double a : {-1.0, 1.0})
            for (const double b : {-golden, golden}) {
                glm::dvec3 v(0);
                v[(k + 1) % 3] = a, v[(k + 2) % 3] = b;
                units_.push_back(glm::normalize(v));
            }
    // Corners of a face are neighbours. The cosine of neighbours is 1 / sqrt(5), the next smaller one is below 0.
    const auto near = [&](size_t i, size_t j) { return glm::dot(units_[i], units_[j]) > 0.4; };
    Corners faces;
    for (uint16_t i = 0; i < 12; ++i)
        for (uint16_t j = uint16_t(i + 1); j < 12; ++j)
            for (uint16_t k = uint16_t(j + 1); k < 12; ++k)
                if (near(i, j) && near(j, k) && near(k, i)) faces.push_back({i, j, k});
    return faces;
}

Directions::Corners Directions::split(const Corners &faces)
{
    std::map<std::pair<uint16_t, uint16_t>, uint16_t> middles;
    const auto middle = [&](uint16_t a, uint16_t b) {
        const auto found = middles.try_emplace(std::minmax(a, b), uint16_t(units_.size()));
        if (found.second) units_.push_back(glm::normalize(units_[a] + units_[b]));
        return found.first->second;
    };
    Corners out;
    for (const auto &[a, b, c] : faces) {
        const uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        out.insert(out.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return out;
}

void Directions::connect(const Corners &faces)
{
    std::map<std::pair<uint16_t, uint16_t>, uint16_t> open;
    for (const auto &corners : faces) {
        const uint16_t index = static_cast<uint16_t>(faces_.size());
        const glm::dvec3 a = units_[corners[0]], b = units_[corners[1]], c = units_[corners[2]];
        faces_.push_back({corners, {0, 0, 0}, glm::inverse(glm::dmat3(a, b, c))});
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        max_weight_ = std::max(max_weight_, glm::length(normal) / std::fabs(glm::dot(normal, a)));
        for (size_t k = 0; k < 3; ++k) {
            const auto edge = std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]);
            const auto met = open.try_emplace(edge, index);
            if (met.second) continue;
            Face &other = faces_[met.first->second];
            faces_[index].across[k] = met.first->second;
            for (size_t m = 0; m < 3; ++m)
                if (other.corners[m] != edge.first && other.corners[m] != edge.second) other.across[m] = index;
        }
    }
}

void Directions::fill_cells()
{
    cells_.resize(6 * side_cells * side_cells);
    uint16_t face = 0;
    for (int side = 0; side < 6; ++side)
        for (int y = 0; y < side_cells; ++y)
            for (int x = 0; x < side_cells; ++x) {
                glm::dvec3 v;
                v[side / 2] = side % 2 ? -1 : 1;
                v[(side / 2 + 1) % 3] = (2 * y + 1.0) / side_cells - 1;
                v[(side / 2 + 2) % 3] = (2 * x + 1.0) / side_cells - 1;
                cells_[cell_of(v)] = face = walk(face, v);
            }
}

// Crosses the edge that v lies farthest beyond, until there is none.
uint16_t Directions::walk(uint16_t face, const glm::dvec3 &v) const
{
    const double tolerance = -1e-12 * (std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z));
    for (size_t step = 0; step < faces_.size(); ++step) {
        const glm::dvec3 weights = faces_[face].weights * v;
        const int k = weights.x <= weights.y && weights.x <= weights.z ? 0 : weights.y <= weights.z ? 1 : 2;
        if (weights[k] >= tolerance) break;
        face = faces_[face].across[size_t(k)];
    }
    return face;
}

DirectionBlend Directions::find(const glm::dvec3 &v) const
{
    const Face &face = faces_[walk(cells_[cell_of(v)], v)];
    const glm::dvec3 weights = glm::max(face.weights * v, glm::dvec3(0));
    return {face.corners, {float(weights.x), float(weights.y), float(weights.z)}};
}

}  // namespace claque::meshsplit
