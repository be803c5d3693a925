#include "meshsplit/parts.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "meshsplit/enclosing.h"
#include "meshsplit/morph_limits.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

// Returns the lowest common ancestor, which may be one of them; for nodes in different trees, the root above the first.
uint32_t above_both(const model::Rig &rig, uint32_t a, uint32_t b)
{
    uint32_t root = a;
    while (rig.parents[root] != none) root = rig.parents[root];
    while (a != b) {
        uint32_t &later = a > b ? a : b;
        later = rig.parents[later];
        if (later == none) return root;
    }
    return a;
}

class PartMaker
{
public:
    PartMaker(const Mesh &mesh, const model::Rig &rig, model::Level &level)
        : mesh_(mesh),
          rig_(rig),
          limits_(morph_limits(rig)),
          level_(level),
          seen_(mesh.vertices.size(), none),
          balls_(rig.palette.size())
    {
    }

    // Triangles are sorted by part.
    void run(uint32_t part_count)
    {
        size_t first = 0;
        for (uint32_t p = 0; p < part_count; ++p) {
            size_t last = first;
            while (last < mesh_.triangles.size() && mesh_.triangles[last].part == p) ++last;
            for (size_t t = first; t < last; ++t)
                for (const uint32_t v : mesh_.triangles[t].corners)
                    if (seen_[v] != p) seen_[v] = p, collect(mesh_.vertices[v]);
            add(static_cast<uint32_t>(last - first));
            first = last;
        }
    }

private:
    void collect(const MeshVertex &vertex)
    {
        Ball ball;
        ball.centre = glm::dvec3(vertex.position);
        for (uint32_t m = 0; m < vertex.morph_count; ++m) {
            const VertexMorph &morph = mesh_.morphs[vertex.first_morph + m];
            const double low = double(limits_[morph.weight].low), high = double(limits_[morph.weight].high);
            ball.centre += (low + high) / 2 * glm::dvec3(morph.position);
            ball.radius += (high - low) / 2 * glm::length(glm::dvec3(morph.position));
        }
        for (uint32_t i = 0; i < vertex.influence_count; ++i)
            balls_[mesh_.influences[vertex.first_influence + i].joint].push_back(ball);
    }

    void add(uint32_t triangles)
    {
        model::LevelPart part;
        part.triangles = triangles;
        part.first_sphere = static_cast<uint32_t>(level_.part_spheres.size());
        for (uint32_t e = 0; e < balls_.size(); ++e) {
            if (balls_[e].empty()) continue;
            const uint32_t node = rig_.palette[e].node;
            part.node = part.sphere_count == 0 ? node : above_both(rig_, part.node, node);
            ++part.sphere_count;
            level_.part_spheres.push_back({e, enclosing(balls_[e])});
            balls_[e].clear();
        }
        level_.parts.push_back(part);
    }

    const Mesh &mesh_;
    const model::Rig &rig_;
    const std::vector<WeightLimits> limits_;
    model::Level &level_;
    std::vector<uint32_t> seen_;            // per vertex, the last part that used it
    std::vector<std::vector<Ball>> balls_;  // of the current part, per palette entry
};

}  // namespace

uint32_t number_parts(Mesh &mesh)
{
    uint32_t count = 0, last = none;
    for (MeshTriangle &triangle : mesh.triangles) {
        if (triangle.part != last) last = triangle.part, ++count;
        triangle.part = count - 1;
    }
    mesh.parts = count;
    if (count <= model::max_level_parts) return count;
    for (MeshTriangle &triangle : mesh.triangles)
        triangle.part = static_cast<uint32_t>(uint64_t(triangle.part) * model::max_level_parts / count);
    return model::max_level_parts;
}

void make_parts(const Mesh &mesh, uint32_t part_count, const model::Rig &rig, model::Level &out)
{
    PartMaker(mesh, rig, out).run(part_count);
}

}  // namespace claque::meshsplit
