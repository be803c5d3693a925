#include "lib/lod/deviation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "lib/lod/samples.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

struct Sum {
    double most = 0, squares = 0, weight = 0;
    void add(double distance, double w)
    {
        most = std::max(most, distance);
        squares += w * distance * distance, weight += w;
    }
    double rms() const { return weight > 0 ? std::sqrt(squares / weight) : 0; }
};

void add_distances(const PosedParts &from, const PosedParts &to, const std::vector<Pair> &pairs,
                   const std::vector<double> &areas, Sum &sum)
{
    for (const Pair &pair : pairs)
        sum.add(glm::length(where(from, pair.here) - where(to, pair.there)), areas[pair.here.triangle]);
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

}  // namespace

Deviation deviation(const model::Model &model, const std::vector<const model::Part *> &source,
                    const std::vector<model::Part> &level, const Sampling &sampling, double metres_per_unit)
{
    PosedParts fine(source), coarse(pointers(level));
    pose::Workspace workspace(model.rig);
    const auto pose = [&](uint32_t clip, double time_s) {
        const base::Span<const math::Affine> palette = workspace.pose(clip, time_s);
        fine.pose(model.rig, palette, workspace.weights());
        coarse.pose(model.rig, palette, workspace.weights());
    };
    pose(model::none, 0);
    const std::vector<Pair> out = nearest_pairs(fine, coarse), back = nearest_pairs(coarse, fine);
    const std::vector<double> fine_areas = areas_of(fine), coarse_areas = areas_of(coarse);
    Deviation found;
    Sum rest, posed;
    const auto add = [&](Sum &sum) {
        add_distances(fine, coarse, out, fine_areas, sum);
        add_distances(coarse, fine, back, coarse_areas, sum);
    };
    add(rest);
    found.wrong_zone = wrong_zones(model, fine, coarse, out, fine_areas);
    const size_t open = open_edges(coarse), open_before = open_edges(fine);
    found.open_edges = open > open_before ? open - open_before : 0;
    const uint32_t clips = std::min(sampling.most_clips, static_cast<uint32_t>(model.rig.clips.size()));
    for (uint32_t clip = 0; clip < clips; ++clip)
        for (uint32_t i = 0; i < sampling.poses_per_clip; ++i) {
            const model::Clip &c = model.rig.clips[clip];
            pose(clip, double(c.start_s) + double(c.duration_s) * (i + 0.5) / sampling.poses_per_clip);
            add(posed);
        }
    if (clips == 0 || sampling.poses_per_clip == 0) posed = rest;
    found.rest_m = rest.most * metres_per_unit, found.rest_rms_m = rest.rms() * metres_per_unit;
    found.posed_m = posed.most * metres_per_unit, found.posed_rms_m = posed.rms() * metres_per_unit;
    return found;
}

}  // namespace claque::lod
