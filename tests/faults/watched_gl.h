// The stub GL with a memory: what was drawn, with which state, which objects exist. Its context can be lost at any
// call.
#pragma once

#include <claque/renderer.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace watched_gl
{

clq_gl_function find(void *, const char *name);  // for clq_renderer_def.get_proc_address

enum class Loss {
    none,
    context,      // from the n-th call on no call has an effect, and glGetString returns NULL
    image_memory  // the n-th call, if it is glTexImage2D, has no effect: GL_OUT_OF_MEMORY
};

void lose(Loss kind, uint64_t n);  // counted from now on
uint64_t calls();                  // since lose()
void new_context();                // with nothing in it, and none lost

uint64_t picture();   // a hash of all that was drawn since the last call of this: arrays, state, textures
uint64_t state();     // a hash of all state that calls may set
uint64_t textures();  // a hash of all textures: names, sizes, texels, parameters
size_t texture_count();

}  // namespace watched_gl
