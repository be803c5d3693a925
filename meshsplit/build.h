// Builds a Template from a Model, once, at start-up: zones become renumbered textures, triangles become clean bins and
// dirty ranges, and the fused stream, its vertex copies and the Sklsroot Bsphere are added. S1 3, S2 2.1.
#pragma once

#include "lib/base/services.h"
#include "meshsplit/motion.h"

namespace claque::meshsplit
{

struct BuildOptions {
    // Larger images are reduced through the size pyramid. Rounded down to a power of two.
    uint32_t max_texture_px = 1024;
    MotionTolerance motion;
    base::Jobs jobs;  // runs the work in parallel; the result does not depend on it
};

// `out` is empty and uses the memory resource of the template. Checks the model first. Throws base::Error (ARGUMENT: a
// broken rule of the model, an image with a key that no zone declares, nothing to draw; LIMIT) or std::bad_alloc; `out`
// may then only be destroyed. The same model gives the same bytes, whatever the jobs. With jobs, several threads
// allocate `out`'s memory at once.
void build(const model::Model &model, const BuildOptions &options, model::Template &out);

}  // namespace claque::meshsplit
