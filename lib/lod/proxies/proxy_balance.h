// Balances the area fractions of zones in the image of a proxy. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/proxy_image.h"

namespace claque::lod
{

// A texel of a proxy's image.
struct ProxyTexel {
    bool used = false;
    uint32_t zone = model::none;
    glm::dvec3 rgb = glm::dvec3(0);
    glm::dvec3 at = glm::dvec3(0);  // rest position on the level
    double area = 0;                // as a fraction of the level's area
};

// Moves the borders of zones whose area fraction differs from the source's by more than is allowed. Texels change to a
// zone that is almost as close, those closest to it first, and take its colour at the nearest point.
void balance_zones(const ProxySource &source, size_t set, std::vector<ProxyTexel> &texels);

}  // namespace claque::lod
