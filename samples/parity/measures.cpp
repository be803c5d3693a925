#include "samples/parity/measures.h"

namespace parity
{

const std::vector<MeasureKind> &measure_kinds()
{
    static const std::vector<MeasureKind> kinds = {
        {"actors.missing", "individuals of the reference that the result does not draw", true},
        {"actors.added", "individuals of the result that the reference does not draw", true},
        {"actors.changed", "individuals drawn from another template or level of detail", true},
        {"positions.max_m", "largest distance of a vertex", true},
        {"positions.rms_m", "root mean square of the distances", true},
        {"positions.max_relative", "largest distance as a share of its character's size", true},
        {"positions.ulp_max", "most floats between two coordinates", true},
        {"positions.ulp_median", "median of floats between two coordinates", true},
        {"positions.not_finite", "vertices that are not numbers on either side", true},
        {"normals.max_deg", "largest angle of a normal", true},
        {"normals.rms_deg", "root mean square of the angles", true},
        {"normals.ulp_max", "most floats between two components", true},
        {"normals.ulp_median", "median of floats between two components", true},
        {"normals.not_finite", "normals that are not numbers on either side", true},
        {"actor_ids.outside", "pixels of other individuals, away from silhouettes", true},
        {"actor_ids.different", "share of pixels that show another individual", true},
        {"actor_ids.at_silhouettes", "share of the silhouettes' pixels that do, within a pixel", true},
        {"actor_ids.worst_actor", "largest share of one individual's inner pixels that show another", true},
        {"zone_ids.outside", "pixels of other zones, away from zone borders", true},
        {"zone_ids.outside_share", "the same as a share of the people's pixels", true},
        {"zone_ids.different", "share of pixels that show another zone of the same individual", true},
        {"zone_ids.at_borders", "share of the borders' pixels that do, within a pixel", true},
        {"zone_ids.worst_zone", "largest share of one zone's inner pixels that show another", true},
        {"depth.max", "largest difference of window depth", true},
        {"depth.rms", "root mean square of the differences", true},
        {"depth.median", "median of the differences", true},
        {"depth.p99_9", "999 of 1000 differences are no larger", true},
        {"depth.worst_actor", "largest median difference of one individual", true},
        {"depth.not_finite", "depths that are not numbers", true},
        {"colour.max", "largest difference of a channel", true},
        {"colour.over_1", "share of the people's pixels with a channel off by more than 1 LSB", true},
        {"colour.over_2", "share of the people's pixels with a channel off by more than 2 LSB", true},
        {"colour.over_8", "share of the people's pixels with a channel off by more than 8 LSB", true},
        {"colour.worst_zone", "largest mean difference of one zone of one individual", true},
        {"colour.worst_bias", "largest difference of the mean colours of one zone of one individual", true},
        {"colour.bias", "difference of the mean colours of all people", true},
        {"colour.psnr_db", "peak signal-to-noise ratio", false},
        {"colour.ssim", "mean structural similarity of luma", false},
        {"colour.flip_mean", "mean of LDR-FLIP", true},
        {"colour.flip_max", "largest LDR-FLIP", true}};
    return kinds;
}

const MeasureKind *find_kind(const std::string &name)
{
    for (const MeasureKind &kind : measure_kinds())
        if (name == kind.name) return &kind;
    return nullptr;
}

std::string group_of(const std::string &measure) { return measure.substr(0, measure.find('.')); }

const std::vector<std::string> &measure_groups()
{
    static const std::vector<std::string> groups = [] {
        std::vector<std::string> out;
        for (const MeasureKind &kind : measure_kinds())
            if (out.empty() || out.back() != group_of(kind.name)) out.push_back(group_of(kind.name));
        return out;
    }();
    return groups;
}

}  // namespace parity
