// Pictures of a colour map: its classes side by side (S2 5.3, Fig. 9), and people in random RGB against the same
// people in its HSB ranges (S2 Fig. 6).
#pragma once

#include "samples/cli/letters.h"
#include "samples/scenes/colours.h"

namespace cli
{

struct ColourPicture {
    Board board;
    std::string context;  // that drew it
};

// One row for each class, with `each` people. Throws scenes::Failure if a class names no template that can be loaded,
// or the picture is too small.
ColourPicture classes_picture(scenes::Library &library, const clq_colour_map *map, uint32_t each, uint64_t seed,
                              int width, int height);
// `each` people of every class, twice.
ColourPicture comparison_picture(scenes::Library &library, const clq_colour_map *map, uint32_t each, uint64_t seed,
                                 int width, int height);

}  // namespace cli
