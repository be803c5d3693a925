#include "lib/lod/candidates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace claque::lod
{

size_t triangle_count_of(const Candidate &made)
{
    size_t count = 0;
    for (const model::Part &part : made.parts) count += model::triangles_of(part).size();
    return count;
}

std::vector<Candidate> prune(std::vector<Candidate> all)
{
    std::vector<Candidate> made, kept;
    for (Candidate &one : all) {
        if (one.level.triangles < 20 && (one.level.zone_area_error > one.zone_tolerance || one.loses_zone)) continue;
        if (one.level.triangles < 20 && one.level.zone_view_error > max_zone_view_error) continue;
        if (made.empty() || one.level.triangles < made.back().level.triangles) made.push_back(std::move(one));
    }
    // Of two nearly equal levels the finer one goes, but the finest level of all stays.
    const auto one_is_enough = [](const LevelReport &finer, const LevelReport &next) {
        return finer.distance_m >= next.distance_m || finer.triangles * 10 < next.triangles * 11;
    };
    for (size_t k = made.size(); k-- > 0;) {
        while (k == 0 && !kept.empty() && one_is_enough(made[0].level, kept.back().level)) kept.pop_back();
        if (kept.empty() || !one_is_enough(made[k].level, kept.back().level)) kept.push_back(std::move(made[k]));
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

void raise_distances(std::vector<Candidate> &all, double tolerance_px)
{
    for (size_t k = 1; k < all.size(); ++k) {
        LevelReport &level = all[k].level;
        level.error_m = level.deviation.look.hidden_by(level.error_m);
        level.distance_m = switch_distance(level.error_m, tolerance_px);
    }
}

void prefer_near(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets)
{
    const auto alike = [](size_t a, size_t b) { return std::max(a, b) * 20 <= std::min(a, b) * 21; };
    std::vector<Candidate> stay;
    for (Candidate &one : made) {
        if (one.is_proxy) continue;
        const size_t triangles = one.level.triangles;
        const auto proxy = std::find_if(made.begin(), made.end(), [&](const Candidate &other) {
            return other.is_proxy && alike(other.level.triangles, triangles);
        });
        if (proxy != made.end() && proxy->level.error_m <= one.level.error_m) continue;
        stay.push_back(std::move(one));
        const auto theirs = [&](size_t target) { return alike(target, triangles); };
        proxy_targets.erase(std::remove_if(proxy_targets.begin(), proxy_targets.end(), theirs), proxy_targets.end());
    }
    made = std::move(stay);
}

bool replace_by_proxy(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate &one : made)
        if (one.is_proxy) least = std::min(least, one.level.error_m);
    size_t stay = 1;
    while (stay < made.size() && !made[stay].is_proxy && made[stay].level.error_m < least) ++stay;
    std::vector<size_t> more;
    for (size_t k = stay; k < made.size() && !made[k].is_proxy; ++k) more.push_back(made[k].target);
    if (more.empty()) return false;
    made.resize(stay);
    proxy_targets.insert(proxy_targets.begin(), more.begin(), more.end());
    return true;
}

std::vector<model::Part> assemble(const model::Model &model, const std::vector<size_t> &part_indices,
                                  std::vector<Candidate> made)
{
    std::vector<model::Part> parts;
    const auto take = [&](size_t k, model::Part &part) {
        part.lod_min_m = static_cast<float>(made[k].level.distance_m);
        if (k + 1 < made.size()) part.lod_max_m = static_cast<float>(made[k + 1].level.distance_m);
        parts.push_back(std::move(part));
    };
    for (size_t i = 0, at = 0; i < model.parts.size(); ++i) {
        if (at == part_indices.size() || part_indices[at] != i) {
            parts.push_back(model.parts[i]);
            continue;
        }
        for (size_t k = 0; k < made.size(); ++k)
            if (!made[k].is_proxy && (k == 0 || !made[k].parts[at].indices.empty())) take(k, made[k].parts[at]);
        ++at;
    }
    for (size_t k = 0; k < made.size(); ++k)
        if (made[k].is_proxy)
            for (model::Part &part : made[k].parts) take(k, part);
    return parts;
}

}  // namespace claque::lod
