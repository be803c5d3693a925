// How the textures of a character look from afar, and how differently those of a level look: part of the error that
// selects its distance (docs/levels.md). Internal to lib/lod.
#pragma once

#include <memory>

#include "lib/lod/surface/surface_samples.h"
#include "lib/math/simd.h"

namespace claque::lod
{

// How differently a level looks, in pixels of several sizes.
struct LookDifference {
    static constexpr size_t size_count = 10;
    double longest_m = 0;  // side of the character
    // 0: equal colours, 1: black and white everywhere; of the region of a character where it is largest.
    std::array<double, size_count> colours{};
    // By how much larger than the error of the whole shape a pixel is that hides the region where it is largest.
    std::array<double, size_count> factors{};

    // The pixel, in metres, that hides the level, if one of `shape_m` hides its shape; at least that.
    double hidden_by(double shape_m) const;
};

class TextureLooks
{
public:
    void add(const model::Model &model);  // the materials that it got since the last call

    // Compares the places and the texels at both ends of `pairs`, of nearest_pairs(source, level) at rest; texels are
    // mixed over the pixel. `areas`: [triangles of source] what they count.
    LookDifference difference(const PosedParts &source, const PosedParts &level, const std::vector<PointPair> &pairs,
                              const std::vector<double> &areas, double metres_per_unit) const;

private:
    struct Mip {
        uint32_t width = 0, height = 0;
        std::vector<std::array<uint8_t, 4>> texels;  // colours of the zones included, and whether anything is shown
    };
    struct Look {
        model::Wrap wrap_s = model::Wrap::repeat, wrap_t = model::Wrap::repeat;
        math::F4 colour = {1, 1, 1, 1};
        bool has_holes = false;
        std::shared_ptr<const std::vector<Mip>> mips;  // each half as wide as the one before; null without an image
    };
    static std::vector<Mip> mips_of(const model::Model &model, const model::Material &material);
    struct Shown;
    Shown shown_at(const PosedParts &parts, const SurfacePoint &point) const;

    std::vector<Look> looks_;  // by material
};

}  // namespace claque::lod
