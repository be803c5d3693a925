#include "lib/lod/chain.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::lod
{

namespace
{

// A pixel at one metre, with 768 lines over 60 degrees: where distances of levels are at home (S0 5).
const double pixel_at_a_metre = 2 * std::sqrt(1.0 / 3.0) / 768;

bool takes_part(const model::Part &part)
{
    return !part.hidden && part.lod_first_m == 0 && std::isinf(part.lod_last_m) && !model::triangles_of(part).empty();
}

size_t vertices_of(const std::vector<const model::Part *> &parts)
{
    size_t count = 0;
    for (const model::Part *part : parts) count += part->positions.size();
    return count;
}

struct Made {
    ChainLevel level;
    std::vector<model::Part> parts;
};

// Distances must ascend, and a level that serves nowhere costs memory for nothing.
std::vector<Made> in_use(std::vector<Made> made)
{
    std::vector<Made> kept;
    for (size_t k = made.size(); k-- > 0;) {
        if (!kept.empty()) {
            Made &next = kept.back();
            if (made[k].level.first_m >= next.level.first_m) continue;
            if (made[k].level.triangles * 10 < next.level.triangles * 11) continue;
        }
        kept.push_back(std::move(made[k]));
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

void check(const std::vector<size_t> &targets)
{
    for (size_t k = 0; k < targets.size(); ++k)
        if (targets[k] < 4 || (k > 0 && targets[k] >= targets[k - 1]))
            base::fail(CLQ_ARGUMENT, "level %zu asks for %zu triangles: levels go down, and none has fewer than 4",
                       k + 1, targets[k]);
}

}  // namespace

std::vector<size_t> usual_targets(size_t triangles)
{
    std::vector<size_t> targets;
    for (size_t n = triangles / 2; n > 1300; n /= 2) targets.push_back(n);
    for (const size_t n : {1040, 934, 839, 753, 676, 607, 545, 490, 250, 120, 60, 30})
        if (n * 100 <= triangles * 95) targets.push_back(n);
    return targets;
}

double distance_of(double error_m, double pixels) { return error_m / (pixels * pixel_at_a_metre); }

std::vector<ChainLevel> make_chain(model::Model &model, const ChainWish &wish)
{
    std::vector<size_t> places;
    std::vector<const model::Part *> source;
    size_t triangles = 0;
    for (size_t i = 0; i < model.parts.size(); ++i) {
        if (!takes_part(model.parts[i])) continue;
        places.push_back(i);
        source.push_back(&model.parts[i]);
        triangles += model::triangles_of(model.parts[i]).size();
    }
    if (source.empty()) base::fail(CLQ_ARGUMENT, "'%s' has no part to make levels of", model.name.c_str());
    if (!(wish.tolerance_px > 0))
        base::fail(CLQ_ARGUMENT, "the tolerance of levels is %g pixels, not above 0", wish.tolerance_px);
    Decimation how = wish.how;
    how.targets = wish.targets.empty() ? usual_targets(triangles) : wish.targets;
    check(how.targets);
    how.targets.erase(std::remove_if(how.targets.begin(), how.targets.end(), [&](size_t n) { return n >= triangles; }),
                      how.targets.end());

    std::vector<Made> made(1);
    made[0].level.triangles = triangles;
    made[0].level.vertices = vertices_of(source);
    for (const model::Part *part : source) made[0].parts.push_back(*part);
    if (!how.targets.empty())
        for (Decimated &less : decimate(source, how)) {
            Made next;
            next.parts = std::move(less.parts);
            next.level.triangles = less.triangles;
            for (const model::Part &part : next.parts) next.level.vertices += part.positions.size();
            next.level.deviation = deviation(model, source, next.parts, wish.sampling, wish.metres_per_unit);
            next.level.error_m = 2 * next.level.deviation.posed_rms_m;
            next.level.first_m =
                std::max(distance_of(next.level.error_m, wish.tolerance_px), made.back().level.first_m);
            made.push_back(std::move(next));
        }
    made = in_use(std::move(made));

    std::vector<model::Part> parts;
    std::vector<ChainLevel> report;
    for (size_t i = 0, at = 0; i < model.parts.size(); ++i) {
        if (at == places.size() || places[at] != i) {
            parts.push_back(model.parts[i]);
            continue;
        }
        for (size_t k = 0; k < made.size(); ++k) {
            model::Part &part = made[k].parts[at];
            if (part.indices.empty() && k > 0) continue;
            part.lod_first_m = static_cast<float>(made[k].level.first_m);
            if (k + 1 < made.size()) part.lod_last_m = static_cast<float>(made[k + 1].level.first_m);
            parts.push_back(std::move(part));
        }
        ++at;
    }
    for (const Made &level : made) report.push_back(level.level);
    model.parts = std::move(parts);
    return report;
}

}  // namespace claque::lod
