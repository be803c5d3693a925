// Measures how far a level of detail deviates from its source, at rest and in motion; levels are selected by it (S1 6).
// Each vertex and triangle centre of the source is matched with the nearest point of the level at rest, and corners and
// centres of the level with the source likewise. The pairs are then measured in poses of every clip.
#pragma once

#include <vector>

#include "lib/base/services.h"
#include "lib/lod/surface/texture_looks.h"
#include "lib/model/model.h"

namespace claque::lod
{

struct Deviation {
    double rest_max_m = 0, rest_rms_m = 0;    // the maximum and the root mean square
    double posed_max_m = 0, posed_rms_m = 0;  // over all poses; upper bounds, as points are matched at rest
    LookDifference look;                      // at rest
    double wrong_zone = 0;                    // [0, 1] the fraction of the source's area that shows another zone
    size_t open_edges = 0;  // edges with one triangle, of all parts together, minus those of the source
};

struct Sampling {
    uint32_t poses_per_clip = 8;  // at even times
    uint32_t max_clips = 32;      // the first clips of the rig
};

// Results are in metres: model units times `metres_per_unit`. `level` has the parts of a Decimated made from `model`'s
// visible parts with triangles, in order. Both must have passed model::check.
Deviation deviation(const model::Model &model, const std::vector<const model::Part *> &source,
                    const std::vector<model::Part> &level, const Sampling &sampling, double metres_per_unit = 1);

// The same for several levels; the poses of the source are computed once for all of them. `visibility`: of the source
// at rest (visibility.h). `looks`: null: textures are not compared. The result does not depend on `jobs`.
std::vector<Deviation> deviations(const model::Model &model, const std::vector<const model::Part *> &source,
                                  const std::vector<double> &visibility,
                                  const std::vector<const std::vector<model::Part> *> &levels, const Sampling &sampling,
                                  double metres_per_unit = 1, const base::Jobs &jobs = {},
                                  const TextureLooks *looks = nullptr);

// Deviation::wrong_zone and, with `looks`, look, again. `source`: at rest.
void compare_textures(const model::Model &model, const PosedParts &source, const std::vector<double> &visibility,
                      const std::vector<model::Part> &level, const TextureLooks *looks, double metres_per_unit,
                      Deviation &deviation);

}  // namespace claque::lod
