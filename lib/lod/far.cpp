#include "lib/lod/far.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "lib/lod/decimate.h"
#include "lib/lod/far_image.h"
#include "lib/lod/samples.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

// All parts as one, without what would make seams.
struct Merged {
    model::Part part;
    std::vector<glm::vec3> rest;
    std::vector<Attributes> zones;  // [vertices] how much of the surface round it shows which zone
    double size = 0;
};

void append(const model::Part &from, const std::vector<glm::vec3> &rest, uint32_t influences, Merged &to)
{
    const uint32_t first = static_cast<uint32_t>(to.rest.size());
    to.rest.insert(to.rest.end(), rest.begin(), rest.end());
    model::Part &part = to.part;
    part.positions.insert(part.positions.end(), from.positions.begin(), from.positions.end());
    for (size_t v = 0; v < from.positions.size(); ++v) {
        part.normals.push_back(from.normals.empty() ? glm::vec3(0) : from.normals[v]);
        for (uint32_t k = 0; k < influences; ++k) {
            const bool has = k < from.influence_count;
            part.joints.push_back(has ? from.joints[v * from.influence_count + k] : 0);
            part.weights.push_back(has ? from.weights[v * from.influence_count + k] : 0);
        }
    }
    for (const auto &t : model::triangles_of(from))
        for (const uint32_t v : t) part.indices.push_back(first + v);
}

// Normals where a part has none: of the triangles round a vertex.
void fill_normals(model::Part &part)
{
    std::vector<glm::vec3> sums(part.positions.size(), glm::vec3(0));
    for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        const uint32_t *t = part.indices.data() + i;
        const glm::vec3 n =
            glm::cross(part.positions[t[1]] - part.positions[t[0]], part.positions[t[2]] - part.positions[t[0]]);
        for (size_t k = 0; k < 3; ++k) sums[t[k]] += n;
    }
    for (size_t v = 0; v < part.normals.size(); ++v) {
        if (part.normals[v] != glm::vec3(0)) continue;
        const float length = glm::length(sums[v]);
        part.normals[v] = length > 0 ? sums[v] / length : glm::vec3(0, 1, 0);
    }
}

void find_zones(const model::Model &model, const PosedParts &posed, double cost, Merged &merged)
{
    std::vector<std::map<uint32_t, double>> shares(merged.rest.size());
    for (uint32_t t = 0; t < posed.triangles().size(); ++t) {
        const double area = area_of(posed, t);
        // Not at the corners themselves, where a texel's rounding decides.
        for (size_t k = 0; k < 3; ++k) {
            glm::dvec3 weights(0.2);
            weights[static_cast<int>(k)] = 0.6;
            shares[merged.part.indices[3 * size_t(t) + k]][zone_at(model, posed, {t, weights})] += area;
        }
    }
    // Corners at one place are one vertex once they are welded.
    std::map<std::array<float, 3>, std::map<uint32_t, double>> places;
    const auto place = [&](size_t v) {
        return std::array<float, 3>{merged.rest[v].x, merged.rest[v].y, merged.rest[v].z};
    };
    for (size_t v = 0; v < shares.size(); ++v)
        for (const auto &[zone, area] : shares[v]) places[place(v)][zone] += area;
    merged.zones.resize(shares.size());
    for (size_t v = 0; v < shares.size(); ++v) {
        const std::map<uint32_t, double> &here = places[place(v)];
        const double all =
            std::accumulate(here.begin(), here.end(), 0.0, [](double sum, const auto &s) { return sum + s.second; });
        for (const auto &[zone, area] : here)
            if (all > 0 && zone != model::none) merged.zones[v].push_back({first_extra + zone, cost * area / all});
    }
}

// The triangles of connected shells, the largest shell first.
std::vector<std::vector<uint32_t>> shells_of(const Merged &merged)
{
    std::map<std::array<float, 3>, uint32_t> places;
    std::vector<uint32_t> shell, at(merged.rest.size());
    for (size_t v = 0; v < merged.rest.size(); ++v) {
        const glm::vec3 p = merged.rest[v];
        at[v] = places.try_emplace({p.x, p.y, p.z}, static_cast<uint32_t>(places.size())).first->second;
    }
    shell.resize(places.size());
    std::iota(shell.begin(), shell.end(), 0u);
    const auto root = [&](uint32_t i) {
        while (shell[i] != i) i = shell[i] = shell[shell[i]];
        return i;
    };
    const std::vector<uint32_t> &indices = merged.part.indices;
    for (size_t i = 0; i + 2 < indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k) shell[root(at[indices[i + k]])] = root(at[indices[i]]);
    std::map<uint32_t, std::pair<double, std::vector<uint32_t>>> found;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        auto &[area, triangles] = found[root(at[indices[i]])];
        const glm::vec3 *p = merged.rest.data();
        area += double(glm::length(glm::cross(p[indices[i + 1]] - p[indices[i]], p[indices[i + 2]] - p[indices[i]])));
        triangles.insert(triangles.end(), indices.begin() + std::ptrdiff_t(i), indices.begin() + std::ptrdiff_t(i) + 3);
    }
    std::vector<std::pair<double, std::vector<uint32_t>>> sorted;
    for (auto &[id, one] : found) sorted.push_back(std::move(one));
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto &a, const auto &b) { return a.first > b.first; });
    std::vector<std::vector<uint32_t>> out;
    for (auto &one : sorted) out.push_back(std::move(one.second));
    return out;
}

Merged merged_of(const model::Model &model, const std::vector<const model::Part *> &source, double zone_cost)
{
    Merged merged;
    merged.part.name = model.name;
    merged.part.skinned = true;
    for (const model::Part *part : source)
        merged.part.influence_count = std::max(merged.part.influence_count, part->influence_count);
    const std::vector<std::vector<glm::vec3>> rest = at_rest(model.rig, source);
    for (size_t i = 0; i < source.size(); ++i) append(*source[i], rest[i], merged.part.influence_count, merged);
    fill_normals(merged.part);
    glm::vec3 first = merged.rest[0], last = first;
    for (const glm::vec3 p : merged.rest) first = glm::min(first, p), last = glm::max(last, p);
    merged.size = double(std::max({last.x - first.x, last.y - first.y, last.z - first.z}));
    PosedParts posed(source);
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(model.rig, palette, workspace.weights());
    find_zones(model, posed, zone_cost * merged.size, merged);
    return merged;
}

// To the target, giving up the smallest shells where their last triangles stand in the way.
Decimated reduced(const Merged &merged, size_t target, double influence)
{
    std::vector<std::vector<uint32_t>> shells = shells_of(merged);
    while (true) {
        model::Part part = merged.part;
        part.indices.clear();
        for (const auto &shell : shells) part.indices.insert(part.indices.end(), shell.begin(), shell.end());
        Decimated made = std::move(decimate({{&part, &merged.rest, &merged.zones}}, {{target}, 75, influence, 0})[0]);
        if (made.triangles <= target || shells.size() == 1) return made;
        const size_t beyond = std::max<size_t>(1, (made.triangles - target) / 8);
        shells.resize(shells.size() > beyond ? shells.size() - beyond : 1);
    }
}

}  // namespace

FarLevels make_far(const model::Model &model, const std::vector<const model::Part *> &source, const FarWish &wish)
{
    const Merged merged = merged_of(model, source, wish.zone);
    std::vector<model::Part> parts;
    for (const size_t target : wish.targets)
        parts.push_back(std::move(reduced(merged, target, wish.influence).parts[0]));
    return painted(model, source, std::move(parts));
}

}  // namespace claque::lod
