#include "lib/lod/proxies/non_manifold_collapse.h"

#include <algorithm>

#include "lib/lod/proxies/vertex_merge.h"
#include "lib/model/model.h"

namespace claque::lod
{

namespace
{

// Rotates the smallest corner to the front and keeps the orientation.
Triangle turned(Triangle t)
{
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

// The opposite triangle of one that begins with its smallest corner.
Triangle behind(const Triangle &t) { return {t[0], t[2], t[1]}; }

}  // namespace

NonManifoldCollapse::NonManifoldCollapse(CoarseMesh level, std::vector<PlaneQuadric> planes, double sliver)
    : level_(std::move(level)), planes_(std::move(planes)), sliver_(sliver)
{
}

std::vector<std::vector<uint32_t>> NonManifoldCollapse::triangles_of_vertices() const
{
    std::vector<std::vector<uint32_t>> round(level_.surface.positions.size());
    for (uint32_t t = 0; t < level_.surface.triangles.size(); ++t)
        for (const uint32_t v : level_.surface.triangles[t]) round[v].push_back(t);
    return round;
}

NonManifoldCollapse::Step NonManifoldCollapse::step(uint32_t a, uint32_t b,
                                                    const std::vector<std::vector<uint32_t>> &round) const
{
    const std::vector<glm::dvec3> &positions = level_.surface.positions;
    PlaneQuadric both = planes_[a];
    both += planes_[b];
    Step step;
    step.from = a, step.to = b, step.at = optimal_position(both, positions[a], positions[b]);
    step.cost = std::max(both.at(step.at), 0.0) + variance_of(level_.features[a], level_.features[b]);
    std::vector<Triangle> after;
    for (const uint32_t moved : {a, b})
        for (const uint32_t index : round[moved]) {
            Triangle t = level_.surface.triangles[index];
            if (has(t, a) && has(t, b)) continue;
            const TriangleFrame was(positions[t[0]], positions[t[1]], positions[t[2]]);
            std::array<glm::dvec3, 3> p;
            for (size_t k = 0; k < 3; ++k) p[k] = t[k] == moved ? step.at : positions[t[k]];
            step.flips = step.flips || flips(was, TriangleFrame(p[0], p[1], p[2]), sliver_);
            for (uint32_t &v : t)
                if (v == a) v = b;
            after.push_back(turned(t));
        }
    // Opposite triangles cancel out. That is cheap if they are the walls of a hole, and expensive if they are a sheet.
    double lost = 0;
    for (const Triangle &t : after) {
        if (std::find(after.begin(), after.end(), behind(t)) == after.end()) continue;
        std::array<glm::dvec3, 3> p;
        for (size_t k = 0; k < 3; ++k) p[k] = t[k] == b ? step.at : positions[t[k]];
        lost += TriangleFrame(p[0], p[1], p[2]).area;
    }
    step.cost += lost * lost;
    return step;
}

void NonManifoldCollapse::apply(const Step &step)
{
    planes_[step.to] += planes_[step.from];
    level_.features[step.to] = merged(level_.features[step.from], level_.features[step.to]);
    level_.surface.positions[step.to] = step.at;
    level_.surface.triangles = merge_vertices(step.to, step.from, level_.surface.triangles);
}

void NonManifoldCollapse::run(size_t target)
{
    while (level_.surface.triangles.size() > std::max<size_t>(target, 4)) {
        const std::vector<std::vector<uint32_t>> round = triangles_of_vertices();
        Step best;
        for (const Triangle &t : level_.surface.triangles)
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t a = t[k], b = t[(k + 1) % 3];
                if (a > b) continue;  // the triangle on the other side of the edge has it reversed
                const Step next = step(a, b, round);
                if (best.from == best.to || next < best) best = next;
            }
        const CoarseMesh before = level_;
        apply(best);
        if (level_.surface.triangles.empty()) {
            level_ = before;
            return;
        }
    }
}

CoarseMesh NonManifoldCollapse::result() const
{
    CoarseMesh out;
    std::vector<uint32_t> number(level_.surface.positions.size(), model::none);
    for (Triangle t : level_.surface.triangles) {
        for (uint32_t &v : t) {
            uint32_t &n = number[v];
            if (n == model::none) {
                n = static_cast<uint32_t>(out.surface.positions.size());
                out.surface.positions.push_back(level_.surface.positions[v]);
                out.features.push_back(level_.features[v]);
            }
            v = n;
        }
        out.surface.triangles.push_back(t);
    }
    return out;
}

}  // namespace claque::lod
