// Reads colour maps from TOML (claque/colours.h) and writes them in a normal form.
#pragma once

#include <claque/colours.h>

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace claque::asset
{

// A map as read from a file; `def` points into the other members.
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

// `out` must be empty. `name` stands at the start of messages. Throws base::Error: CLQ_FORMAT with line, column and the
// broken rule; CLQ_LIMIT for more than 4 MiB. Checks every rule of model/colour_rules.h.
void read_colours(std::string_view toml, const std::string &name, ColourFile &out);

// Equal maps give equal texts; reading and writing a text again gives the same bytes. Throws base::Error (CLQ_ARGUMENT)
// for a name that is not UTF-8.
std::string colours_text(const clq_colour_map_def &def);

}  // namespace claque::asset
