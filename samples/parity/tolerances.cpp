// The named tolerances. Limits of shares of a picture are combined with limits of single individuals and zones,
// because a missing person far away is a very small share. `exact`, `gpu` and `coarse` say that all is right, so they
// require all of it; `loose` takes what both have.
#include "samples/parity/tolerance.h"

namespace parity
{

namespace
{

// These limits after those of the same actors, with positions and normals as other rounding leaves them.
std::vector<Limit> with_the_same_bodies(std::vector<Limit> more)
{
    std::vector<Limit> all = {
        {"actors.missing", 0},       {"actors.added", 0},    {"actors.changed", 0},    {"positions.max_relative", 1e-4},
        {"positions.not_finite", 0}, {"normals.max_deg", 1}, {"normals.not_finite", 0}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace

const std::vector<Tolerance> &named_tolerances()
{
    static const std::vector<std::string> everything = {"actors",   "positions", "normals", "actor_ids",
                                                        "zone_ids", "depth",     "colour"};
    static const std::vector<Tolerance> all = {
        {"exact",
         {{"actors.missing", 0},
          {"actors.added", 0},
          {"actors.changed", 0},
          {"positions.ulp_max", 0},
          {"positions.not_finite", 0},
          {"normals.ulp_max", 0},
          {"normals.not_finite", 0},
          {"actor_ids.different", 0},
          {"zone_ids.different", 0},
          {"depth.max", 0},
          {"depth.not_finite", 0},
          {"colour.max", 0}},
         everything},
        // Allows other rounding of skinning, pixel centres and blends; not other geometry, poses or colours.
        {"gpu",
         with_the_same_bodies({{"actor_ids.outside", 0},
                               {"actor_ids.at_silhouettes", 0.02},
                               {"zone_ids.outside_share", 0.001},
                               {"zone_ids.at_borders", 0.05},
                               {"zone_ids.worst_zone", 0.5},
                               {"depth.p99_9", 1e-4},
                               {"depth.worst_actor", 1e-6},
                               {"depth.not_finite", 0},
                               {"colour.over_2", 0.001},
                               {"colour.worst_zone", 2},
                               {"colour.flip_mean", 0.02}}),
         everything},
        // Allows vertices that are rounded to a 16th of a pixel: texels then lie a part of a pixel elsewhere, which no
        // mean colour shows. Not other lights, colours, poses or people.
        {"coarse",
         with_the_same_bodies({{"actor_ids.different", 0.01},
                               {"actor_ids.at_silhouettes", 0.03},
                               {"actor_ids.worst_actor", 0.5},
                               {"zone_ids.outside_share", 0.02},
                               {"zone_ids.at_borders", 0.05},
                               {"zone_ids.worst_zone", 0.5},
                               {"depth.median", 1e-5},
                               {"depth.worst_actor", 1e-4},
                               {"depth.not_finite", 0},
                               {"colour.over_8", 0.2},
                               {"colour.worst_bias", 16},
                               {"colour.bias", 0.25},
                               {"colour.ssim", 0.97}}),
         everything},
        // Allows what looks like the same crowd: another rasteriser, other shading of edges, filtered textures.
        {"loose",
         {{"actors.missing", 0},
          {"actors.added", 0},
          {"positions.max_relative", 0.01},
          {"positions.not_finite", 0},
          {"normals.rms_deg", 5},
          {"normals.not_finite", 0},
          {"actor_ids.different", 0.01},
          {"zone_ids.different", 0.02},
          {"depth.median", 1e-4},
          {"depth.not_finite", 0},
          {"colour.over_8", 0.02},
          {"colour.worst_zone", 16},
          {"colour.ssim", 0.95},
          {"colour.flip_mean", 0.05}},
         {}}};
    return all;
}

}  // namespace parity
