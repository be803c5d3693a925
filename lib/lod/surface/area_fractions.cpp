#include "lib/lod/surface/area_fractions.h"

#include <algorithm>
#include <cmath>

#include "lib/lod/surface/visibility.h"

namespace claque::lod
{

std::vector<double> zone_area_fractions(const model::Model &model, const std::vector<const model::Part *> &parts,
                                        const model::TextureSet *set)
{
    const PosedParts posed = posed_at_rest(model.rig, parts);
    return zone_area_fractions(model, posed, visibility_of(model, posed), set);
}

std::vector<double> zone_area_fractions(const model::Model &model, const PosedParts &posed,
                                        const std::vector<double> &visibility, const model::TextureSet *set)
{
    std::vector<double> area_fractions(model.zones.size() + 1, 0.0);
    double all = 0;
    const std::vector<SurfaceSample> samples = sample_surface(posed, surface_sample_count);
    for (const SurfaceSample &sample : samples) {
        if (is_hole(model, posed, sample.point, set)) continue;
        const double area = sample.area * visibility[sample.point.triangle];
        area_fractions[std::min<size_t>(zone_at(model, posed, sample.point, set), model.zones.size())] += area;
        all += area;
    }
    for (double &fraction : area_fractions) fraction = all > 0 ? fraction / all : 0;
    return area_fractions;
}

double zone_area_error(const std::vector<double> &a, const std::vector<double> &b)
{
    double maximum = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) maximum = std::max(maximum, std::abs(a[i] - b[i]));
    return maximum;
}

bool loses_zone(const std::vector<double> &source, const std::vector<double> &level, double least)
{
    for (size_t i = 0; i < std::min(source.size(), level.size()); ++i)
        if (source[i] >= least && level[i] * 10 < source[i]) return true;
    return false;
}

}  // namespace claque::lod
