// Points on a character's surface, and their positions in a pose. Internal to lib/lod.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "lib/base/span.h"
#include "lib/model/model.h"

namespace claque::lod
{

// The vertices of several parts in one pose of the rig, indexed through all parts.
class PosedParts
{
public:
    explicit PosedParts(std::vector<const model::Part *> parts);
    // `palette` and `weights` are those of pose::Workspace.
    void pose(const model::Rig &rig, base::Span<const math::Affine> palette, base::Span<const float> weights);

    struct Triangle {
        uint32_t part = 0;
        std::array<uint32_t, 3> vertices{};  // vertices of the part
    };
    const std::vector<Triangle> &triangles() const { return triangles_; }
    const model::Part &part(uint32_t index) const { return *parts_[index]; }
    uint32_t part_count() const { return static_cast<uint32_t>(parts_.size()); }
    glm::dvec3 vertex(uint32_t part, uint32_t v) const { return positions_[first_[part] + v]; }
    glm::dvec3 corner(const Triangle &t, size_t k) const { return positions_[first_[t.part] + t.vertices[k]]; }
    const std::vector<glm::dvec3> &positions() const { return positions_; }  // of all parts
    std::array<uint32_t, 3> vertices_of(uint32_t triangle) const             // indices into positions()
    {
        const Triangle &t = triangles_[triangle];
        const uint32_t first = first_[t.part];
        return {first + t.vertices[0], first + t.vertices[1], first + t.vertices[2]};
    }
    std::array<glm::dvec3, 3> corners(const Triangle &t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }
    std::vector<std::array<glm::dvec3, 3>> corners(const std::vector<uint32_t> &triangles) const;

private:
    std::vector<const model::Part *> parts_;
    std::vector<uint32_t> first_;
    std::vector<Triangle> triangles_;
    std::vector<glm::dvec3> positions_;
};

inline std::vector<const model::Part *> pointers(const std::vector<model::Part> &parts)
{
    std::vector<const model::Part *> out;
    for (const model::Part &part : parts) out.push_back(&part);
    return out;
}

PosedParts posed_at_rest(const model::Rig &rig, std::vector<const model::Part *> parts);

// Returns the rest positions of the parts' vertices in model space.
std::vector<std::vector<glm::vec3>> rest_positions(const model::Rig &rig,
                                                   const std::vector<const model::Part *> &parts);

// A point of the surface by barycentric coordinates.
struct SurfacePoint {
    uint32_t triangle = 0;
    glm::dvec3 weights = glm::dvec3(0);
};

glm::dvec3 position_of(const PosedParts &parts, const SurfacePoint &point);

// The column or row of texels that a texture coordinate is in.
uint32_t texel_index(double at, uint32_t size, model::Wrap wrap);
glm::dvec2 uv_at(const PosedParts &parts, const SurfacePoint &point);  // 0 without texture coordinates

// Returns the zone that a point shows: its material's, or that of the texel's zone key; model::none if there is none.
// `set`: one of the model's further texture sets; null: the first.
uint32_t zone_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                 const model::TextureSet *set = nullptr);

// The same for texture coordinates of a part.
uint32_t zone_at(const model::Model &model, const model::Part &part, glm::vec2 uv,
                 const model::TextureSet *set = nullptr);

// Whether the part's material cuts holes by alpha, and whether a point is in one: other surface is seen through it.
bool has_holes(const model::Model &model, const model::Part &part);
bool is_hole(const model::Model &model, const model::Part &part, glm::dvec2 uv,
             const model::TextureSet *set = nullptr);
bool is_hole(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
             const model::TextureSet *set = nullptr);

// Returns the texel at a point, with red, green and blue in [0, 1]; white if there is no image.
glm::dvec3 texel_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                    const model::TextureSet *set = nullptr);

// Samples of the whole surface: about `count`, and at least one on each triangle. They are the centres of the small
// triangles of a regular subdivision, with their areas.
struct SurfaceSample {
    SurfacePoint point;
    double area = 0;
};
constexpr double surface_sample_count = 20000;  // for measuring area fractions
std::vector<SurfaceSample> sample_surface(const PosedParts &parts, double count);

// Matches the samples of `from` with the nearest points of `to` in their present poses. The samples are, for each
// triangle, the centres of the four triangles that halving its sides makes, then its corners, for distances only. Of
// more than `dense_triangles` triangles each has only the first of these centres, and of more than `max_matched` only
// so many triangles have samples at all. The nearest point is on the part of the same index or, if that has no
// triangles, on any part.
constexpr size_t dense_triangles = 2500, max_matched = 10000;
struct PointPair {
    static constexpr uint8_t inside = 3;
    SurfacePoint here, there;
    uint8_t corner = inside;  // which corner of its triangle `here` is
    uint8_t weight = 1;       // a centre that stands for the other three counts as four
};
std::vector<PointPair> nearest_pairs(const PosedParts &from, const PosedParts &to);

// Samples of a surface of so many triangles that nearest_pairs() makes at most.
inline size_t max_pairs(size_t triangles)
{
    return triangles > dense_triangles ? 4 * (triangles < max_matched ? triangles : max_matched) : 7 * triangles;
}

// The same for several queries against one target; the trees are built once.
class PartTrees
{
public:
    // `part_counts`: of what will ask, if one number is known; trees that it needs not are then left out.
    explicit PartTrees(const PosedParts &to, uint32_t part_counts = model::none);
    ~PartTrees();
    std::vector<PointPair> nearest_pairs(const PosedParts &from) const;

private:
    struct Tree;
    uint32_t part_count_;                         // of the target
    std::vector<std::unique_ptr<Tree>> by_part_;  // empty if there is one part, or if it is not needed
    std::unique_ptr<Tree> all_;                   // null if there are no triangles, or if it is not needed
};
double area_of(const PosedParts &parts, uint32_t triangle);

// Returns the neighbours of each triangle: those that run along one of its edges in the opposite direction.
std::vector<std::vector<uint32_t>> neighbours_of(const PosedParts &parts);

}  // namespace claque::lod
