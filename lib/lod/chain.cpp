#include "lib/lod/chain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "lib/base/error.h"
#include "lib/lod/candidates.h"
#include "lib/lod/proxies/proxy.h"
#include "lib/lod/surface/area_fractions.h"
#include "lib/lod/surface/surface_samples.h"
#include "lib/lod/surface/visibility.h"
#include "lib/model/model_size.h"

namespace claque::lod
{

namespace
{

// The size of a pixel at one metre, with 768 lines over 60 degrees: the reference view for distances of levels (S0 5).
const double pixel_at_a_metre = 2 * std::sqrt(1.0 / 3.0) / 768;

bool takes_part(const model::Part &part)
{
    return !part.hidden && part.lod_min_m == 0 && std::isinf(part.lod_max_m) && !model::triangles_of(part).empty();
}

// The parts that levels are made from.
struct Source {
    std::vector<size_t> part_indices;  // indices into model.parts
    std::vector<const model::Part *> parts;
    size_t triangles = 0;
    bool articulated = false;                        // skinned, or on several nodes
    std::vector<double> visibility, area_fractions;  // see visibility.h and area_fractions.h
    double shown_m2 = 0;                             // of the surface, the mean of all directions
    TextureLooks looks;
    bool has_zone_keys = false;  // in any image
};

// Levels keep all candidates at once and search them in many poses. That takes so many bytes, measured with meshes of
// 100 to 100 000 triangles (tests/unit/work/memory_test.cpp); a model may take a multiple of what was read for it.
void check_size(const model::Model &model, const Source &source)
{
    constexpr uint64_t bytes_of_triangle = 2000, bytes_of_vertex = 100, multiple = 64, always_bytes = 16ull << 20;
    uint64_t vertices = 0;
    for (const model::Part *part : source.parts) vertices += part->positions.size();
    const uint64_t wanted = bytes_of_triangle * source.triangles + bytes_of_vertex * vertices;
    const uint64_t read = model::source_bytes(model), most = multiple * read + always_bytes;
    if (wanted > most)
        base::fail(CLQ_LIMIT,
                   "'%s' has %zu triangles and %llu vertices, whose levels of detail would take %llu bytes, and %llu "
                   "are the most: %llu for each of the %llu bytes read, and %llu",
                   model.name.c_str(), source.triangles, base::big(vertices), base::big(wanted), base::big(most),
                   base::big(multiple), base::big(read), base::big(always_bytes));
}

Source source_of(const model::Model &model, double metres_per_unit, const base::Jobs &jobs)
{
    Source source;
    for (size_t i = 0; i < model.parts.size(); ++i) {
        const model::Part &part = model.parts[i];
        if (!takes_part(part)) continue;
        source.part_indices.push_back(i);
        source.parts.push_back(&part);
        source.triangles += model::triangles_of(part).size();
        source.articulated = source.articulated || part.skinned || part.node != source.parts[0]->node;
    }
    if (source.parts.empty())
        base::fail(CLQ_ARGUMENT, "'%s' has no visible part to make levels from", model.name.c_str());
    check_size(model, source);
    source.looks.add(model);
    for (const model::Image &image : model.images)
        source.has_zone_keys = source.has_zone_keys || image.alpha == model::AlphaMeaning::zone_keys;
    const PosedParts rest = posed_at_rest(model.rig, source.parts);
    source.visibility = visibility_of(model, rest, jobs);
    source.area_fractions = zone_area_fractions(model, rest, source.visibility);
    // Half of all directions look at a point's front, and see on average half of its area.
    for (uint32_t t = 0; t < source.visibility.size(); ++t)
        source.shown_m2 += 0.5 * area_of(rest, t) * source.visibility[t] * metres_per_unit * metres_per_unit;
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

// Decimated levels as coarse as seams allow.
std::vector<Candidate> near_levels(const model::Model &model, const Source &source, const std::vector<size_t> &targets,
                                   const ChainOptions &options, const base::Jobs &jobs)
{
    if (targets.empty()) return {};
    DecimationOptions decimation = options.decimation;
    decimation.targets = targets, decimation.model = &model;
    const std::vector<std::vector<glm::vec3>> rest = rest_positions(model.rig, source.parts);
    std::vector<SourcePart> pieces;
    for (size_t i = 0; i < source.parts.size(); ++i) pieces.push_back({source.parts[i], &rest[i]});
    std::vector<Decimated> levels =
        options.quadric_only ? decimate_quadric_only(pieces, targets) : decimate(pieces, decimation);
    std::vector<Candidate> made(levels.size());
    jobs.try_each(static_cast<uint32_t>(made.size()), [&](uint32_t k) {
        made[k].target = targets[k], made[k].parts = std::move(levels[k].parts);
        made[k].level.triangles = levels[k].triangles, made[k].level.flipped = levels[k].flipped;
        made[k].level.zone_area_error =
            zone_area_error(source.area_fractions, zone_area_fractions(model, pointers(made[k].parts)));
    });
    return made;
}

// Adds decimated levels to `made`; where proxies follow, none that fails. Returns the targets after the last that does
// not fail, which proxies take over; none without proxies. A target fails if seams and borders keep decimation from
// reaching it or if the zone area error is too large.
std::vector<size_t> add_near_levels(const std::vector<size_t> &targets, std::vector<Candidate> levels, bool has_proxies,
                                    std::vector<Candidate> &made)
{
    std::vector<size_t> missed = targets;
    for (Candidate &one : levels) {
        const LevelReport &level = one.level;
        const bool fits = level.zone_area_error <= max_zone_area_error && level.triangles * 20 <= one.target * 21;
        if (has_proxies && !fits) continue;
        missed.erase(missed.begin(), std::find(missed.begin(), missed.end(), one.target) + 1);
        if (level.triangles < triangle_count_of(made.back())) made.push_back(std::move(one));
    }
    return has_proxies ? missed : std::vector<size_t>();
}

void measure(const model::Model &model, const Source &source, const ChainOptions &options, std::vector<Candidate> &made)
{
    std::vector<const std::vector<model::Part> *> levels;
    std::vector<size_t> fresh;
    for (size_t k = 1; k < made.size(); ++k)
        if (!made[k].is_measured) fresh.push_back(k), levels.push_back(&made[k].parts);
    const std::vector<Deviation> found = deviations(model, source.parts, source.visibility, levels, options.sampling,
                                                    options.metres_per_unit, options.jobs, &source.looks);
    for (size_t i = 0; i < fresh.size(); ++i) {
        const size_t k = fresh[i];
        LevelReport &level = made[k].level;
        made[k].is_measured = true;
        level.triangles = triangle_count_of(made[k]), level.vertices = 0;
        for (const model::Part &part : made[k].parts) level.vertices += part.positions.size();
        level.deviation = found[i];
        level.error_m = 2 * level.deviation.posed_rms_m;
        level.distance_m = switch_distance(level.error_m, options.tolerance_px);
        // Distances of levels that are all kept must ascend. Otherwise prune() drops a level for a coarser one with no
        // larger error.
        if (options.quadric_only)
            level.distance_m = std::max(level.distance_m, made[k - 1].level.distance_m * 1.001 + 0.001);
    }
}

// Measures decimated levels and proxies, and leaves in `made` those that form the chain. `proxies`: one for each
// target, without images.
void choose(const model::Model &model, const Source &source, const ChainOptions &options,
            std::vector<size_t> proxy_targets, std::map<size_t, Candidate> &proxies, std::vector<Candidate> &made)
{
    // If decimation reached `proxy_max_triangles`, measure only the overlapping proxies first and compare errors.
    bool compares = !proxies.empty() && triangle_count_of(made.back()) <= options.proxy_max_triangles;
    for (bool again = true; again;) {
        std::vector<size_t> targets = proxy_targets;
        while (compares && !targets.empty() && targets.back() <= max_clean_triangles) targets.pop_back();
        for (const size_t target : targets) made.push_back(proxies.at(target));
        measure(model, source, options, made);
        for (const Candidate &one : made)
            if (one.is_proxy) proxies.at(one.target) = one;
        again = compares || (!proxies.empty() && replace_by_proxy(made, proxy_targets));
        if (compares) prefer_near(made, proxy_targets);
        compares = false;
    }
}

// Returns what a level's zones may be off: 2 points of the surface or, in a level of few triangles, half of a pixel
// where it begins.
double zone_tolerance_of(const Source &source, const Candidate &made)
{
    const double pixel_m = pixel_at_a_metre * made.level.distance_m;
    if (made.level.triangles >= 20 || !(source.shown_m2 > 0)) return max_zone_area_error;
    return std::max(max_zone_area_error, 0.5 * pixel_m * pixel_m / source.shown_m2);
}

// Gives the proxies of `made` their images. `model` gets these, and zone keys that are all different.
void bake(model::Model &model, Source &source, const ChainOptions &options, std::vector<Candidate> &made)
{
    std::vector<Candidate *> proxies;
    std::vector<model::Part> meshes;
    std::vector<double> tolerances;
    for (Candidate &one : made) {
        if (!one.is_proxy) continue;
        proxies.push_back(&one), meshes.push_back(std::move(one.parts[0]));
        tolerances.push_back(one.zone_tolerance = zone_tolerance_of(source, one));
    }
    if (proxies.empty()) return;
    const ProxySource from(model, posed_at_rest(model.rig, source.parts), source.visibility, options.jobs);
    ProxyLevels baked = bake_proxies(from, std::move(meshes), tolerances, options.jobs);
    for (size_t i = 0; i < proxies.size(); ++i) proxies[i]->parts[0] = std::move(baked.parts[i]);
    add_to_model(baked, model);
    source.looks.add(model);
    options.jobs.try_each(static_cast<uint32_t>(proxies.size()), [&](uint32_t i) {
        LevelReport &level = proxies[i]->level;
        level.vertices = proxies[i]->parts[0].positions.size();
        const bool by_zones = level.triangles <= max_clean_triangles && source.has_zone_keys;
        const TextureLooks *looks = by_zones ? nullptr : &source.looks;
        compare_textures(model, from.fine, source.visibility, proxies[i]->parts, looks, options.metres_per_unit,
                         level.deviation);
        const std::vector<double> fractions =
            zone_area_fractions(model, from.at_rest(proxies[i]->parts[0]), baked.visibility[i]);
        level.zone_area_error = zone_area_error(source.area_fractions, fractions);
        if (level.triangles <= max_clean_triangles) level.zone_view_error = from.views.error(proxies[i]->parts[0]);
        const double tolerance = proxies[i]->zone_tolerance;
        proxies[i]->loses_zone =
            loses_zone(source.area_fractions, fractions, tolerance > max_zone_area_error ? tolerance : least_zone);
    });
    for (Candidate *proxy : proxies) {
        proxy->parts = split_by_lighting(from, std::move(proxy->parts[0]), model);
        proxy->level.vertices = 0;
        for (const model::Part &part : proxy->parts) proxy->level.vertices += part.positions.size();
    }
}

std::vector<size_t> checked(std::vector<size_t> targets)
{
    for (size_t k = 0; k < targets.size(); ++k)
        if (targets[k] < 4 || (k > 0 && targets[k] >= targets[k - 1]))
            base::fail(CLQ_ARGUMENT, "level %zu has a target of %zu triangles: targets must descend and be at least 4",
                       k + 1, targets[k]);
    return targets;
}

}  // namespace

std::vector<size_t> default_targets(size_t triangles)
{
    std::vector<size_t> targets;
    for (size_t n = triangles / 2; n > 1300; n /= 2) targets.push_back(n);
    for (const size_t n :
         {1040, 934, 839, 753, 676, 607, 545, 490, 430, 375, 330, 290, 250, 205, 165, 120, 84, 60, 42, 30, 20, 14, 10})
        if (n * 100 <= triangles * 95) targets.push_back(n);
    return targets;
}

double switch_distance(double error_m, double pixels) { return error_m / (pixels * pixel_at_a_metre); }

std::vector<LevelReport> make_chain(model::Model &model, const ChainOptions &options)
{
    Source source = source_of(model, options.metres_per_unit, options.jobs);
    if (!(options.tolerance_px > 0))
        base::fail(CLQ_ARGUMENT, "the tolerance of levels is %g pixels: it must be above 0", options.tolerance_px);
    const bool has_proxies = source.articulated && options.proxy_max_triangles > 0 && !options.quadric_only;
    std::vector<size_t> targets, near_targets, proxy_targets;
    for (const size_t n : checked(options.targets.empty() ? default_targets(source.triangles) : options.targets)) {
        if (n >= source.triangles) continue;
        targets.push_back(n);
        if (!has_proxies || n > std::min<size_t>(options.proxy_max_triangles, max_clean_triangles))
            near_targets.push_back(n);
        if (has_proxies && n <= options.proxy_max_triangles) proxy_targets.push_back(n);
    }
    // The materials, images and keys of the result.
    model::Model next;
    next.name = model.name, next.rig = model::Rig(model.rig, std::pmr::get_default_resource());
    next.zones = model.zones, next.images = model.images, next.materials = model.materials;
    next.texture_sets = model.texture_sets, next.source_bytes = model::source_bytes(model);

    // The two kinds of level do not depend on each other, and making either is a chain of steps.
    std::vector<Candidate> near;
    std::vector<model::Part> meshes;
    const auto make_kind = [&](uint32_t kind) {
        if (kind == 1) meshes = proxy_meshes(next, source.parts, {targets, options.decimation.influence});
        else near = near_levels(next, source, near_targets, options, has_proxies ? base::Jobs() : options.jobs);
    };
    if (has_proxies) options.jobs.try_each(2, make_kind);
    else make_kind(0);
    std::map<size_t, Candidate> proxies;
    for (size_t i = 0; i < meshes.size(); ++i) {
        Candidate &proxy = proxies[targets[i]];
        proxy.is_proxy = true, proxy.target = targets[i];
        proxy.parts.push_back(std::move(meshes[i]));
    }
    std::vector<Candidate> made = {finest_of(source)};
    std::vector<size_t> missed = add_near_levels(near_targets, std::move(near), has_proxies, made);
    while (!missed.empty() && missed.back() <= options.proxy_max_triangles) missed.pop_back();
    proxy_targets.insert(proxy_targets.begin(), missed.begin(), missed.end());
    choose(next, source, options, proxy_targets, proxies, made);
    bake(next, source, options, made);
    if (!options.quadric_only) raise_distances(made, options.tolerance_px), made = prune(std::move(made));
    std::vector<LevelReport> report;
    for (const Candidate &one : made) report.push_back(one.level);
    model.parts = assemble(model, source.part_indices, std::move(made));
    model.images = std::move(next.images), model.materials = std::move(next.materials);
    model.zones = std::move(next.zones), model.texture_sets = std::move(next.texture_sets);
    return report;
}

}  // namespace claque::lod
