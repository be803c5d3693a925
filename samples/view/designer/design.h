// What a designer makes: colour classes, as claque/colours.h describes them, as values that can be kept, compared and
// given back. A class that did not change is shared between designs.
#pragma once

#include <claque/colour_files.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/colours.h"
#include "samples/view/designer/zone_map.h"

namespace view
{

struct ZoneColours {
    std::string zone;
    std::vector<clq_palette_entry> palette;  // empty: that of linked_to
    clq_colour_space space = CLQ_COLOUR_SPACE_HSB;
    std::string linked_to;  // empty: none
    float variation = 0;
};

struct ColourClass {
    std::string name;
    std::optional<std::string> tmpl;
    std::vector<ZoneColours> zones;

    const ZoneColours *find(const std::string &zone) const;
    ZoneColours *find(const std::string &zone);
};

using SharedClass = std::shared_ptr<const ColourClass>;

using SharedMap = std::shared_ptr<const ZoneMap>;

struct Design {
    std::vector<SharedClass> classes;
    std::vector<SharedMap> maps;  // of textures that were painted; they are not part of a colour map's file
};

bool same(const clq_hsb_range &a, const clq_hsb_range &b);
bool operator==(const ZoneColours &a, const ZoneColours &b);
bool operator==(const ColourClass &a, const ColourClass &b);
bool operator==(const Design &a, const Design &b);

// All throw scenes::Failure with the library's sentence.
scenes::ColourMap map_of(clq_context *context, const Design &design);
Design read_design(clq_context *context, const std::string &toml, const std::string &where);
// As clq_colour_map_save writes it; equal designs give equal bytes.
std::string design_text(clq_context *context, const Design &design);
// The range that holds one colour, as "#8a3b12"; nothing if the text is no such colour.
std::optional<clq_hsb_range> range_of_hex(clq_context *context, const std::string &text);
// That text for the middle of a range.
std::string hex_of(const clq_hsb_range &range);
float middle_hue_deg(const clq_hsb_range &range);          // may be more than 360 where the range wraps
void rgb_of(const clq_hsb_range &range, float (&out)[3]);  // of its middle

}  // namespace view
