// Model to Template, once, at start-up: zones to renumbered textures, triangles to clean bins and dirty ranges, the
// fused stream with its copies, the Sklsroot sphere. S1 3, S2 2.1, SPEC 3.
#pragma once

#include "lib/base/services.h"
#include "meshsplit/motion.h"

namespace claque::meshsplit
{

struct BuildOptions {
    // Larger images are reduced through the size pyramid; rounded down to a power of two.
    uint32_t max_texture_px = 1024;
    MotionTolerance motion;
    base::Jobs jobs;  // what is spread over; nothing depends on it
};

// `out` is empty, made on the memory that the template shall live on. Checks the model first. Throws base::Error
// (ARGUMENT: a broken rule of the model, an image with a key that no zone declares, nothing to draw; LIMIT) or
// std::bad_alloc; `out` is then good for nothing but destruction. The same model gives the same bytes, whatever the jobs; with
// some, `out`'s memory is asked for from several at once.
void build(const model::Model &model, const BuildOptions &options, model::Template &out);

}  // namespace claque::meshsplit
