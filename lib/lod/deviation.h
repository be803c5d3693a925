// How far a level of detail is from what it stands for, at rest and in motion: each vertex and the middle of each triangle
// of the source is held against the place of the level that is nearest to it at rest, in poses of every clip; and the
// level's corners' middles against the source likewise. What a level of detail is chosen by (S1 6).
#pragma once

#include <vector>

#include "lib/base/services.h"
#include "lib/model/model.h"

namespace claque::lod
{

struct Deviation {
    double rest_max_m = 0, rest_rms_m = 0;    // the most, and the root of the mean of squares
    double posed_max_m = 0, posed_rms_m = 0;  // over all poses; bounds from above, as places are matched at rest
    double wrong_zone = 0;                    // [0, 1] share of the source's area that shows another zone
    size_t open_edges = 0;                    // edges with one triangle, of all parts together, beyond the source's
};

struct Sampling {
    uint32_t poses_per_clip = 8;  // at even times
    uint32_t max_clips = 32;      // the first ones
};

// Metres: model units times `metres_per_unit`. `level` has the parts of a Decimated of `model`'s visible parts with
// triangles, in order; both have passed model::check.
Deviation deviation(const model::Model &model, const std::vector<const model::Part *> &source,
                    const std::vector<model::Part> &level, const Sampling &sampling, double metres_per_unit = 1);

// Of several levels, each as by itself; poses of the source are made once for all of them. `seen`: of the source at rest
// (seen.h). The same whatever the jobs.
std::vector<Deviation> deviations(const model::Model &model, const std::vector<const model::Part *> &source,
                                  const std::vector<double> &visibility,
                                  const std::vector<const std::vector<model::Part> *> &levels, const Sampling &sampling,
                                  double metres_per_unit = 1, const base::Jobs &jobs = {});

}  // namespace claque::lod
