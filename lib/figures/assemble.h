// The definition of a built-in character (a figure), and the function that makes a Model from it.
#pragma once

#include <vector>

#include "lib/figures/clips/clips.h"
#include "lib/figures/painters.h"
#include "lib/figures/weights.h"

namespace claque::figures
{

struct Figure {
    const char *name = "";
    void (*add_pieces)(Mesh &) = nullptr;  // body and clothes, from parts.h
    Painter painter;
    // Additional texture sets.
    struct TextureSet {
        const char *name;
        Painter painter;
    };
    std::vector<TextureSet> texture_sets;
    Layout layout;
    Zones zones;
    std::vector<ClipMaker> clips;
    Fit fit = nullptr;          // what the figure changes in every pose of the clips; may be null
    Weigher weigher = nullptr;  // weights of the figure's own regions; may be null
};

// Throws base::Error if the figure breaks a rule of model::check.
model::Model assemble(const Figure &figure);

}  // namespace claque::figures
