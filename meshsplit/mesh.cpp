#include "meshsplit/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "meshsplit/interner.h"
#include "meshsplit/rest.h"
#include "meshsplit/vertex_order.h"

namespace claque::meshsplit
{

using model::none;
using model::Part;

namespace
{

class Merger
{
public:
    Merger(const model::Model &model, const MaterialPlan &materials, const Selection &selection)
        : model_(model), materials_(materials), selection_(selection), rest_(rest_palette(*selection.rig))
    {
        for (const uint32_t p : selection.parts)
            if (!model.parts[p].colours.empty()) mesh_.has_colours = true;
    }

    Mesh run()
    {
        for (const uint32_t p : selection_.parts) add_part(p);
        sort_for_skinning();
        return std::move(mesh_);
    }

private:
    // The motion of a part's vertex, which all its triangles share.
    struct Source {
        uint32_t point = none;    // vertices with equal points move alike in every pose
        uint32_t influences = 0;  // equal lists have equal numbers
        uint32_t first_influence = 0, influence_count = 0;
        uint32_t first_morph = 0, morph_count = 0;
    };

    void add_part(uint32_t index)
    {
        const Part &part = model_.parts[index];
        const auto triangles = model::triangles_of(part);
        if (triangles.empty()) return;
        const MaterialMapping &mapping = materials_.of(part);
        sources_.assign(part.positions.size(), Source());
        welded_.assign(part.positions.size(), none);
        for (const auto &triangle : triangles) {
            for (const uint32_t v : triangle)
                if (sources_[v].point == none) sources_[v] = source_of(part, v);
            if (is_degenerate(part, triangle)) {
                ++mesh_.degenerate;
                continue;
            }
            add_triangle(part, mapping, surface_of(mapping), triangle);
            mesh_.triangles.back().part = index;
        }
    }

    uint32_t surface_of(const MaterialMapping &mapping)
    {
        const uint32_t next = static_cast<uint32_t>(mesh_.surfaces.size());
        const auto [place, is_new] =
            surfaces_.emplace(std::make_tuple(mapping.texture, mapping.double_sided, mapping.lighting), next);
        if (is_new) mesh_.surfaces.push_back({mapping.texture, mapping.double_sided, mapping.lighting});
        return place->second;
    }

    Source source_of(const Part &part, uint32_t v)
    {
        Source source;
        add_influences(part, v, source);
        add_morphs(part, v, source);
        point_numbers_.begin();
        point_numbers_.add(part.positions[v]);
        point_numbers_.add(source.influences);
        for (uint32_t m = 0; m < source.morph_count; ++m) {
            point_numbers_.add(mesh_.morphs[source.first_morph + m].weight);
            point_numbers_.add(mesh_.morphs[source.first_morph + m].position);
        }
        source.point = point_numbers_.number().first;
        return source;
    }

    void add_influences(const Part &part, uint32_t v, Source &source)
    {
        std::vector<Influence> list;
        float sum = 0;
        for (uint32_t k = 0; k < part.influence_count; ++k) {
            const size_t at = size_t(v) * part.influence_count + k;
            if (part.weights[at] == 0) continue;
            const uint32_t joint = selection_.entries[part.joints[at]];
            sum += part.weights[at];
            const auto same =
                std::find_if(list.begin(), list.end(), [&](const Influence &i) { return i.joint == joint; });
            if (same != list.end()) same->weight += part.weights[at];
            else list.push_back({joint, part.weights[at]});
        }
        std::sort(list.begin(), list.end(), [](const Influence &a, const Influence &b) {
            return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
        });
        if (std::fabs(sum - 1.0f) > 1e-6f)
            for (Influence &influence : list) influence.weight /= sum;
        influence_numbers_.begin();
        for (const Influence &influence : list)
            influence_numbers_.add(influence.joint), influence_numbers_.add(influence.weight);
        const auto [number, is_new] = influence_numbers_.number();
        if (is_new) {
            influence_starts_.push_back(static_cast<uint32_t>(mesh_.influences.size()));
            mesh_.influences.insert(mesh_.influences.end(), list.begin(), list.end());
        }
        source.influences = number;
        source.first_influence = influence_starts_[number];
        source.influence_count = static_cast<uint32_t>(list.size());
    }

    void add_morphs(const Part &part, uint32_t v, Source &source)
    {
        source.first_morph = static_cast<uint32_t>(mesh_.morphs.size());
        if (part.morphs.empty()) return;
        const uint32_t first_weight = selection_.first_weights[part.morph_set];
        for (uint32_t t = 0; t < part.morphs.size(); ++t) {
            VertexMorph morph;
            morph.weight = first_weight + t;
            if (!part.morphs[t].positions.empty()) morph.position = part.morphs[t].positions[v];
            if (!part.morphs[t].normals.empty()) morph.normal = part.morphs[t].normals[v];
            if (morph.position != glm::vec3(0) || morph.normal != glm::vec3(0)) mesh_.morphs.push_back(morph);
        }
        source.morph_count = static_cast<uint32_t>(mesh_.morphs.size()) - source.first_morph;
    }

    // A triangle has no area in any pose if two corners always coincide, or if all three follow the same joints and are
    // collinear.
    bool is_degenerate(const Part &part, const std::array<uint32_t, 3> &t) const
    {
        const Source &a = sources_[t[0]], &b = sources_[t[1]], &c = sources_[t[2]];
        if (a.point == b.point || b.point == c.point || c.point == a.point) return true;
        if (a.influences != b.influences || b.influences != c.influences) return false;
        if (a.morph_count || b.morph_count || c.morph_count) return false;
        return glm::length(cross_of(part, t)) == 0;
    }

    // In double, where differences and products of floats of similar size are exact.
    static glm::dvec3 cross_of(const Part &part, const std::array<uint32_t, 3> &t)
    {
        const glm::dvec3 a(part.positions[t[0]]), b(part.positions[t[1]]), c(part.positions[t[2]]);
        return glm::cross(b - a, c - a);
    }

    void add_triangle(const Part &part, const MaterialMapping &mapping, uint32_t surface,
                      const std::array<uint32_t, 3> &t)
    {
        const glm::dvec3 cross = cross_of(part, t);
        const double length = glm::length(cross);
        const glm::vec3 face = length > 0 ? glm::vec3(cross / length) : glm::vec3(0, 0, 1);
        std::array<uint32_t, 3> order = t;
        if (is_mirrored(t)) std::swap(order[1], order[2]);
        MeshTriangle triangle;
        triangle.surface = surface;
        for (size_t k = 0; k < 3; ++k) triangle.corners[k] = vertex_of(part, mapping, surface, order[k], face);
        mesh_.triangles.push_back(triangle);
        note_coincidence(order, mesh_.surfaces[surface].double_sided);
    }

    // Returns whether the joint with the largest weight mirrors the triangle at rest; front faces are defined on
    // screen.
    bool is_mirrored(const std::array<uint32_t, 3> &t) const
    {
        uint32_t best = none;
        float maximum = 0;
        for (const uint32_t v : t)
            for (uint32_t i = 0; i < sources_[v].influence_count; ++i) {
                const uint32_t joint = mesh_.influences[sources_[v].first_influence + i].joint;
                const float weight = weight_in(t, joint);
                if (best == none || weight > maximum || (weight == maximum && joint < best))
                    best = joint, maximum = weight;
            }
        return best != none && math::determinant(rest_[best]) < 0;
    }

    float weight_in(const std::array<uint32_t, 3> &t, uint32_t joint) const
    {
        float sum = 0;
        for (const uint32_t v : t)
            for (uint32_t i = 0; i < sources_[v].influence_count; ++i) {
                const Influence &influence = mesh_.influences[sources_[v].first_influence + i];
                if (influence.joint == joint) sum += influence.weight;
            }
        return sum;
    }

    uint32_t vertex_of(const Part &part, const MaterialMapping &mapping, uint32_t surface, uint32_t v, glm::vec3 face)
    {
        const float length = part.normals.empty() ? 0 : glm::length(part.normals[v]);
        const bool has_normal = length > 1e-12f;
        if (has_normal && welded_[v] != none) return welded_[v];
        const Source &source = sources_[v];
        MeshVertex vertex;
        vertex.position = without_negative_zero(part.positions[v]);
        vertex.normal = without_negative_zero(has_normal ? part.normals[v] / length : face);
        vertex.uv =
            mapping.uv_offset + mapping.uv_scale * (part.uvs.empty() ? glm::vec2(0) : part.uvs[v]) + glm::vec2(0.0f);
        if (!part.colours.empty()) vertex.colour = part.colours[v];
        vertex.colour[3] = 255;  // alpha is reserved for zones
        vertex.surface = surface;
        vertex.first_influence = source.first_influence, vertex.influence_count = source.influence_count;
        vertex.first_morph = source.first_morph, vertex.morph_count = source.morph_count;
        const uint32_t number = weld(vertex, source.influences);
        if (has_normal) welded_[v] = number;
        return number;
    }

    uint32_t weld(const MeshVertex &vertex, uint32_t influences)
    {
        vertex_numbers_.begin();
        vertex_numbers_.add(vertex.position), vertex_numbers_.add(vertex.normal);
        vertex_numbers_.add(vertex.uv.x), vertex_numbers_.add(vertex.uv.y);
        uint32_t colour = 0;
        std::memcpy(&colour, vertex.colour.data(), 4);
        vertex_numbers_.add(colour), vertex_numbers_.add(vertex.surface), vertex_numbers_.add(influences);
        for (uint32_t m = 0; m < vertex.morph_count; ++m) {
            const VertexMorph &morph = mesh_.morphs[vertex.first_morph + m];
            vertex_numbers_.add(morph.weight), vertex_numbers_.add(morph.position), vertex_numbers_.add(morph.normal);
        }
        const auto [number, is_new] = vertex_numbers_.number();
        if (is_new) mesh_.vertices.push_back(vertex);
        return number;
    }

    // Two triangles on the same three points z-fight if they face the same way or one is double-sided.
    void note_coincidence(const std::array<uint32_t, 3> &t, bool double_sided)
    {
        std::array<uint32_t, 3> p = {sources_[t[0]].point, sources_[t[1]].point, sources_[t[2]].point};
        std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
        const bool turned = p[1] > p[2];
        if (turned) std::swap(p[1], p[2]);
        face_numbers_.begin();
        for (const uint32_t point : p) face_numbers_.add(point);
        const auto [number, is_new] = face_numbers_.number();
        if (is_new) faces_seen_.push_back(0);
        const uint8_t own = double_sided ? 3 : turned ? 2 : 1;
        if (faces_seen_[number] & own) ++mesh_.coincident;
        faces_seen_[number] |= own;
    }

    void sort_for_skinning()
    {
        const std::vector<uint32_t> order = skinning_order(mesh_);
        std::vector<uint32_t> place(order.size());
        std::vector<MeshVertex> sorted;
        sorted.reserve(order.size());
        for (const uint32_t v : order) {
            place[v] = static_cast<uint32_t>(sorted.size());
            sorted.push_back(mesh_.vertices[v]);
        }
        mesh_.vertices = std::move(sorted);
        for (MeshTriangle &triangle : mesh_.triangles)
            for (uint32_t &corner : triangle.corners) corner = place[corner];
    }

    const model::Model &model_;
    const MaterialPlan &materials_;
    const Selection &selection_;
    const std::vector<math::Affine> rest_;
    Mesh mesh_;
    Interner influence_numbers_, point_numbers_, vertex_numbers_, face_numbers_;
    std::map<std::tuple<uint32_t, bool, model::Lighting>, uint32_t> surfaces_;  // by texture, sidedness and lighting
    std::vector<uint32_t> influence_starts_;
    std::vector<uint8_t> faces_seen_;
    std::vector<Source> sources_;   // of the current part
    std::vector<uint32_t> welded_;  // of the current part: vertices of the mesh
};

}  // namespace

Mesh merge(const model::Model &model, const MaterialPlan &materials, const Selection &selection)
{
    return Merger(model, materials, selection).run();
}

Mesh merge(const model::Model &model, const MaterialPlan &materials)
{
    return merge(model, materials, all_visible(model));
}

}  // namespace claque::meshsplit
