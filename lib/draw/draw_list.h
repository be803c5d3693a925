// The draw list, the only input of drawing. lib/frame makes one per view; it is const for passes. All memory that it
// points at stays valid and unchanged until the next update.
#pragma once

#include "lib/model/template.h"

namespace claque::draw
{

// Positions and normals of one individual, ready for glVertexPointer and glNormalPointer: one each per vertex of the
// level, copies included, in the actor's own space; as floats or packed, never both.
struct Vertices {
    const float *positions = nullptr;  // 3 per vertex
    const float *normals = nullptr;    // 3 per vertex

    const int16_t *short_positions = nullptr;  // 4 per vertex: the first three, n, mean offset + step * n
    const int8_t *byte_normals = nullptr;      // 4 per vertex: the first three are the normal, times 127
    float offset[3] = {0, 0, 0};
    float step = 1;

    bool packed() const { return short_positions != nullptr; }
    bool any() const { return (positions && normals) || (short_positions && byte_normals); }

    glm::vec3 position(uint32_t vertex) const
    {
        if (!packed())
            return glm::vec3(positions[3 * size_t(vertex)], positions[3 * size_t(vertex) + 1],
                             positions[3 * size_t(vertex) + 2]);
        const int16_t *n = short_positions + 4 * size_t(vertex);
        return glm::vec3(offset[0] + step * static_cast<float>(n[0]), offset[1] + step * static_cast<float>(n[1]),
                         offset[2] + step * static_cast<float>(n[2]));
    }
    glm::vec3 normal(uint32_t vertex) const
    {
        if (!packed())
            return glm::vec3(normals[3 * size_t(vertex)], normals[3 * size_t(vertex) + 1],
                             normals[3 * size_t(vertex) + 2]);
        const int8_t *n = byte_normals + 4 * size_t(vertex);
        return glm::vec3(n[0], n[1], n[2]) / 127.0f;
    }
};

// A host's callbacks round the drawing of one individual (S0 7.1): before() may bind a texture of its own and then
// returns 1. Other changes to GL state affect neither this individual nor the next.
struct Hooks {
    int32_t (*before)(void *user, uint32_t actor_index1, uint32_t actor_generation) = nullptr;  // may be null
    void (*after)(void *user, uint32_t actor_index1, uint32_t actor_generation) = nullptr;      // may be null
    void *user = nullptr;
};

// What the vertices of an item were skinned from: matrices [rig.palette.size()] of the entries that its level uses, and
// morph weights [rig.rest_weights.size()], if the template has any.
struct Pose {
    const math::Affine *palette = nullptr;
    const float *weights = nullptr;
};

struct Item {
    const model::Template *tmpl = nullptr;
    uint32_t level = 0;
    uint32_t actor_index = 0;           // row in the crowd: for picking and id pictures
    Vertices vertices;                  // null: placed by `locals`, or skipped for lack of memory
    uint32_t texture_set = 0;           // of the template
    const uint8_t *zone_rgb = nullptr;  // 3 per zone of the template, or null: the template's own colours
    float model_view[16];  // column-major: actor's space to eye space, computed in double relative to the eye
    float eye_distance_m = 0;
    bool mirrored = false;  // an odd number of negative scales: front faces are wound the other way

    uint64_t parts = ~uint64_t(0);  // bit k: part k of the level is drawn (S0 4.2 phase 3)
    // Of a template of rigid parts that GL's matrix stack places (S0 6.2.2, fTrack): for each node that the level
    // evaluates, its matrix relative to its parent. There are no `vertices` then. Null: GL places nothing.
    const math::Affine *locals = nullptr;
    Pose pose;                     // of `vertices`; null for kept key-poses
    const Hooks *hooks = nullptr;  // or null
    uint32_t generation = 0;       // of the actor, with actor_index
    uint32_t request = 0;          // its number in the update, from which the pose can be found again
    bool shadow_only = false;      // only its shadow is visible: updated, not drawn
    // In the world: its Reference Point, or its Skeleton Root if that follows the ground. Shadows fall on the ground
    // there.
    double ground[3] = {0, 0, 0};
};

struct DrawList {
    explicit DrawList(std::pmr::memory_resource *memory) : items(memory) {}
    model::Array<Item>
        items;  // by template, texture set, front to back (frame/order.h), actor: order is part of the picture
    float projection[16] = {0};                            // column-major, from the view
    double eye[3] = {0, 0, 0};                             // in the world
    double world_to_eye[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // column-major: a rotation
    // At eye_distance_m * distance_scale + min_distance_m an individual is as large in a picture of 768 lines over 60
    // degrees.
    float distance_scale = 1, min_distance_m = 0;
};

}  // namespace claque::draw
