// Textures of one byte a texel, 0 in holes: GL 1.1 can take its alpha from such a texture and its colour from vertices.
#pragma once

#include "lib/draw/draw_list.h"
#include "passes/preflight.h"

namespace claque::passes
{

class HoleTextures
{
public:
    explicit HoleTextures(std::pmr::memory_resource *memory) : textures_(memory), texels_(memory) {}

    // Loads those of a list that are not there yet. Fails with CLQ_GL_STATE or CLQ_OUT_OF_MEMORY, and then keeps what
    // it had.
    base::Status prepare(const Gl11 &gl, const Preflight &preflight, const draw::DrawList &list);
    // The GL name; 0: the texture has no holes.
    uint32_t find(const model::Template &tmpl, uint32_t texture, uint32_t set) const;

    void destroy(const Gl11 &gl);
    void abandon() { textures_.clear(); }

private:
    struct One {
        const model::Template *tmpl;
        uint32_t texture, set, name;
    };
    bool load(const Gl11 &gl, const model::Template &tmpl, uint32_t texture, uint32_t set);

    model::Array<One> textures_;
    model::Array<uint8_t> texels_;
};

}  // namespace claque::passes
