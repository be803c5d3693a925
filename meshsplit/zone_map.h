// A texture within the splitter: colour and zone of every texel, stored separately so that they cannot mix.
#pragma once

#include "lib/model/model.h"

namespace claque::meshsplit
{

constexpr uint16_t hole = 0xffff;  // no zone: an alpha-masked material is transparent here

struct ZoneMap {
    ZoneMap(uint32_t w, uint32_t h) : width(w), height(h), rgb(size_t(3) * w * h), zones(size_t(w) * h) {}

    uint32_t width, height;
    std::vector<uint8_t> rgb;     // 3 per texel, row 0 at v = 0
    std::vector<uint16_t> zones;  // indices of the template's zones, or `hole`
};

}  // namespace claque::meshsplit
