// What distant eyes see of a character's zones, in several poses. Zones that have the right fractions of the whole
// surface may still be wrong from each single side, above all in a few triangles. Internal to lib/lod/proxies.
#pragma once

#include <vector>

#include "lib/lod/surface/surface_samples.h"
#include "lib/math/affine.h"

namespace claque::lod
{

// The views of one character: at rest and in poses spread over its clips, each from nine sides (level, above, and
// between), in parallel projection. Deterministic.
class ZoneViews
{
public:
    // `source`: the finest parts. The model must outlive this.
    ZoneViews(const model::Model &model, const std::vector<const model::Part *> &source);

    size_t count() const { return fractions_.size(); }
    // [zones of the model + 1] of what this view shows: its fraction of each zone; the last is for no zone.
    const std::vector<double> &fractions(size_t view) const { return fractions_[view]; }
    // Returns how wrong a level's zones are in [0, 1]: half of the differences of its zones' fractions from the
    // source's, as a mean over all views. `level`: with its image.
    double error(const model::Part &level) const;
    // [views][triangles of `level`]: each triangle's fraction of what a view shows of the level.
    std::vector<std::vector<double>> triangle_fractions(const model::Part &level) const;

private:
    struct Pose {
        std::vector<math::Affine> palette;
        std::vector<float> weights;
    };
    // Draws `parts` in all views and calls take(points), with a surface point for each pixel that shows one.
    template <class Take>
    void draw(PosedParts &parts, Take take) const;
    std::vector<std::vector<double>> fractions_of(const std::vector<const model::Part *> &parts) const;

    const model::Model &model_;
    std::vector<Pose> poses_;
    std::vector<std::vector<double>> fractions_;
};

}  // namespace claque::lod
