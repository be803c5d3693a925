#include "lib/lod/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "lib/lod/samples.h"
#include "lib/lod/seen.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

struct Sum {
    double most_square = 0, squares = 0, weight = 0;
    void add(double square, double w)
    {
        most_square = std::max(most_square, square);
        squares += w * square, weight += w;
    }
    double most() const { return std::sqrt(most_square); }
    double rms() const { return weight > 0 ? std::sqrt(squares / weight) : 0; }
};

// A pair as its vertices and their weights, and the area it stands for: it is measured in a hundred poses.
struct Link {
    std::array<uint32_t, 3> here, there;
    glm::dvec3 here_weights, there_weights;
    double area;
};

void add_distances(const PosedParts &from, const PosedParts &to, const std::vector<Link> &links, Sum &sum)
{
    const glm::dvec3 *a = from.positions().data(), *b = to.positions().data();
    const auto at = [](const glm::dvec3 *p, const std::array<uint32_t, 3> &v, const glm::dvec3 &w) {
        return w.x * p[v[0]] + w.y * p[v[1]] + w.z * p[v[2]];
    };
    for (const Link &l : links) {
        const glm::dvec3 off = at(a, l.here, l.here_weights) - at(b, l.there, l.there_weights);
        sum.add(glm::dot(off, off), l.area);
    }
}

// Without those that stand for nothing. area(pair): what it stands for.
template <class Area>
std::vector<Link> links_of(const PosedParts &from, const PosedParts &to, const std::vector<Pair> &pairs,
                           const Area &area)
{
    std::vector<Link> out;
    for (const Pair &pair : pairs)
        if (const double stands_for = area(pair); stands_for > 0)
            out.push_back({from.vertices_of(pair.here.triangle), to.vertices_of(pair.there.triangle), pair.here.weights,
                           pair.there.weights, stands_for});
    return out;
}

double wrong_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                   const std::vector<Pair> &pairs, const std::vector<double> &areas)
{
    double wrong = 0, all = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
        if (i % spots_per_triangle >= area_spots) continue;
        const double area = areas[pairs[i].here.triangle];
        all += area;
        if (zone_at(model, source, pairs[i].here) != zone_at(model, level, pairs[i].there)) wrong += area;
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

std::vector<const model::Part *> pointers(const std::vector<model::Part> &parts)
{
    std::vector<const model::Part *> out;
    for (const model::Part &part : parts) out.push_back(&part);
    return out;
}

// The source as it is posed, and how much of each triangle counts: its area, as much of it as can be seen.
struct Fine {
    Fine(const model::Model &model, PosedParts posed) : parts(std::move(posed)), seen(seen_of(model, parts))
    {
        areas = areas_of(parts);
        for (size_t t = 0; t < areas.size(); ++t) areas[t] *= seen[t];
    }
    PosedParts parts;
    std::vector<double> seen, areas;
};

// One level against the source.
struct Beside {
    PosedParts coarse;
    std::vector<Pair> out;                    // from the source to the level
    std::vector<Link> out_links, back_links;  // the same, and from the level
    Sum rest, posed;

    explicit Beside(const std::vector<model::Part> &level) : coarse(pointers(level)) {}
    // What is nearest to something hidden is hidden as well.
    void match(const Fine &fine)
    {
        const std::vector<double> areas = areas_of(coarse);
        out = nearest_pairs(fine.parts, coarse);
        out_links = links_of(fine.parts, coarse, out, [&](const Pair &pair) { return fine.areas[pair.here.triangle]; });
        back_links = links_of(coarse, fine.parts, nearest_pairs(coarse, fine.parts), [&](const Pair &pair) {
            return areas[pair.here.triangle] * fine.seen[pair.there.triangle];
        });
    }
    void add(const Fine &fine, Sum &sum) const
    {
        add_distances(fine.parts, coarse, out_links, sum);
        add_distances(coarse, fine.parts, back_links, sum);
    }
};

}  // namespace

std::vector<Deviation> deviations(const model::Model &model, const std::vector<const model::Part *> &source,
                                  const std::vector<const std::vector<model::Part> *> &levels, const Sampling &sampling,
                                  double metres_per_unit)
{
    PosedParts posed(source);
    std::vector<Beside> all;
    for (const std::vector<model::Part> *level : levels) all.emplace_back(*level);
    pose::Workspace workspace(model.rig);
    const auto pose = [&](uint32_t clip, double time_s, PosedParts &parts) {
        const base::Span<const math::Affine> palette = workspace.pose(clip, time_s);
        parts.pose(model.rig, palette, workspace.weights());
        for (Beside &one : all) one.coarse.pose(model.rig, palette, workspace.weights());
    };
    pose(model::none, 0, posed);
    Fine fine(model, std::move(posed));
    const size_t open_before = open_edges(fine.parts);
    std::vector<Deviation> found(all.size());
    for (size_t k = 0; k < all.size(); ++k) {
        all[k].match(fine);
        all[k].add(fine, all[k].rest);
        found[k].wrong_zone = wrong_zones(model, fine.parts, all[k].coarse, all[k].out, fine.areas);
        const size_t open = open_edges(all[k].coarse);
        found[k].open_edges = open > open_before ? open - open_before : 0;
    }
    const uint32_t clips = std::min(sampling.most_clips, static_cast<uint32_t>(model.rig.clips.size()));
    for (uint32_t clip = 0; clip < clips; ++clip)
        for (uint32_t i = 0; i < sampling.poses_per_clip; ++i) {
            const model::Clip &c = model.rig.clips[clip];
            pose(clip, double(c.start_s) + double(c.duration_s) * (i + 0.5) / sampling.poses_per_clip, fine.parts);
            for (Beside &one : all) one.add(fine, one.posed);
        }
    for (size_t k = 0; k < all.size(); ++k) {
        const Sum &rest = all[k].rest, &moving = clips == 0 || sampling.poses_per_clip == 0 ? rest : all[k].posed;
        found[k].rest_m = rest.most() * metres_per_unit, found[k].rest_rms_m = rest.rms() * metres_per_unit;
        found[k].posed_m = moving.most() * metres_per_unit, found[k].posed_rms_m = moving.rms() * metres_per_unit;
    }
    return found;
}

Deviation deviation(const model::Model &model, const std::vector<const model::Part *> &source,
                    const std::vector<model::Part> &level, const Sampling &sampling, double metres_per_unit)
{
    return deviations(model, source, {&level}, sampling, metres_per_unit)[0];
}

}  // namespace claque::lod
