#include "lib/lod/chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/error.h"
#include "lib/lod/candidates.h"
#include "lib/lod/far.h"
#include "lib/lod/plain.h"
#include "lib/lod/samples.h"
#include "lib/lod/seen.h"
#include "lib/lod/shares.h"

namespace claque::lod
{

namespace
{

// A pixel at one metre, with 768 lines over 60 degrees: where distances of levels are at home (S0 5).
const double pixel_at_a_metre = 2 * std::sqrt(1.0 / 3.0) / 768;

constexpr int most_tries = 3;  // to keep to most_drift

bool takes_part(const model::Part &part)
{
    return !part.hidden && part.lod_first_m == 0 && std::isinf(part.lod_last_m) && !model::triangles_of(part).empty();
}

// What levels are made of.
struct Source {
    std::vector<size_t> places;  // of model.parts
    std::vector<const model::Part *> parts;
    size_t triangles = 0;
    bool articulated = false;          // skinned, or on several nodes
    std::vector<double> seen, shares;  // seen.h, shares.h
};

Source source_of(const model::Model &model, const base::Jobs &jobs)
{
    Source source;
    for (size_t i = 0; i < model.parts.size(); ++i) {
        const model::Part &part = model.parts[i];
        if (!takes_part(part)) continue;
        source.places.push_back(i);
        source.parts.push_back(&part);
        source.triangles += model::triangles_of(part).size();
        source.articulated = source.articulated || part.skinned || part.node != source.parts[0]->node;
    }
    if (source.parts.empty()) base::fail(CLQ_ARGUMENT, "'%s' has no part to make levels of", model.name.c_str());
    const PosedParts rest = posed_at_rest(model.rig, source.parts);
    source.seen = seen_of(model, rest, jobs);
    source.shares = zone_shares(model, rest, source.seen);
    return source;
}

Candidate finest_of(const Source &source)
{
    Candidate made;
    made.level.triangles = source.triangles;
    for (const model::Part *part : source.parts) {
        made.parts.push_back(*part);
        made.level.vertices += part->positions.size();
    }
    return made;
}

// Near levels as far as seams let them come down, and how far each is from the zones of the source.
struct Near {
    std::vector<Decimated> levels;
    std::vector<double> drifts;
    size_t good = 0;       // those from this one on do not keep to what is promised
    bool drifted = false;  // by their zones
};

Near made_near(const model::Model &model, const std::vector<Piece> &pieces, const std::vector<double> &shares,
               const Decimation &how, const ChainWish &wish)
{
    Near near;
    near.levels = wish.plain ? decimated_plainly(pieces, how.targets) : decimate(pieces, how, wish.jobs);
    near.drifts.resize(near.levels.size());
    wish.jobs.try_each(static_cast<uint32_t>(near.levels.size()), [&](uint32_t k) {
        near.drifts[k] = largest_drift(shares, zone_shares(model, pointers(near.levels[k].parts)));
    });
    while (near.good < near.levels.size() && near.drifts[near.good] <= most_drift &&
           near.levels[near.good].triangles * 20 <= how.targets[near.good] * 21)
        ++near.good;
    near.drifted = near.good < near.levels.size() && near.drifts[near.good] > most_drift;
    return near;
}

// Those of `targets`, descending, from the first on that seams and borders keep it from or that would not keep its zones: where
// there are far levels these take over there.
std::vector<size_t> add_near(const model::Model &model, const Source &source, const std::vector<size_t> &targets,
                             const ChainWish &wish, bool has_far, std::vector<Candidate> &made)
{
    Decimation how = wish.how;
    how.targets = targets, how.model = &model;
    const std::vector<std::vector<glm::vec3>> rest = at_rest(model.rig, source.parts);
    std::vector<Piece> pieces;
    for (size_t i = 0; i < source.parts.size(); ++i) pieces.push_back({source.parts[i], &rest[i]});
    Near near = made_near(model, pieces, source.shares, how, wish);
    // A little beyond what is promised is often within it where zones cost more.
    for (int i = 0; i < most_tries && has_far && near.drifted && near.drifts[near.good] < 1.25 * most_drift &&
                    targets[near.good] > wish.far_from;
         ++i) {
        how.drift *= 1.4;
        if (Near again = made_near(model, pieces, source.shares, how, wish); again.good > near.good)
            near = std::move(again);
    }
    for (size_t k = 0; k < near.levels.size(); ++k) {
        if (has_far && k == near.good) return {targets.begin() + static_cast<ptrdiff_t>(k), targets.end()};
        if (near.levels[k].triangles >= triangles_of(made.back())) continue;
        Candidate next;
        next.level.flipped = near.levels[k].flipped;
        next.level.zone_drift = near.drifts[k];
        next.parts = std::move(near.levels[k].parts);
        made.push_back(std::move(next));
    }
    return {};
}

// `model` gets the materials and the images of these levels, and keys that tell all its zones apart.
void add_far(model::Model &model, const std::vector<const model::Part *> &source, const FarWish &wish,
             const base::Jobs &jobs, std::vector<Candidate> &made)
{
    FarLevels far = make_far(model, source, wish, jobs);
    enter(far, model);
    for (model::Part &part : far.parts) {
        Candidate next;
        next.is_far = true;
        next.parts.push_back(std::move(part));
        made.push_back(std::move(next));
    }
}

void measure(const model::Model &model, const Source &source, const ChainWish &wish, std::vector<Candidate> &made)
{
    std::vector<const std::vector<model::Part> *> levels;
    std::vector<size_t> fresh;
    for (size_t k = 1; k < made.size(); ++k)
        if (!made[k].is_measured) fresh.push_back(k), levels.push_back(&made[k].parts);
    const std::vector<Deviation> found =
        deviations(model, source.parts, source.seen, levels, wish.sampling, wish.metres_per_unit, wish.jobs);
    for (size_t i = 0; i < fresh.size(); ++i) {
        const size_t k = fresh[i];
        ChainLevel &level = made[k].level;
        made[k].is_measured = true;
        level.triangles = triangles_of(made[k]), level.vertices = 0;
        for (const model::Part &part : made[k].parts) level.vertices += part.positions.size();
        level.deviation = found[i];
        level.error_m = 2 * level.deviation.posed_rms_m;
        level.first_m = distance_of(level.error_m, wish.tolerance_px);
        // Where each is kept distances must ascend; else what is coarser and no further off takes a level's place.
        if (wish.plain) level.first_m = std::max(level.first_m, made[k - 1].level.first_m * 1.001 + 0.001);
        if (made[k].is_far)
            level.zone_drift = largest_drift(source.shares, zone_shares(model, pointers(made[k].parts)));
    }
}

std::vector<size_t> checked(std::vector<size_t> targets)
{
    for (size_t k = 0; k < targets.size(); ++k)
        if (targets[k] < 4 || (k > 0 && targets[k] >= targets[k - 1]))
            base::fail(CLQ_ARGUMENT, "level %zu asks for %zu triangles: levels go down, and none has fewer than 4",
                       k + 1, targets[k]);
    return targets;
}

}  // namespace

std::vector<size_t> usual_targets(size_t triangles)
{
    std::vector<size_t> targets;
    for (size_t n = triangles / 2; n > 1300; n /= 2) targets.push_back(n);
    for (const size_t n : {1040, 934, 839, 753, 676, 607, 545, 490, 250, 120, 60, 42, 30, 20, 14})
        if (n * 100 <= triangles * 95) targets.push_back(n);
    return targets;
}

double distance_of(double error_m, double pixels) { return error_m / (pixels * pixel_at_a_metre); }

std::vector<ChainLevel> make_chain(model::Model &model, const ChainWish &wish)
{
    const Source source = source_of(model, wish.jobs);
    if (!(wish.tolerance_px > 0))
        base::fail(CLQ_ARGUMENT, "the tolerance of levels is %g pixels, not above 0", wish.tolerance_px);
    const bool has_far = source.articulated && wish.far_from > 0 && !wish.plain;
    std::vector<size_t> near_targets, far_targets;
    for (const size_t n : checked(wish.targets.empty() ? usual_targets(source.triangles) : wish.targets)) {
        if (n >= source.triangles) continue;
        if (!has_far || n > std::min<size_t>(wish.far_from, most_clean)) near_targets.push_back(n);
        if (has_far && n <= wish.far_from) far_targets.push_back(n);
    }
    // Materials, images and keys as they will be.
    model::Model next;
    next.name = model.name, next.rig = model::Rig(model.rig, std::pmr::get_default_resource());
    next.zones = model.zones, next.images = model.images, next.materials = model.materials;
    next.texture_sets = model.texture_sets;

    std::vector<Candidate> made = {finest_of(source)};
    if (!near_targets.empty()) {
        std::vector<size_t> missed = add_near(next, source, near_targets, wish, has_far, made);
        while (!missed.empty() && missed.back() <= wish.far_from) missed.pop_back();
        far_targets.insert(far_targets.begin(), missed.begin(), missed.end());
    }
    const size_t materials = next.materials.size(), images = next.images.size();
    // Where near levels came as far down as far ones go, those far ones first, to see which are nearer.
    bool compares = has_far && triangles_of(made.back()) <= wish.far_from;
    for (bool again = true; again;) {
        next.materials.resize(materials), next.images.resize(images);
        std::vector<size_t> targets = far_targets;
        while (compares && !targets.empty() && targets.back() <= most_clean) targets.pop_back();
        if (!targets.empty()) add_far(next, source.parts, {targets, wish.how.influence}, wish.jobs, made);
        measure(next, source, wish, made);
        again = compares || (has_far && give_way(made, far_targets));
        if (compares) stay_near(made, far_targets);
        compares = false;
    }
    if (!wish.plain) made = in_use(std::move(made));
    std::vector<ChainLevel> report;
    for (const Candidate &one : made) report.push_back(one.level);
    model.parts = laid_out(model, source.places, std::move(made));
    model.images = std::move(next.images), model.materials = std::move(next.materials);
    model.zones = std::move(next.zones), model.texture_sets = std::move(next.texture_sets);
    return report;
}

}  // namespace claque::lod
