// Builds a character's chain of levels of detail from its finest level (S1 6). Every part becomes a series of parts
// with adjoining distance ranges; the splitter turns these into levels with their own zones, bins and spheres.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/lod/decimation/decimate.h"
#include "lib/lod/surface/deviation.h"

namespace claque::lod
{

struct ChainOptions {
    // Triangles of all parts together, strictly descending. Targets that are not below the character's own count are
    // skipped. Empty: default_targets().
    std::vector<size_t> targets;
    DecimationOptions decimation;  // its own targets are not used

    // Levels of at most this many triangles are proxies (proxy.h): one mesh, no seams, a baked texture. Above 128
    // triangles a decimated level is kept if its error is smaller. A decimated level fails if it misses its target by
    // 5 % or shifts a zone by 2 points of the surface: it is left out. Proxies replace all levels after the last that
    // does not fail, and all from the first whose error is larger than that of a coarser proxy. 0: no proxies.
    size_t proxy_max_triangles = 250;
    Sampling sampling;
    double metres_per_unit = 1;
    // The largest error of a level at the distance where it begins, in pixels of a view with 768 lines over 60 degrees.
    double tolerance_px = 1;
    bool quadric_only = false;  // decimate_quadric_only, with every level kept: the baseline for comparison
    base::Jobs jobs;            // runs the work in parallel; the result does not depend on it
};

struct LevelReport {
    size_t triangles = 0, vertices = 0;
    double error_m = 0;          // that selects its distance: twice the RMS error in motion, enlarged by the texture's
    double distance_m = 0;       // the level is shown from this distance on
    Deviation deviation;         // all 0 for the finest level
    size_t flipped = 0;          // triangles that are flipped in texture space
    double zone_area_error = 0;  // against the finest level (area_fractions.h)
    double zone_view_error = 0;  // in single views (proxies/zone_views.h); of levels with one zone a triangle, else 0
};

// Returns a half, a quarter and so on of the character's count, while above 1300; then those of the following that are
// at most 95 % of it: eight levels from 1040 to 490 (S1 6), 430, 375, 330, 290, 250, 205, 165, 120, 84, 60, 42, 30, 20,
// 14, 10.
std::vector<size_t> default_targets(size_t triangles);

// Returns the distance in metres from which an error of `error_m` covers at most `pixels`, at 768 lines over 60
// degrees.
double switch_distance(double error_m, double pixels);

// Replaces the parts of `model` by a chain of levels, and reports on each level, finest first. Parts that are hidden,
// have no triangles or have distances of their own stay as they are. A level is left out if it has less than a tenth
// more triangles than the next one, or if it begins where the next begins. A level of fewer than 20 triangles is also
// left out in three cases. The area fraction of a zone is off by more than 2 points and by more than half of a pixel
// where the level begins. A zone larger than both nearly vanishes (area_fractions.h). Single views show on average more
// than 28 % of wrong zones (proxies/zone_views.h).
// Throws base::Error (CLQ_ARGUMENT) if nothing can be decimated or targets do not descend; the model is then unchanged.
// Deterministic.
std::vector<LevelReport> make_chain(model::Model &model, const ChainOptions &options);

}  // namespace claque::lod
