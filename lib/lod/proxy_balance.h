// Shares of zones in the image of a far level. Between the files of this room only.
#pragma once

#include "lib/lod/proxy_image.h"

namespace claque::lod
{

// What a texel shows.
struct ProxyTexel {
    bool used = false;
    uint32_t zone = model::none;
    glm::dvec3 rgb = glm::dvec3(0);
    glm::dvec3 at = glm::dvec3(0);  // at rest, on the level
    double area = 0;                // on which it is shown, in shares of the level's
};

// Where some zone has more or less of the level than of the source's surface, by more than is allowed, its borders move: texels
// change to a zone that is nearly as near, those first that are nearest to it, and show what is there.
void balance_zones(const ProxySource &source, size_t set, std::vector<ProxyTexel> &texels);

}  // namespace claque::lod
