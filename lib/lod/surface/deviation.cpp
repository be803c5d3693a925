#include "lib/lod/surface/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "lib/lod/surface/surface_samples.h"
#include "lib/lod/surface/visibility.h"
#include "lib/math/simd.h"
#include "lib/model/model_size.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

struct Sum {
    double max_square = 0, squares = 0, weight = 0;
    void add(double square, double w)
    {
        max_square = std::max(max_square, square);
        squares += w * square, weight += w;
    }
    double max() const { return std::sqrt(max_square); }
    double rms() const { return weight > 0 ? std::sqrt(squares / weight) : 0; }
};

// Positions as floats: their precision for a person is a few tenths of a micrometre, and distances take half of the
// time of doubles.
using Points = std::vector<math::F4>;  // lane 3 is 0

Points points_of(const std::vector<glm::dvec3> &positions)
{
    Points out;
    out.reserve(positions.size());
    for (const glm::dvec3 &p : positions) out.push_back(math::F4{float(p.x), float(p.y), float(p.z), 0});
    return out;
}

// A pair as vertices and weights, because it is measured in a hundred poses.
struct Link {
    std::array<uint32_t, 3> here, there;
    std::array<float, 3> here_weights, there_weights;
};

std::array<float, 3> as_floats(const glm::dvec3 &w) { return {float(w.x), float(w.y), float(w.z)}; }

// All pairs, and the area that each represents. Pairs of one vertex, a corner of several triangles, share one link.
struct Links {
    struct Weighed {
        uint32_t link;
        double area;
    };
    std::vector<Link> links;
    std::vector<Weighed> all;
};

void add_distances(const Points &from, const Points &to, const Links &links, Sum &sum)
{
    const math::F4 *a = from.data(), *b = to.data();
    const auto at = [](const math::F4 *p, const std::array<uint32_t, 3> &v, const std::array<float, 3> &w) {
        return math::splat(w[0]) * p[v[0]] + math::splat(w[1]) * p[v[1]] + math::splat(w[2]) * p[v[2]];
    };
    std::vector<float> squares;
    squares.reserve(links.links.size());
    for (const Link &l : links.links) {
        const math::F4 off = at(a, l.here, l.here_weights) - at(b, l.there, l.there_weights), square = off * off;
        squares.push_back(square[0] + square[1] + square[2]);
    }
    for (const Links::Weighed &one : links.all) sum.add(double(squares[one.link]), one.area);
}

// Leaves out pairs of no area. area(pair): the area that the pair represents.
template <class Area>
Links links_of(const PosedParts &from, const PosedParts &to, const std::vector<PointPair> &pairs, const Area &area)
{
    Links out;
    std::vector<uint32_t> of_vertex(from.positions().size(), model::none);
    for (const PointPair &pair : pairs) {
        const double stands_for = pair.weight * area(pair);
        if (!(stands_for > 0)) continue;
        const std::array<uint32_t, 3> here = from.vertices_of(pair.here.triangle);
        uint32_t *known = pair.corner == PointPair::inside ? nullptr : &of_vertex[here[pair.corner]];
        const uint32_t link = known && *known != model::none ? *known : static_cast<uint32_t>(out.links.size());
        if (link == out.links.size())
            out.links.push_back({here, to.vertices_of(pair.there.triangle), as_floats(pair.here.weights),
                                 as_floats(pair.there.weights)});
        if (known) *known = link;
        out.all.push_back({link, stands_for});
    }
    return out;
}

double wrong_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                   const std::vector<PointPair> &pairs, const std::vector<double> &areas)
{
    double wrong = 0, all = 0;
    for (const PointPair &pair : pairs) {
        if (pair.corner != PointPair::inside || is_hole(model, source, pair.here)) continue;
        const double area = areas[pair.here.triangle];
        all += area;
        if (zone_at(model, source, pair.here) != zone_at(model, level, pair.there)) wrong += area;
    }
    return all > 0 ? wrong / all : 0;
}

size_t open_edges(const PosedParts &parts)
{
    using Point = std::tuple<double, double, double>;
    std::map<std::pair<Point, Point>, int> edges;
    const auto point = [](glm::dvec3 p) { return Point(p.x, p.y, p.z); };
    for (const PosedParts::Triangle &t : parts.triangles())
        for (size_t k = 0; k < 3; ++k) {
            const Point a = point(parts.corner(t, k)), b = point(parts.corner(t, (k + 1) % 3));
            const auto back = edges.find({b, a});
            if (back != edges.end() && back->second > 0) --back->second;
            else ++edges[{a, b}];
        }
    size_t open = 0;
    for (const auto &[edge, count] : edges) open += static_cast<size_t>(count);
    return open;
}

std::vector<double> areas_of(const PosedParts &parts)
{
    std::vector<double> areas;
    for (uint32_t t = 0; t < parts.triangles().size(); ++t) areas.push_back(area_of(parts, t));
    return areas;
}

// One level against the source. Each source triangle counts by its visible area.
struct LevelComparison {
    PosedParts coarse;
    Links out, back;  // from the source to the level, and back
    Sum rest, posed;
    double wrong_zone = 0;
    LookDifference look;
    size_t open_edges = 0;

    explicit LevelComparison(const std::vector<model::Part> &level) : coarse(pointers(level)) {}
    void match_out(const model::Model &model, const PosedParts &fine, const std::vector<double> &areas,
                   const TextureLooks *looks, double metres_per_unit)
    {
        const std::vector<PointPair> pairs = nearest_pairs(fine, coarse);
        out = links_of(fine, coarse, pairs, [&](const PointPair &pair) { return areas[pair.here.triangle]; });
        wrong_zone = wrong_zones(model, fine, coarse, pairs, areas);
        if (looks) look = looks->difference(fine, coarse, pairs, areas, metres_per_unit);
    }
    // A point of the level counts as visible as the nearest point of the source.
    void match_back(const PosedParts &fine, const PartTrees &trees, const std::vector<double> &visibility)
    {
        const std::vector<double> areas = areas_of(coarse);
        back = links_of(coarse, fine, trees.nearest_pairs(coarse), [&](const PointPair &pair) {
            return areas[pair.here.triangle] * visibility[pair.there.triangle];
        });
        open_edges = lod::open_edges(coarse);
    }
    void add(const Points &fine, Sum &sum) const
    {
        const Points here = points_of(coarse.positions());
        add_distances(fine, here, out, sum);
        add_distances(here, fine, back, sum);
    }
};

// A pose of the rig, with the source's positions in it.
struct SampledPose {
    std::vector<math::Affine> palette;
    std::vector<float> weights;
    Points fine;

    void pose(const model::Rig &rig, PosedParts &parts) const
    {
        parts.pose(rig, base::Span<const math::Affine>(palette), base::Span<const float>(weights));
    }
};

using LevelList = base::Span<const std::vector<model::Part> *const>;

// Levels whose pairs are held at one time.
std::vector<Deviation> deviations_at_once(const model::Model &model, const std::vector<const model::Part *> &source,
                                          const std::vector<double> &visibility, LevelList levels,
                                          const Sampling &sampling, double metres_per_unit, const base::Jobs &jobs,
                                          const TextureLooks *looks)
{
    PosedParts fine(source);
    std::vector<LevelComparison> all;
    for (const std::vector<model::Part> *level : levels) all.emplace_back(*level);
    const uint32_t count = static_cast<uint32_t>(all.size());
    pose::Workspace workspace(model.rig);
    const auto pose = [&](uint32_t clip, double time_s) {
        const base::Span<const math::Affine> palette = workspace.pose(clip, time_s);
        const base::Span<const float> weights = workspace.weights();
        fine.pose(model.rig, palette, weights);
        return SampledPose{
            {palette.begin(), palette.end()}, {weights.begin(), weights.end()}, points_of(fine.positions())};
    };
    const auto go = [&](LevelComparison &one, const SampledPose &sampled_pose, Sum &sum) {
        sampled_pose.pose(model.rig, one.coarse);
        one.add(sampled_pose.fine, sum);
    };
    const SampledPose rest = pose(model::none, 0);
    std::vector<double> areas = areas_of(fine);
    for (size_t t = 0; t < areas.size(); ++t) areas[t] *= visibility[t];
    const size_t open_before = open_edges(fine);
    const PartTrees trees(fine);
    jobs.try_each(count, [&](uint32_t k) { rest.pose(model.rig, all[k].coarse); });
    jobs.try_each(2 * count, [&](uint32_t k) {
        if (k % 2 == 0) all[k / 2].match_out(model, fine, areas, looks, metres_per_unit);
        else all[k / 2].match_back(fine, trees, visibility);
    });
    jobs.try_each(count, [&](uint32_t k) { go(all[k], rest, all[k].rest); });
    const uint32_t clips = std::min(sampling.max_clips, static_cast<uint32_t>(model.rig.clips.size()));
    for (uint32_t clip = 0; clip < clips; ++clip) {
        const model::Clip &c = model.rig.clips[clip];
        std::vector<SampledPose> sampled_poses;
        for (uint32_t i = 0; i < sampling.poses_per_clip; ++i)
            sampled_poses.push_back(
                pose(clip, double(c.start_s) + double(c.duration_s) * (i + 0.5) / sampling.poses_per_clip));
        // One task sums all poses of a level in time order, so that the result does not depend on the jobs.
        jobs.try_each(count, [&](uint32_t k) {
            for (const SampledPose &sampled_pose : sampled_poses) go(all[k], sampled_pose, all[k].posed);
        });
    }
    std::vector<Deviation> found(all.size());
    for (size_t k = 0; k < all.size(); ++k) {
        const Sum &at_rest = all[k].rest, &moving = clips == 0 || sampling.poses_per_clip == 0 ? at_rest : all[k].posed;
        found[k].rest_max_m = at_rest.max() * metres_per_unit, found[k].rest_rms_m = at_rest.rms() * metres_per_unit;
        found[k].posed_max_m = moving.max() * metres_per_unit, found[k].posed_rms_m = moving.rms() * metres_per_unit;
        found[k].wrong_zone = all[k].wrong_zone, found[k].look = all[k].look;
        found[k].open_edges = all[k].open_edges > open_before ? all[k].open_edges - open_before : 0;
    }
    return found;
}

size_t triangles_of(const std::vector<const model::Part *> &parts)
{
    size_t count = 0;
    for (const model::Part *part : parts) count += model::triangles_of(*part).size();
    return count;
}

}  // namespace

std::vector<Deviation> deviations(const model::Model &model, const std::vector<const model::Part *> &source,
                                  const std::vector<double> &visibility,
                                  const std::vector<const std::vector<model::Part> *> &levels, const Sampling &sampling,
                                  double metres_per_unit, const base::Jobs &jobs, const TextureLooks *looks)
{
    // All levels together, where their pairs take a quarter of what levels may take at most (docs/levels.md); else as
    // many as do, at least one.
    constexpr uint64_t bytes_of_pair = 100;
    const uint64_t most = (64 * model::source_bytes(model) + (16ull << 20)) / 4;
    const uint64_t fine = bytes_of_pair * max_pairs(triangles_of(source));
    std::vector<Deviation> found;
    for (size_t first = 0, last = 0; first < levels.size(); first = last) {
        for (uint64_t bytes = 0; last < levels.size(); ++last) {
            bytes += fine + bytes_of_pair * max_pairs(triangles_of(pointers(*levels[last])));
            if (last > first && bytes > most) break;
        }
        const LevelList some(levels.data() + first, static_cast<uint32_t>(last - first));
        for (const Deviation &one :
             deviations_at_once(model, source, visibility, some, sampling, metres_per_unit, jobs, looks))
            found.push_back(one);
    }
    return found;
}

void compare_textures(const model::Model &model, const PosedParts &source, const std::vector<double> &visibility,
                      const std::vector<model::Part> &level, const TextureLooks *looks, double metres_per_unit,
                      Deviation &deviation)
{
    const PosedParts coarse = posed_at_rest(model.rig, pointers(level));
    std::vector<double> areas = areas_of(source);
    for (size_t t = 0; t < areas.size(); ++t) areas[t] *= visibility[t];
    const std::vector<PointPair> pairs = nearest_pairs(source, coarse);
    deviation.wrong_zone = wrong_zones(model, source, coarse, pairs, areas);
    if (looks) deviation.look = looks->difference(source, coarse, pairs, areas, metres_per_unit);
}

Deviation deviation(const model::Model &model, const std::vector<const model::Part *> &source,
                    const std::vector<model::Part> &level, const Sampling &sampling, double metres_per_unit)
{
    return deviations(model, source, visibility_of(model, posed_at_rest(model.rig, source)), {&level}, sampling,
                      metres_per_unit)[0];
}

}  // namespace claque::lod
