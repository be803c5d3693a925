// Draws shadows of several individuals in one call: flattened triangles in eye space, one individual after the other.
#pragma once

#include <glm/vec3.hpp>

#include "passes/gl11.h"
#include "passes/shadow.h"
#include "passes/span_mask.h"

namespace claque::passes
{

using model::Array;

// Memory of shadows. It only grows.
struct ShadowArrays {
    static constexpr uint32_t batch_vertices = 2048, batch_indices = 8192;

    explicit ShadowArrays(std::pmr::memory_resource *memory)
        : flat(memory), window(memory), positions(memory), indices(memory), mask(memory)
    {
    }
    void reserve(uint32_t vertices);  // throws std::bad_alloc

    Array<float> flat;        // one individual flattened on the ground, in eye space, 3 per vertex
    Array<glm::vec3> window;  // the same in pixels, with the w of clip space
    Array<float> positions;   // of a batch
    Array<uint16_t> indices;
    SpanMask mask;
};

// Flattened triangles. `positions`: in eye space, 3 per vertex.
struct FlattenedMesh {
    const float *positions = nullptr;
    uint32_t vertices = 0;
    const uint32_t *indices = nullptr;
    uint32_t count = 0;  // of indices
};

class ShadowBatch
{
public:
    ShadowBatch(const Gl11 &gl, ShadowArrays &arrays, ShadowStats &stats) : gl_(gl), arrays_(arrays), stats_(stats) {}

    // Flushes first if no space is left; draws large meshes alone.
    void add(const FlattenedMesh &flat);
    // Adds two triangles with these corners in cyclic order.
    void add(const glm::vec3 (&corners)[4]);
    // Draws the batch. To be called before anything else is drawn, and at the end.
    void flush();
    // Draws triangles of arrays that GL already has.
    void draw(const uint32_t *indices, uint32_t count);

private:
    void make_room(uint32_t vertices, uint32_t indices);
    void load_identity();

    const Gl11 &gl_;
    ShadowArrays &arrays_;
    ShadowStats &stats_;
    uint32_t vertices_ = 0, indices_ = 0;
};

}  // namespace claque::passes
