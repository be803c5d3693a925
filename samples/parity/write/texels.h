// A texture of a template in one of its texture sets, row 0 at v = 0.
#pragma once

#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>

#include <cstdint>
#include <vector>

namespace parity
{

struct Texels {
    Texels() = default;
    // Throws scenes::Failure.
    Texels(const clq_template *tmpl, uint32_t texture, uint32_t texture_set);

    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;     // 3 a texel
    std::vector<uint32_t> zones;  // of the template; CLQ_NONE: a hole
    clq_wrap wrap_s = CLQ_WRAP_REPEAT, wrap_t = CLQ_WRAP_REPEAT;
};

// As PNG: RGB unchanged, alpha zone + 1, 0 in holes. Throws scenes::Failure if a zone has no number in 8 bits.
std::vector<uint8_t> png_of(const Texels &texels);

}  // namespace parity
