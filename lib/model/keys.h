// Zone keys for GL (S1 3): the alpha of texels, and the references and vertex alphas that distinguish zones
// under glAlphaFunc(GL_GEQUAL, reference). Used by meshsplit, which renumbers keys, and by passes, which draw.
//
// The alpha of a fragment is texel key / 255 times vertex alpha (GL_MODULATE). The pass strategies keep the vertex
// alpha at 1 and change the reference; the fused strategy keeps the reference and changes the vertex alpha. `index` is
// the index of a zone's key in the ascending list of the texture. A hole has texel alpha 0 and passes no test below.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/base/span.h"
#include "lib/model/template.h"

namespace claque::model
{

using Keys = base::Span<const uint8_t>;  // strictly ascending

constexpr uint32_t lowest_key = 94;      // with two zones or more; a single zone has key 255
constexpr uint32_t max_zone_keys = 256;  // that one texture can have

// Returns `count` keys, 1 to 256 of them, strictly ascending up to 255. Steps are geometric from 94, since the fused
// product depends on the ratio of neighbours, and are at least 1; more than 162 keys begin below 94. Only 256 keys
// include 0, which then is not a hole. Throws base::Error (CLQ_LIMIT) for other counts.
std::vector<uint8_t> geometric_keys(uint32_t count);

std::vector<uint8_t> keys_of(const Texture &texture);

// The reference of the pass of zone `index`: under GL_GEQUAL its texels and those of higher keys pass, those of lower
// keys fail. For the lowest zone every texel but a hole passes. The value is slightly above the middle of the step, so
// that a GL that rounds it to 8 bits does not round it to the key below.
float pass_reference(Keys keys, uint32_t index);

// The reference of the fused strategy for every triangle: half a step below the lowest key.
float fused_reference(Keys keys);

// Vertex alpha of raised copies (slot 2 * index + 1, index >= 1): under fused_reference only keys >= keys[index] pass.
// Other vertices have alpha 1. One function for float colours, one for 8-bit colours.
float raised_alpha(Keys keys, uint32_t index);
uint8_t raised_alpha_8bit(Keys keys, uint32_t index);

struct FusedTable {
    float reference = 0;
    // Of raised copies, one per zone; [0] is 1 and unused, as the lowest zone is never raised.
    std::vector<float> alpha;
    std::vector<uint8_t> alpha_8bit;  // the same for glColor4ub and byte colour arrays
};
FusedTable fused_table(Keys keys);

// True if the tests above distinguish all keys on a GL that computes and compares alpha in `alpha_bits`, with a quarter
// of a step to spare on both sides. 8 bits: old or unknown hardware; 24: float pipelines. fused_accepts checks both the
// float and the 8-bit vertex alphas.
bool fused_accepts(Keys keys, uint32_t alpha_bits);
bool passes_accept(Keys keys, uint32_t alpha_bits);

// The largest n for which geometric_keys(m) is accepted for every m <= n.
uint32_t fused_limit(uint32_t alpha_bits);
uint32_t passes_limit(uint32_t alpha_bits);

}  // namespace claque::model
