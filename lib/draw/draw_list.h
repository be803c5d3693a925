// The list that drawing knows; nothing else. One per view, made by lib/frame, const for passes.
#pragma once

#include "lib/model/template.h"

namespace claque::draw
{

// Positions and normals of one individual, ready for glVertexPointer and glNormalPointer: 3 floats each per vertex of
// the level, copies included, in the actor's own space.
struct Vertices {
    const float *positions = nullptr;
    const float *normals = nullptr;
};

struct Item {
    const model::Template *tmpl = nullptr;
    uint32_t level = 0;
    uint32_t actor_index = 0;           // row in the crowd: for picking and id pictures
    Vertices vertices;                  // null where the geometry cache was full: ask the server below
    const uint8_t *zone_rgb = nullptr;  // 3 a zone of the template, or null: the template's own colours
    float model_view[16];               // column-major: actor's space to eye space, made in double relative to the eye
    float eye_distance_m = 0;
    bool mirrored = false;  // an odd number of negative scales: front faces turn round
};

// Serves vertices of items that no cache holds, at draw time, into memory of its own that is good until the next call.
class VertexServer
{
public:
    virtual ~VertexServer() = default;
    virtual Vertices serve(const Item &item) = 0;
};

struct DrawList {
    explicit DrawList(std::pmr::memory_resource *memory) : items(memory) {}
    model::Array<Item> items;    // sorted by template, then front to back, then by actor: order is part of the picture
    float projection[16] = {0};  // column-major, as the view has it
    VertexServer *server = nullptr;
};

}  // namespace claque::draw
