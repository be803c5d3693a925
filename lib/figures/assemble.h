// What makes one built-in figure different from another, and the making of a Model from it.
#pragma once

#include <vector>

#include "lib/figures/clips/clips.h"
#include "lib/figures/painters.h"
#include "lib/figures/weights.h"

namespace claque::figures
{

struct Figure {
    const char *name = "";
    void (*add_pieces)(Mesh &) = nullptr;  // body and dress, from parts.h
    Painter painter;
    // Further texture sets.
    struct TextureSet {
        const char *name;
        Painter painter;
    };
    std::vector<TextureSet> texture_sets;
    Layout layout;
    Zones zones;
    std::vector<ClipMaker> clips;
    Weigher weigher = nullptr;  // of regions of its own; may be null
};

// Throws base::Error should the figure break a rule of model::check.
model::Model assemble(const Figure &figure);

}  // namespace claque::figures
