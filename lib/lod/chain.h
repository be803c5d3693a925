// A character in levels of detail, made from its finest (S1 6): every part becomes a row of parts with adjoining
// distances, which the splitter turns into levels with zones, bins and spheres of their own.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/lod/decimate.h"
#include "lib/lod/deviation.h"

namespace claque::lod
{

struct ChainOptions {
    // Triangles of all parts together, descending strictly; those that are not fewer than the character's are skipped.
    // Empty: usual_targets().
    std::vector<size_t> targets;
    DecimationOptions decimation;  // its own targets are not used
    // Levels of so many triangles and fewer are far ones (far.h). So are all from the first on that seams and borders keep
    // decimation from by a twentieth, or at which a zone would gain or lose more than 2 points of the surface, or a far level of fewer triangles is nearer. 0: none.
    size_t proxy_max_triangles = 250;
    Sampling sampling;
    double metres_per_unit = 1;
    double tolerance_px = 1;    // at 768 lines over 60 degrees: how large a level's error may be where it begins
    bool quadric_only = false;  // plain.h, every level kept: what others are held against
    base::Jobs jobs;            // what is spread over; nothing depends on it
};

struct LevelReport {
    size_t triangles = 0, vertices = 0;
    double error_m = 0;          // what it was chosen by: twice the root of the mean of squares in motion
    double distance_m = 0;       // it serves from here on
    Deviation deviation;         // of the first, all 0
    size_t flipped = 0;          // triangles that have turned over in their texture
    double zone_area_error = 0;  // shares.h, from the finest
};

// What the papers' figures have, eight levels from 1040 to 490, then about half of it each time: 250, 120, 60, 42, 30, 20, 14. Above
// 1040 half of the character's, and so on.
std::vector<size_t> default_targets(size_t triangles);

// Distance in metres from which an error of so many metres is `pixels` or less, at 768 lines over 60 degrees.
double switch_distance(double error_m, double pixels);

// Gives `model` its levels, and says what came of each, the finest first. Parts that are hidden, have no triangles or have
// distances of their own stay as they are. A level that could not get below the one before it by a tenth, or that
// begins where the next does, is left out, and so is one of fewer than 20 triangles that cannot keep shares of zones.
// Throws base::Error (CLQ_ARGUMENT) where nothing can be decimated or targets do not descend; the model is then as it
// was. Deterministic.
std::vector<LevelReport> make_chain(model::Model &model, const ChainOptions &options);

}  // namespace claque::lod
