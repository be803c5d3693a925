// Zones painted over a texture: which texel belongs to which zone, by name. Copies share what they have in common, so
// that a history of strokes stays small.
#pragma once

#include <claque/zones.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace view
{

class ZoneMap
{
public:
    static constexpr uint8_t none = 255;

    // All texels without a zone.
    ZoneMap(uint32_t width_px, uint32_t height_px);

    uint8_t at(uint32_t x, uint32_t y) const { return (*tile_of(x, y))[place(x, y)]; }
    void set(uint32_t x, uint32_t y, uint8_t zone);
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    // The number of a name, which is added if it is not there; `none` if there are 255 already.
    uint8_t zone(const std::string &name);

    std::string tmpl;                       // whose texture it is
    uint32_t texture_set = 0, texture = 0;  // of the template
    std::vector<std::string> names;         // of the zones
    std::vector<clq_hsb_range> ranges;
    bool reduced = false;                               // texels become grey, so that zones take any colour
    std::shared_ptr<const std::vector<uint8_t>> light;  // [3 * width * height] what the texture shows

private:
    friend bool operator==(const ZoneMap &a, const ZoneMap &b);
    static constexpr uint32_t side = 64;
    using Tile = std::array<uint8_t, static_cast<size_t>(side) * side>;
    static size_t place(uint32_t x, uint32_t y) { return static_cast<size_t>(y % side) * side + x % side; }
    const std::shared_ptr<Tile> &tile_of(uint32_t x, uint32_t y) const
    {
        return tiles_[static_cast<size_t>(y / side) * across_ + x / side];
    }

    uint32_t width_, height_, across_;
    std::vector<std::shared_ptr<Tile>> tiles_;
};

bool operator==(const ZoneMap &a, const ZoneMap &b);

// A stroke of a round brush from one place to another, 0 to 1 each way; the diameter is in texels.
void stroke(ZoneMap &map, uint8_t zone, const float (&from)[2], const float (&to)[2], float diameter_px);
// All texels of the triangles that hang together on the texture and hold a place of it. Returns false if none does.
bool fill_island(ZoneMap &map, uint8_t zone, const clq_template *tmpl, float u, float v);

// A zone covers at least one texel in so many, or it is lost in a picture.
constexpr size_t min_zone_share = 2000;

// For clq_zone_map_def.
std::vector<uint16_t> texels_of(const ZoneMap &map);
// The map as a picture in which each zone has a colour of its own, three bytes a texel; texels without a zone take a
// zone beside them. `colours`: by zone, as "#f2523d"; empty for a zone that covers less than a two-thousandth of the
// picture, because `claque prepare` takes such a colour for a soft edge.
std::vector<uint8_t> picture_of(const ZoneMap &map, std::vector<std::string> &colours);

}  // namespace view
