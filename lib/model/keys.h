// Zone keys as GL sees them: what the texture's alpha holds, and the references and vertex alphas that tell zones apart
// under glAlphaFunc(GL_GEQUAL, reference). Shared by meshsplit, which renumbers, and passes, which draws. S1 3, SPEC 3.
//
// A fragment's alpha is texel key / 255 times vertex alpha (GL_MODULATE). Pass strategies keep the vertex alpha at 1
// and move the reference; the fused strategy keeps the reference and moves the vertex alpha. Zones are counted by
// `index`, the place of a key in the texture's ascending list; a hole is texel alpha 0 and passes no test below.
#pragma once

#include "lib/base/span.h"
#include "lib/model/template.h"

#include <cstdint>
#include <vector>

namespace claque::model
{

using Keys = base::Span<const uint8_t>;  // strictly ascending

constexpr uint32_t lowest_key = 94;      // with two zones or more; one zone alone is 255
constexpr uint32_t max_zone_keys = 256;  // that one texture can tell apart at all

// `count` keys [1, 256], strictly ascending up to 255: geometric steps from 94 (a ratio between neighbours is what
// the fused product sees), steps of at least 1, from below 94 where more than 162 are asked for. Only 256 of them
// hold a key 0, which then is no hole. Throws base::Error (CLQ_LIMIT) for other counts.
std::vector<uint8_t> geometric_keys(uint32_t count);

std::vector<uint8_t> keys_of(const Texture &texture);

// The pass of zone `index`: GL_GEQUAL this passes its texels and those of higher keys, never lower ones. For the
// lowest: passes every texel but a hole. A trifle above halfway, so that GLs that round the reference to 8 bits do not
// round it onto the key below.
float pass_reference(Keys keys, uint32_t index);

// The one reference of the fused strategy, for every triangle: half a step below the lowest key.
float fused_reference(Keys keys);

// Vertex alpha of raised copies (slot 2 * index + 1): under fused_reference it passes keys >= keys[index] only.
// Unraised vertices have alpha 1. index >= 1. The first for float colours, the second for 8-bit ones.
float raised_alpha(Keys keys, uint32_t index);
uint8_t raised_alpha_8bit(Keys keys, uint32_t index);

struct FusedTable {
    float reference = 0;
    std::vector<float> alpha;         // of raised copies, one a zone; [0] is 1 and unused: the lowest is never raised
    std::vector<uint8_t> alpha_8bit;  // the same as glColor4ub and colour arrays of bytes take it
};
FusedTable fused_table(Keys keys);

// Whether the tests above tell all keys apart where the GL computes and compares alpha in `alpha_bits` (8 for old
// hardware and for all that is not known better; 24 for float pipelines), with a quarter of a step to spare on both
// sides. fused_accepts looks at both the float and the 8-bit vertex alphas.
bool fused_accepts(Keys keys, uint32_t alpha_bits);
bool passes_accept(Keys keys, uint32_t alpha_bits);

// The largest n such that geometric_keys(m) is accepted for every m <= n.
uint32_t fused_limit(uint32_t alpha_bits);
uint32_t passes_limit(uint32_t alpha_bits);

}  // namespace claque::model
