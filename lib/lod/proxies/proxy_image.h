// Bakes the images of proxies. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/proxy.h"
#include "lib/lod/proxies/swatch_zones.h"

namespace claque::lod
{

model::Image empty_image(uint32_t width, uint32_t height);
void set_texel(const ProxySource &source, size_t at, uint32_t zone, glm::dvec3 rgb, model::Image &image);

// Splits the vertices of a part, one for each different texture coordinate, in [0, 1], of their corners.
void split_by_uv(model::Part &part, const std::vector<glm::vec2> &corners);

// Gives each triangle of each part its zone in one brightness, from the source surface that is nearest to it, and sets
// texture coordinates. `chosen`: [parts]. Returns one image per texture set for all parts.
std::vector<model::Image> bake_swatches(const ProxySource &source, const std::vector<SwatchZones> &chosen,
                                        std::vector<model::Part> &parts);

// Bakes one part whose texels show the nearest points of the source. `visibility`: [triangles of part] (visibility.h).
std::vector<model::Image> bake_charts(const ProxySource &source, model::Part &part,
                                      const std::vector<double> &visibility);

}  // namespace claque::lod
