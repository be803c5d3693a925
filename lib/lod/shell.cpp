#include "lib/lod/shell.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/coarsen.h"
#include "lib/lod/decimate.h"
#include "lib/lod/nearest.h"
#include "lib/lod/reduce.h"
#include "lib/lod/samples.h"
#include "lib/lod/sway.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t most_influences = 4;
// Of an influence: of how far clips part joints, and of the size, as hosts may have others. Found by trying.
constexpr double sway_cost = 0.5, least_cost = 0.05;
constexpr size_t most_reduced = 128;          // triangles: from here down by reduced()
constexpr size_t simple = 1000;               // triangles: what stands in for the fine surface below that
constexpr uint32_t first_zone = 0x80000000u;  // of a feature's numbers: those below are joints

struct Influence {
    uint32_t joint = 0;
    double weight = 0;
};

// What stands at a place: which joints it follows and which zone it shows.
Attributes features_at(const model::Model &model, const PosedParts &parts, const Place &place,
                       const std::vector<double> &influences, double zone_cost)
{
    Attributes found;
    const auto add = [&](uint32_t id, double value) {
        const auto same = std::find_if(found.begin(), found.end(), [&](const Attribute &a) { return a.id == id; });
        if (same != found.end()) same->value += value;
        else found.push_back({id, value});
    };
    const PosedParts::Triangle &t = parts.triangles()[place.triangle];
    const model::Part &part = parts.part(t.part);
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < part.influence_count; ++i) {
            const size_t at = size_t(t.vertices[k]) * part.influence_count + i;
            const double weight = place.weights[static_cast<int>(k)] * double(part.weights[at]);
            if (weight > 0) add(part.joints[at], influences[part.joints[at]] * weight);
        }
    const uint32_t zone = zone_at(model, parts, place);
    if (zone != model::none) add(first_zone + zone, zone_cost);
    std::sort(found.begin(), found.end(), [](const Attribute &a, const Attribute &b) { return a.id < b.id; });
    return found;
}

// The heaviest first.
std::vector<Influence> influences_of(const Features &features, const std::vector<double> &costs)
{
    std::vector<Influence> found;
    for (const Attribute &attribute : features.mean)
        if (attribute.id < first_zone && attribute.value > 0)
            found.push_back({attribute.id, attribute.value / costs[attribute.id]});
    std::sort(found.begin(), found.end(), [](const Influence &a, const Influence &b) {
        return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    found.resize(std::min<size_t>(found.size(), most_influences));
    double sum = 0;
    for (const Influence &f : found) sum += f.weight;
    for (Influence &f : found) f.weight /= sum;
    return found;
}

// A little off the place that it stands for, to its own side: the two sides of a sheet stay apart.
glm::dvec3 drawn_in(glm::dvec3 p, glm::dvec3 nearest, double cell)
{
    const glm::dvec3 off = p - nearest;
    const double distance = glm::length(off);
    if (distance > 1.5 * cell) return p;  // it closes an opening
    const double stay = 0.1 * cell;
    return distance > stay ? nearest + off * (stay / distance) : p;
}

// Of the triangles round each vertex.
std::vector<glm::dvec3> normals_of(const Boundary &surface)
{
    std::vector<glm::dvec3> sums(surface.positions.size(), glm::dvec3(0));
    for (const auto &t : surface.triangles) {
        const glm::dvec3 a = surface.positions[t[0]], b = surface.positions[t[1]], c = surface.positions[t[2]];
        for (const uint32_t v : t) sums[v] += glm::cross(b - a, c - a);
    }
    return sums;
}

math::Affine blended(const std::vector<Influence> &influences, base::Span<const math::Affine> palette)
{
    math::Affine sum;
    for (float &c : sum.c) c = 0;
    for (const Influence &f : influences)
        for (size_t i = 0; i < 12; ++i) sum.c[i] += static_cast<float>(f.weight) * palette[f.joint].c[i];
    return sum;
}

// Without the lightest, where all together fold space up at rest: what lies there would be thrown far away by other poses.
void steady(std::vector<Influence> &influences, base::Span<const math::Affine> palette)
{
    constexpr float least = 0.5f;  // of the space that the heaviest leaves
    const auto space = [&] { return std::abs(math::determinant(blended(influences, palette))); };
    const float own = std::abs(math::determinant(palette[influences[0].joint]));
    while (influences.size() > 1 && space() < least * own) {
        const double lost = influences.back().weight;
        influences.pop_back();
        for (Influence &f : influences) f.weight /= 1 - lost;
    }
}

model::Part part_of(const std::string &name, const Coarse &coarse, const std::vector<double> &costs,
                    base::Span<const math::Affine> palette)
{
    model::Part part;
    part.name = name, part.skinned = true, part.influence_count = most_influences;
    const std::vector<glm::dvec3> normals = normals_of(coarse.surface);
    for (size_t v = 0; v < normals.size(); ++v) {
        std::vector<Influence> influences = influences_of(coarse.features[v], costs);
        steady(influences, palette);
        const math::Affine back = math::inverse(blended(influences, palette));
        part.positions.push_back(math::point(back, glm::vec3(coarse.surface.positions[v])));
        const glm::vec3 n = math::direction(math::normal_matrix(back), glm::vec3(normals[v]));
        const float length = glm::length(n);
        part.normals.push_back(length > 0 ? n / length : glm::vec3(0, 1, 0));
        for (uint32_t k = 0; k < most_influences; ++k) {
            part.joints.push_back(k < influences.size() ? influences[k].joint : 0);
            part.weights.push_back(k < influences.size() ? static_cast<float>(influences[k].weight) : 0);
        }
    }
    for (const auto &t : coarse.surface.triangles) part.indices.insert(part.indices.end(), t.begin(), t.end());
    return part;
}

double size_of(const std::vector<Voxels::Triangle> &triangles)
{
    glm::dvec3 first = triangles[0][0], last = first;
    for (const Voxels::Triangle &t : triangles)
        for (const glm::dvec3 p : t) first = glm::min(first, p), last = glm::max(last, p);
    return std::max({last.x - first.x, last.y - first.y, last.z - first.z});
}

// [palette] of an influence: how far what follows a joint sways, or so much of the size where there are no clips.
std::vector<double> costs_of_influences(const model::Model &model, const std::vector<const model::Part *> &source,
                                        const ShellWish &wish, double size)
{
    const std::vector<std::vector<glm::vec3>> rest = at_rest(model.rig, source);
    std::vector<Piece> pieces;
    for (size_t i = 0; i < source.size(); ++i) pieces.push_back({source[i], &rest[i]});
    std::vector<double> costs = sways_of(model, pieces);
    for (double &cost : costs) cost = sway_cost * cost + least_cost * size;
    costs.resize(model.rig.palette.size(), wish.influence * size);
    return costs;
}

// By planes as far as limbs are many triangles each, then by what is seen.
std::vector<Coarse> coarse_levels(const Boundary &surface, const std::vector<Attributes> &features,
                                  const std::vector<size_t> &targets, const base::Jobs &jobs)
{
    const auto few = std::find_if(targets.begin(), targets.end(), [](size_t n) { return n <= most_reduced; });
    std::vector<size_t> many(targets.begin(), few);
    const auto simple_at = std::find_if(many.begin(), many.end(), [](size_t n) { return n < simple; }) - many.begin();
    if (few != targets.end()) {
        many.insert(many.begin() + simple_at, simple);
        many.push_back(*few * 3 / 2);
    }
    std::vector<Coarse> levels = coarsened(surface, features, many);
    if (few == targets.end()) return levels;
    // What is fine enough to reduce by; its vertices are the samples.
    const Coarse stand_in = std::move(levels[size_t(simple_at)]), from = std::move(levels.back());
    levels.erase(levels.begin() + simple_at), levels.pop_back();
    std::vector<Attributes> means;
    for (const Features &one : stand_in.features) means.push_back(one.mean);
    const FineSurface fine(stand_in.surface, means, means.size());
    for (Coarse &level : reduced(fine, from, {few, targets.end()}, jobs)) levels.push_back(std::move(level));
    return levels;
}

}  // namespace

std::vector<model::Part> shells_of(const model::Model &model, const std::vector<const model::Part *> &source,
                                   const ShellWish &wish)
{
    PosedParts posed(source);
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(model.rig, palette, workspace.weights());
    std::vector<Voxels::Triangle> triangles;
    for (const PosedParts::Triangle &t : posed.triangles()) triangles.push_back(posed.corners(t));
    const double size = size_of(triangles);
    Voxels voxels(triangles, wish.cells);
    voxels.fill();
    Boundary surface = boundary_of(voxels);
    const NearestPoint nearest(std::move(triangles));

    const std::vector<double> costs = costs_of_influences(model, source, wish, size);
    std::vector<Attributes> features;
    for (glm::dvec3 &p : surface.positions) {
        const NearestPoint::Found found = nearest.to(p);
        const Place place = {found.triangle, found.weights};
        features.push_back(features_at(model, posed, place, costs, wish.zone * size));
        p = drawn_in(p, where(posed, place), voxels.cell());
    }
    std::vector<model::Part> parts;
    for (const Coarse &coarse : coarse_levels(surface, features, wish.targets, wish.jobs))
        parts.push_back(part_of(model.name, coarse, costs, palette));
    return parts;
}

}  // namespace claque::lod
