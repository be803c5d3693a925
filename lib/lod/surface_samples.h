// Places on a character's surface, and where they are in a pose. Between the files of this room only.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lib/base/span.h"
#include "lib/model/model.h"

namespace claque::lod
{

// Vertices of several parts in one pose of the rig, numbered through all parts.
class PosedParts
{
public:
    explicit PosedParts(std::vector<const model::Part *> parts);
    // palette and weights as pose::Workspace gives them.
    void pose(const model::Rig &rig, base::Span<const math::Affine> palette, base::Span<const float> weights);

    struct Triangle {
        uint32_t part = 0;
        std::array<uint32_t, 3> vertices{};  // of the part
    };
    const std::vector<Triangle> &triangles() const { return triangles_; }
    const model::Part &part(uint32_t index) const { return *parts_[index]; }
    uint32_t part_count() const { return static_cast<uint32_t>(parts_.size()); }
    glm::dvec3 vertex(uint32_t part, uint32_t v) const { return positions_[first_[part] + v]; }
    glm::dvec3 corner(const Triangle &t, size_t k) const { return positions_[first_[t.part] + t.vertices[k]]; }
    const std::vector<glm::dvec3> &positions() const { return positions_; }  // of all parts
    std::array<uint32_t, 3> vertices_of(uint32_t triangle) const             // in positions()
    {
        const Triangle &t = triangles_[triangle];
        const uint32_t first = first_[t.part];
        return {first + t.vertices[0], first + t.vertices[1], first + t.vertices[2]};
    }
    std::array<glm::dvec3, 3> corners(const Triangle &t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }

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

// Where the vertices of parts are at rest, in the space of the model.
std::vector<std::vector<glm::vec3>> rest_positions(const model::Rig &rig,
                                                   const std::vector<const model::Part *> &parts);

// A place: so much of each corner of a triangle.
struct SurfacePoint {
    uint32_t triangle = 0;
    glm::dvec3 weights = glm::dvec3(0);
};

glm::dvec3 position_of(const PosedParts &parts, const SurfacePoint &point);

// The zone that a place shows: its material's, or that of the texel's key; model::none where there is none. `set`: what it
// shows in one of the model's further texture sets; null: in the first.
uint32_t zone_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                 const model::TextureSet *set = nullptr);

// Of a part, at a place in its texture.
uint32_t zone_at(const model::Model &model, const model::Part &part, glm::vec2 uv,
                 const model::TextureSet *set = nullptr);

// The texel there, each of red, green and blue in [0, 1]; white where there is no image.
glm::dvec3 texel_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                    const model::TextureSet *set = nullptr);

// Places that stand for the whole surface, about `count` and one at least on each triangle: middles of small triangles that
// lines along the sides make, and their areas.
struct SurfaceSample {
    SurfacePoint point;
    double area = 0;
};
constexpr double surface_sample_count = 20000;  // that shares of area are measured by
std::vector<SurfaceSample> sample_surface(const PosedParts &parts, double count);

// Each place of `from` that stands for its surface (middles of the four triangles that halving the sides of each triangle
// makes, a quarter of its area each; then its corners, for distances alone), and the place of `to` nearest to it as they
// are posed now: of the part of the same number or, where that has no triangle, of any.
struct PointPair {
    SurfacePoint here, there;
};
constexpr size_t samples_per_triangle = 7, area_samples = 4;
std::vector<PointPair> nearest_pairs(const PosedParts &from, const PosedParts &to);

// The same, where several are held against one: what is found by is made once.
class PartTrees
{
public:
    explicit PartTrees(const PosedParts &to);
    ~PartTrees();
    std::vector<PointPair> nearest_pairs(const PosedParts &from) const;

private:
    struct Tree;
    std::vector<std::unique_ptr<Tree>> by_part_;  // none where there is one part
    std::unique_ptr<Tree> all_;                   // none where there is no triangle
};
double area_of(const PosedParts &parts, uint32_t triangle);

// Of each triangle those that go along one of its edges the other way, as neighbours on a surface do.
std::vector<std::vector<uint32_t>> neighbours_of(const PosedParts &parts);

}  // namespace claque::lod
