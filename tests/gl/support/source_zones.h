// The zones that a model's images name, texel by texel, in the size in which a template shows them. Written after what
// meshsplit/pyramid.h says of sizes, in the plainest way, and sharing no code with it.
#pragma once

#include <map>
#include <string>

#include "lib/model/model.h"
#include "tests/gl/support/posed_model.h"

namespace gltest
{

// The zones of a model: its own, then one for each base colour of the materials without one, named after the first.
std::vector<std::string> zone_names_of(const model::Model &source);

struct ZoneTexels {
    uint32_t width = 1, height = 1;
    std::vector<uint16_t> zones;  // indices of zone_names_of(), or `hole`; row v = 0 first
    // Mirrored sides are doubled, so that repeating at half the coordinate looks the same: where the size changes.
    bool unfolded_s = false, unfolded_t = false;
};

// What the materials of a model show in textures of at most `most_px`, made when it is first asked for.
class SourceImages
{
public:
    explicit SourceImages(const model::Model &source, uint32_t most_px = 1024) : source_(source), most_px_(most_px) {}

    const model::Model &source() const { return source_; }
    const ZoneTexels &of(uint32_t material, uint32_t texture_set);

private:
    ZoneTexels made(uint32_t material, uint32_t texture_set) const;

    const model::Model &source_;
    uint32_t most_px_;
    std::map<std::pair<uint32_t, uint32_t>, ZoneTexels> made_;
};

}  // namespace gltest
