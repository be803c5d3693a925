#include "lib/lod/shares.h"

#include <algorithm>
#include <cmath>

#include "lib/lod/samples.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr double places = 20000;  // that stand for a whole surface, about
constexpr uint32_t most_steps = 64;

}  // namespace

std::vector<double> zone_shares(const model::Model &model, const std::vector<const model::Part *> &parts)
{
    PosedParts posed(parts);
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(model.rig, palette, workspace.weights());
    std::vector<double> shares(model.zones.size() + 1, 0.0);
    std::vector<double> areas;
    double all = 0;
    for (uint32_t t = 0; t < posed.triangles().size(); ++t) areas.push_back(area_of(posed, t)), all += areas.back();
    if (!(all > 0)) return shares;
    for (uint32_t t = 0; t < areas.size(); ++t) {
        // Middles of the triangles that `steps` lines along each side make.
        const auto steps = static_cast<uint32_t>(std::ceil(std::sqrt(places * areas[t] / all)));
        const double n = std::clamp(steps, 1u, most_steps);
        for (double i = 0; i < n; ++i)
            for (double j = 0; i + j < n; ++j)
                for (const double third : {1.0, 2.0}) {
                    if (third == 2 && i + j + 2 > n) continue;
                    const double b = (i + third / 3) / n, c = (j + third / 3) / n;
                    const uint32_t zone = zone_at(model, posed, {t, {1 - b - c, b, c}});
                    shares[std::min<size_t>(zone, model.zones.size())] += areas[t] / (n * n * all);
                }
    }
    return shares;
}

double largest_drift(const std::vector<double> &a, const std::vector<double> &b)
{
    double most = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace claque::lod
