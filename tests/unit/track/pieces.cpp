#include "tests/unit/track/pieces.h"

#include <algorithm>
#include <cmath>

namespace claque::test
{

Pieces::Pieces(const std::vector<track::Point> &points, const std::string &figure, const PieceRule &rule,
               const See &see, const track::BuildSettings &common)
{
    const double last_s = points.back().time_s;
    double begin_s = points.front().time_s;
    for (int k = 1; begin_s < last_s; ++k) {
        double end_s = points.front().time_s + k * rule.length_s;
        if (end_s > last_s - 2 * track::min_piece_s) end_s = last_s;
        std::vector<track::Point> seen;
        for (const track::Point &point : points)
            if (point.time_s >= begin_s - rule.overlap_s - 1e-9 &&
                (point.time_s <= end_s + rule.ahead_s + 1e-9 || seen.empty() || seen.back().time_s < end_s))
                seen.push_back(point);
        if (seen.front().time_s > begin_s) seen.insert(seen.begin(), points.front());
        if (see) see(seen, end_s);
        track::BuildSettings settings = common;
        settings.previous = all.empty() ? nullptr : all.back().get();
        settings.end_s = end_s;
        all.push_back(track_of(seen, figure, settings));
        begin_s = track::end_of(*all.back());
        if (end_s == last_s) break;
    }
}

const track::Track &Pieces::at(double time_s) const
{
    size_t k = all.size() - 1;
    while (k > 0 && time_s < all[k]->start_s) --k;
    return *all[k];
}

std::vector<LongPlant> plants_of(const Pieces &pieces)
{
    std::vector<LongPlant> out;
    for (int f = 0; f < 2; ++f)
        for (const auto &piece : pieces.all)
            for (const track::Plant &plant : piece->plants[f]) {
                // Shown by this piece at all; a longer stand is taken over by the next.
                const bool last = piece == pieces.all.back();
                if (double(plant.end_s) < 0 || (!last && double(plant.begin_s) >= piece->length_s)) continue;
                const LongPlant now{f, piece->start_s + double(plant.begin_s), piece->start_s + double(plant.end_s),
                                    double(plant.x), double(plant.z)};
                const bool same = !out.empty() && out.back().foot == f && plant.begin_s <= 0 &&
                                  std::fabs(out.back().begin_s - now.begin_s) < 1e-3;
                if (same) out.back().end_s = now.end_s;
                else out.push_back(now);
            }
    return out;
}

FootDrift drift_of_pieces(Soles &soles, const Pieces &pieces, double step_s)
{
    constexpr double contact_m = 0.012;
    FootDrift out;
    for (const LongPlant &plant : plants_of(pieces)) {
        glm::dvec3 sum(0);
        double worst = 0;
        SolesInWorld before;
        for (double t = plant.begin_s; t <= plant.end_s; t += step_s) {
            SolesInWorld now = soles_at(soles, pieces.at(t), plant.foot, t, true);
            glm::dvec3 moved(0);
            int touching = 0;
            for (size_t i = 0; i < before.points.size(); ++i) {
                const bool low =
                    before.points[i].y - before.ground < contact_m && now.points[i].y - now.ground < contact_m;
                if (low) moved += now.points[i] - before.points[i], ++touching;
            }
            if (touching > 0) sum += moved / double(touching);
            worst = std::max(worst, std::sqrt(sum.x * sum.x + sum.z * sum.z));
            before = std::move(now);
        }
        out.each.push_back(worst);
    }
    return out;
}

}  // namespace claque::test
