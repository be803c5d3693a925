// One function for each format of areas. All throw base::Error and std::bad_alloc.
#pragma once

#include <string_view>

#include "lib/asset/areas/area.h"

namespace claque::asset
{

void read_wkt(std::string_view text, AreaBuilder &out);
void read_jupedsim_area(const uint8_t *bytes, size_t size, AreaBuilder &out);
void read_geo_xml(const uint8_t *bytes, size_t size, AreaBuilder &out);
void read_menge_nav(std::string_view text, AreaBuilder &out);
void read_vadere_scenario(const uint8_t *bytes, size_t size, AreaBuilder &out);

}  // namespace claque::asset
