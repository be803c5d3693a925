// Merges the visible parts of a model into one welded triangle mesh. Vertices that are equal in every attribute become
// one. Triangles without area in any pose are dropped. Front faces run counter-clockwise in every pose, also in parts
// on mirroring nodes.
#pragma once

#include "meshsplit/material_plan.h"

namespace claque::meshsplit
{

struct Influence {
    uint32_t joint = 0;
    float weight = 0;
};

struct VertexMorph {
    uint32_t weight = 0;  // index in the pose's weights
    glm::vec3 position = glm::vec3(0), normal = glm::vec3(0);
};

struct MeshVertex {
    glm::vec3 position = glm::vec3(0), normal = glm::vec3(0);
    glm::vec2 uv = glm::vec2(0);
    std::array<uint8_t, 4> colour = {255, 255, 255, 255};
    uint32_t surface = 0;
    uint32_t first_influence = 0, influence_count = 0;
    uint32_t first_morph = 0, morph_count = 0;
};

struct MeshTriangle {
    std::array<uint32_t, 3> corners = {0, 0, 0};
    uint32_t surface = 0;
    uint32_t part = 0;  // part of the model
};

struct MeshSurface {
    uint32_t texture = 0;  // index in MaterialPlan::textures
    bool double_sided = false;
    model::Lighting lighting;
};

struct Mesh {
    std::vector<MeshVertex> vertices;     // by number of influences, then as in vertex_order.h
    std::vector<MeshTriangle> triangles;  // in input order
    std::vector<Influence> influences;    // largest weight first within a vertex
    std::vector<VertexMorph> morphs;
    std::vector<MeshSurface> surfaces;  // only those that have triangles
    bool has_colours = false;
    uint32_t parts = 0;       // that have triangles, however many are culled as one
    uint32_t degenerate = 0;  // triangles that were dropped
    uint32_t coincident = 0;  // triangles that z-fight with an earlier triangle on the same points
};

// Selects what is merged, and for which palette.
struct Selection {
    const model::Rig *rig = nullptr;      // the model's, or one whose palette extends the model's
    std::vector<uint32_t> parts;          // parts of the model, ascending
    std::vector<uint32_t> entries;        // for each palette entry of the model, the entry that vertices follow
    std::vector<uint32_t> first_weights;  // for each morph set of the model, its first weight
};

Selection all_visible(const model::Model &model);  // as the model has it

Mesh merge(const model::Model &model, const MaterialPlan &materials, const Selection &selection);
// Merges all visible parts without changes.
Mesh merge(const model::Model &model, const MaterialPlan &materials);

}  // namespace claque::meshsplit
