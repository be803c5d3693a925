// Draws many individuals of few triangles with one call, because the call would cost more than its triangles. Their
// vertices are transformed to eye space here and stored one individual after the other in one set of arrays, in the
// order of the draw list.
#pragma once

#include "passes/canvas.h"

namespace claque::passes
{

class Batch
{
public:
    Batch(const Gl11 &gl, const RendererOptions &options, GlState &state, Scratch &scratch, DrawStats &stats)
        : gl_(gl), options_(options), state_(state), scratch_(scratch), stats_(stats)
    {
    }

    // True for levels that can be batched: one surface without dirty triangles, so that no alpha test is needed, and at
    // most `max_triangles` triangles. This does not depend on the strategy, so that all strategies give the same
    // picture.
    static bool fits(const model::Template &tmpl, const model::Level &level, uint32_t max_triangles);
    // True for individuals that can be batched: without hooks, without a texture of the host, and without rigid parts
    // on GL's matrix stack.
    bool takes(const Individual &individual) const;

    // Flushes first if the batch has another state or no space left.
    void add(const Individual &individual);
    // Draws the batch. To be called before anything else is drawn, and at the end.
    void flush();

private:
    // Space in the arrays.
    struct ArrayCounts {
        uint32_t vertices, indices;
    };
    static ArrayCounts counts_of(const Individual &individual);

    void add_vertices(const Individual &individual);
    void add_flat(const Individual &individual);
    void add_colours(const Individual &individual);
    void add_triangles(const Individual &individual);

    const Gl11 &gl_;
    const RendererOptions &options_;
    GlState &state_;
    Scratch &scratch_;
    DrawStats &stats_;
    SurfaceState surface_;
    uint32_t vertices_ = 0, indices_ = 0;
};

}  // namespace claque::passes
