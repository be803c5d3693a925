// The list that drawing knows; nothing else. One per view, made by lib/frame, const for passes.
#pragma once

#include "lib/model/template.h"

namespace claque::draw
{

// Positions and normals of one individual, ready for glVertexPointer and glNormalPointer, one each per vertex of the
// level, copies included, in the actor's own space; as floats or packed, never both.
struct Vertices {
    const float *positions = nullptr;  // 3 a vertex
    const float *normals = nullptr;    // 3 a vertex

    const int16_t *short_positions = nullptr;  // 4 a vertex, of which the first three n mean offset + step * n
    const int8_t *byte_normals = nullptr;      // 4 a vertex, of which the first three count, 127 a unit
    float offset[3] = {0, 0, 0};
    float step = 1;

    bool packed() const { return short_positions != nullptr; }
    bool any() const { return (positions && normals) || (short_positions && byte_normals); }
};

// What a host does round the drawing of one individual (S0 7.1): before() may bind a texture of its own, and says so by
// returning 1; whatever else it leaves behind in GL reaches neither this individual nor the next.
struct Hooks {
    int32_t (*before)(void *user, uint32_t actor_index1, uint32_t actor_generation) = nullptr;  // may be null
    void (*after)(void *user, uint32_t actor_index1, uint32_t actor_generation) = nullptr;      // may be null
    void *user = nullptr;
};

struct Item {
    const model::Template *tmpl = nullptr;
    uint32_t level = 0;
    uint32_t actor_index = 0;           // row in the crowd: for picking and id pictures
    Vertices vertices;                  // null where the geometry cache was full: ask the server below
    uint32_t texture_set = 0;           // of the template
    const uint8_t *zone_rgb = nullptr;  // 3 a zone of the template, or null: the template's own colours
    float model_view[16];               // column-major: actor's space to eye space, made in double relative to the eye
    float eye_distance_m = 0;
    bool mirrored = false;  // an odd number of negative scales: front faces turn round

    uint64_t parts = ~uint64_t(0);  // bit k: part k of the level is drawn (S0 4.2 phase 3)
    // Of a template of rigid parts alone, whose parts GL's matrix stack is to place (S0 6.2.2, fTrack): for each node
    // that the level evaluates its matrix relative to its parent. Then `vertices` is not asked for. Null: place nothing.
    const math::Affine *locals = nullptr;
    const Hooks *hooks = nullptr;  // or null
    uint32_t generation = 0;       // of the actor, with actor_index
    bool shadow_only = false;      // seen by nobody but its shadow: kept alive, not drawn
    // In the world: its Reference Point, or its Skeleton Root where that follows the ground. Shadows fall on what is there.
    double ground[3] = {0, 0, 0};
};

// What the vertices of an item are skinned from: matrices [rig.palette.size()] of the entries that its level uses, and morph
// weights [rig.rest_weights.size()], where the template has any. Null palette: the item shows two poses blended.
struct Pose {
    const math::Affine *palette = nullptr;
    const float *weights = nullptr;
};

// Serves vertices of items that no cache holds, at draw time, into memory of its own that is good until the next call.
class VertexServer
{
public:
    virtual ~VertexServer() = default;
    virtual Vertices serve(const Item &item) = 0;
    virtual Pose pose(const Item &item) = 0;  // of any item; for who skins them himself
};

struct DrawList {
    explicit DrawList(std::pmr::memory_resource *memory) : items(memory) {}
    model::Array<Item>
        items;  // by template, texture set, front to back (frame/order.h), actor: order is part of the picture
    float projection[16] = {0};                            // column-major, as the view has it
    double eye[3] = {0, 0, 0};                             // in the world
    double world_to_eye[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // column-major: a rotation
    VertexServer *server = nullptr;
};

}  // namespace claque::draw
