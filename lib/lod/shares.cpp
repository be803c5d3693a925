#include "lib/lod/shares.h"

#include <algorithm>
#include <cmath>

#include "lib/lod/seen.h"

namespace claque::lod
{

std::vector<double> zone_shares(const model::Model &model, const std::vector<const model::Part *> &parts,
                                const model::TextureSet *set)
{
    const PosedParts posed = posed_at_rest(model.rig, parts);
    return zone_shares(model, posed, seen_of(model, posed), set);
}

std::vector<double> zone_shares(const model::Model &model, const PosedParts &posed, const std::vector<double> &seen,
                                const model::TextureSet *set)
{
    std::vector<double> shares(model.zones.size() + 1, 0.0);
    double all = 0;
    const std::vector<Spot> spots = spread(posed, spots_of_a_surface);
    for (const Spot &spot : spots) all += spot.area * seen[spot.place.triangle];
    if (!(all > 0)) return shares;
    for (const Spot &spot : spots)
        shares[std::min<size_t>(zone_at(model, posed, spot.place, set), model.zones.size())] +=
            spot.area * seen[spot.place.triangle] / all;
    return shares;
}

double largest_drift(const std::vector<double> &a, const std::vector<double> &b)
{
    double most = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace claque::lod
