// Individuals of few triangles, many with one call: what a call costs is then more than what it draws. Their vertices are
// moved to eye space here and stand one behind the other in one set of arrays, in the order of the list.
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

    // What may stand in a batch: levels of one surface without dirty triangles, so that nobody needs an alpha test of its
    // own, of `most` triangles at most. It does not depend on the strategy, so that all strategies show the same.
    static bool fits(const model::Template &tmpl, const model::Level &level, uint32_t max_triangles);
    // And who: nobody whose host draws round it, lends it a texture or places its parts by GL's matrix stack.
    bool takes(const Individual &individual) const;

    // Draws what it holds first where that has another state or leaves no room.
    void add(const Individual &individual);
    // Draws what it holds. To be called before anything else is drawn, and at the end.
    void flush();

private:
    // How much of the arrays somebody takes.
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
