// What makes one built-in figure different from another, and the making of a Model from it.
#pragma once

#include <vector>

#include "lib/figures/clips.h"
#include "lib/figures/painters.h"

namespace claque::figures
{

struct Figure {
    const char *name = "";
    void (*add_pieces)(Mesh &) = nullptr;  // body and dress, from parts.h
    Painter painter;
    std::vector<model::Zone> zones;
    std::vector<ClipMaker> clips;
};

// Throws base::Error should the figure break a rule of model::check.
model::Model assemble(const Figure &figure);

}  // namespace claque::figures
