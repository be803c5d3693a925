// Visible parts of a model as one welded triangle mesh: vertices equal in every attribute are one, triangles that
// have no area in any pose are dropped, front faces run counter-clockwise in every pose of a part that hangs mirrored.
#pragma once

#include "meshsplit/material_plan.h"

namespace claque::meshsplit
{

struct Influence {
    uint32_t joint = 0;
    float weight = 0;
};

struct VertexMorph {
    uint32_t weight = 0;  // of the pose's list
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
    uint32_t part = 0;  // of the model
};

struct MeshSurface {
    uint32_t texture = 0;  // of Looks::textures
    bool double_sided = false;
};

struct Mesh {
    std::vector<MeshVertex> vertices;     // by number of influences, then as vertex_order.h says
    std::vector<MeshTriangle> triangles;  // input order
    std::vector<Influence> influences;    // largest weight first within a vertex
    std::vector<VertexMorph> morphs;
    std::vector<MeshSurface> surfaces;  // those that have triangles
    bool has_colours = false;
    uint32_t degenerate = 0;  // dropped
    uint32_t coincident = 0;  // lie on an earlier triangle and tie with it in depth
};

// What of a model is merged, and for which palette.
struct Selection {
    const model::Rig *rig = nullptr;  // the model's, or one whose palette goes on where that ends
    std::vector<uint32_t> parts;      // of the model, ascending
    std::vector<uint32_t> entries;    // for each entry of the model's palette the one that vertices follow instead
};

Mesh merge(const model::Model &model, const MaterialPlan &materials, const Selection &selection);
// All visible parts, as they are.
Mesh merge(const model::Model &model, const MaterialPlan &materials);

}  // namespace claque::meshsplit
