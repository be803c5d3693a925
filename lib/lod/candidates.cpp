#include "lib/lod/candidates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace claque::lod
{

size_t triangles_of(const Candidate &made)
{
    size_t count = 0;
    for (const model::Part &part : made.parts) count += model::triangles_of(part).size();
    return count;
}

std::vector<Candidate> in_use(std::vector<Candidate> all)
{
    std::vector<Candidate> made, kept;
    for (Candidate &one : all) {
        if (one.level.triangles < 20 && one.level.zone_drift > most_drift) continue;
        if (made.empty() || one.level.triangles < made.back().level.triangles) made.push_back(std::move(one));
    }
    // Of two that come to the same the finer one goes, but the finest stays.
    const auto one_is_enough = [](const ChainLevel &finer, const ChainLevel &next) {
        return finer.first_m >= next.first_m || finer.triangles * 10 < next.triangles * 11;
    };
    for (size_t k = made.size(); k-- > 0;) {
        while (k == 0 && !kept.empty() && one_is_enough(made[0].level, kept.back().level)) kept.pop_back();
        if (kept.empty() || !one_is_enough(made[k].level, kept.back().level)) kept.push_back(std::move(made[k]));
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

void stay_near(std::vector<Candidate> &made, std::vector<size_t> &far_targets)
{
    const auto alike = [](size_t a, size_t b) { return std::max(a, b) * 20 <= std::min(a, b) * 21; };
    std::vector<Candidate> stay;
    for (Candidate &one : made) {
        if (one.is_far) continue;
        const size_t triangles = one.level.triangles;
        const auto far = std::find_if(made.begin(), made.end(), [&](const Candidate &other) {
            return other.is_far && alike(other.level.triangles, triangles);
        });
        if (far != made.end() && far->level.error_m <= one.level.error_m) continue;
        stay.push_back(std::move(one));
        const auto theirs = [&](size_t target) { return alike(target, triangles); };
        far_targets.erase(std::remove_if(far_targets.begin(), far_targets.end(), theirs), far_targets.end());
    }
    made = std::move(stay);
}

bool give_way(std::vector<Candidate> &made, std::vector<size_t> &far_targets)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate &one : made)
        if (one.is_far) least = std::min(least, one.level.error_m);
    size_t stay = 1;
    while (stay < made.size() && !made[stay].is_far && made[stay].level.error_m < least) ++stay;
    std::vector<size_t> more;
    for (size_t k = stay; k < made.size() && !made[k].is_far; ++k) more.push_back(made[k].level.triangles);
    if (more.empty()) return false;
    made.resize(stay);
    far_targets.insert(far_targets.begin(), more.begin(), more.end());
    return true;
}

std::vector<model::Part> laid_out(const model::Model &model, const std::vector<size_t> &places,
                                  std::vector<Candidate> made)
{
    std::vector<model::Part> parts;
    const auto take = [&](size_t k, model::Part &part) {
        part.lod_first_m = static_cast<float>(made[k].level.first_m);
        if (k + 1 < made.size()) part.lod_last_m = static_cast<float>(made[k + 1].level.first_m);
        parts.push_back(std::move(part));
    };
    for (size_t i = 0, at = 0; i < model.parts.size(); ++i) {
        if (at == places.size() || places[at] != i) {
            parts.push_back(model.parts[i]);
            continue;
        }
        for (size_t k = 0; k < made.size(); ++k)
            if (!made[k].is_far && (k == 0 || !made[k].parts[at].indices.empty())) take(k, made[k].parts[at]);
        ++at;
    }
    for (size_t k = 0; k < made.size(); ++k)
        if (made[k].is_far) take(k, made[k].parts[0]);
    return parts;
}

}  // namespace claque::lod
