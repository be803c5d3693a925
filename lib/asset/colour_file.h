// Colour maps in TOML (claque/colours.h): what people write, and the normal form of it that is written back.
#pragma once

#include <claque/colours.h>

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace claque::asset
{

// A map as a file has it; `def` points into the rest.
struct ColourFile {
    ColourFile() = default;
    ColourFile(const ColourFile &) = delete;
    ColourFile &operator=(const ColourFile &) = delete;

    clq_colour_map_def def = clq_colour_map_def_init();
    std::deque<std::string> texts;
    std::vector<clq_colour_class> classes;
    std::deque<std::vector<clq_zone_colours>> zones;
    std::deque<std::vector<clq_palette_entry>> palettes;
};

// Into an empty one. `name` stands before the sentence. Throws base::Error: CLQ_FORMAT with line, column and the rule that is
// broken; CLQ_LIMIT for more than 4 MiB. Keeps every rule of model/colour_rules.h.
void read_colours(std::string_view toml, const std::string &name, ColourFile &out);

// The same text for the same map; read and written again it is the same bytes. Throws base::Error (CLQ_ARGUMENT): a name that
// is no UTF-8.
std::string colours_text(const clq_colour_map_def &def);

}  // namespace claque::asset
