// What may be wrong with a character: what its file, its mesh and its levels say.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/library.h"

namespace view
{

struct Findings {
    std::vector<std::string> warnings;  // of the loader
    uint32_t open_edges = 0;            // of the finest level, vertices at one place counted as one
    uint32_t many_influences = 0;       // vertices that follow more than four joints
    uint32_t most_influences = 0;
    struct Zone {
        std::string name;
        double share;        // of the visible surface, at the finest level
        double gone_from_m;  // where its share falls to 0; negative: nowhere
    };
    std::vector<Zone> zones;
    struct Level {
        float from_m;
        uint32_t triangles;
        double error_mm;         // root mean square in motion; negative: not measured
        double zone_area_error;  // [0, 1]
        uint32_t open_edges;     // that the finest level does not have
    };
    std::vector<Level> levels;
    std::string no_levels;               // why none could be made; the levels are then the character's own
    scenes::Own<clq_template> levelled;  // the character with levels that were made
};

// Gives the asset of a template levels of detail, which takes a second or more. Throws scenes::Failure.
Findings examine(scenes::Library &library, const clq_template *tmpl, const scenes::Own<clq_asset> &asset);

}  // namespace view
