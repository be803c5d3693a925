#include "lib/lod/proxies/reduce.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "lib/lod/proxies/fit.h"
#include "lib/lod/proxies/vertex_merge.h"
#include "lib/model/model.h"

namespace claque::lod
{

namespace
{

constexpr size_t min_manifold_triangles = 30;  // levels of fewer triangles may close holes as soon as that is cheapest
constexpr size_t refit_triangles = 40;         // levels of at most so many triangles are fitted after each collapse
// Where the mesh under reduction is fitted, whatever the targets: no level depends on which others are made.
constexpr size_t fitted_at[] = {120, 60, 42, 30, 20, 14};
constexpr double illegal_cost = std::numeric_limits<double>::infinity();

class Reduction
{
public:
    Reduction(const FineSurface &fine, const CoarseMesh &from, const base::Jobs &jobs) : fine_(fine), jobs_(jobs)
    {
        begin(from);
    }

    // Returns false if no collapse without a flip is left.
    bool collapse()
    {
        if (collapse_next()) return true;
        if (non_manifold_allowed_) return false;
        allow_non_manifold();
        return collapse_next();
    }
    // Allows edges with four triangles from here on, where holes close.
    void allow_non_manifold()
    {
        if (!non_manifold_allowed_) collapses_.clear();
        non_manifold_allowed_ = true;
    }
    void refit(int rounds)
    {
        CoarseMesh now = result();
        fit(fine_, now, rounds);
        begin(now);
    }
    size_t count() const { return level_.surface.triangles.size(); }
    CoarseMesh result() const { return without_unused_vertices(level_); }

private:
    struct Collapse {
        double cost = illegal_cost;
        glm::dvec3 at = glm::dvec3(0);
    };
    struct Star {  // the neighbourhood of an edge
        std::vector<Triangle> before, after;
        std::vector<uint32_t> samples;
        double now = 0;  // the present cost of its triangles and samples
        mutable uint32_t guess = model::none;
    };

    bool collapse_next()
    {
        std::vector<std::pair<Edge, Collapse *>> fresh;
        for (const Triangle &t : level_.surface.triangles)
            for (size_t k = 0; k < 3; ++k)
                if (const auto [at, is_new] = collapses_.try_emplace(edge_of(t, k)); is_new)
                    fresh.emplace_back(at->first, &at->second);
        jobs_.try_each(static_cast<uint32_t>(fresh.size()),
                       [&](uint32_t i) { *fresh[i].second = best_collapse(fresh[i].first); });
        const auto best = std::min_element(collapses_.begin(), collapses_.end(),
                                           [](const auto &x, const auto &y) { return x.second.cost < y.second.cost; });
        if (best == collapses_.end() || best->second.cost == illegal_cost) return false;
        apply(best->first, best->second.at);
        return true;
    }
    void begin(const CoarseMesh &from)
    {
        level_ = from;
        collapses_.clear(), distance_costs_.clear(), nearest_triangles_.clear(), distances_.clear();
        uint32_t guess = model::none;
        for (const NearestPoint::Triangle &t : corners_of(level_.surface))
            distance_costs_.push_back(distance_cost(t, guess));
        sliver_ = 0.05 * fine_.area() / double(count());
        const NearestPoint nearest(corners_of(level_.surface));
        for (const FineSurface::Sample &sample : fine_.samples()) {
            const NearestPoint::Found found = nearest.to(sample.at);
            nearest_triangles_.push_back(found.triangle), distances_.push_back(found.distance_squared);
        }
    }
    glm::dvec3 at(uint32_t v) const { return level_.surface.positions[v]; }

    // Returns the squared distance of a triangle from the fine surface, times its area. `guess`: the nearest triangle
    // of the last query.
    double distance_cost(const NearestPoint::Triangle &t, uint32_t &guess) const
    {
        double sum = 0;
        for (const glm::dvec3 weights : {glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(4, 1, 1) / 6.0,
                                         glm::dvec3(1, 4, 1) / 6.0, glm::dvec3(1, 1, 4) / 6.0}) {
            const glm::dvec3 p = point_on(t, weights), off = p - fine_.nearest(p, guess);
            sum += glm::dot(off, off) / 4;
        }
        return 0.5 * glm::length(twice_area(t)) * sum;
    }
    Star star_of(Edge edge) const
    {
        Star star;
        std::vector<bool> in(count());
        for (uint32_t t = 0; t < count(); ++t) {
            const Triangle &triangle = level_.surface.triangles[t];
            in[t] = has(triangle, edge.first) || has(triangle, edge.second);
            if (in[t]) star.before.push_back(triangle), star.now += distance_costs_[t];
        }
        star.after = merge_vertices(edge.first, edge.second, star.before);
        for (uint32_t s = 0; s < nearest_triangles_.size(); ++s) {
            if (!in[nearest_triangles_[s]]) continue;
            star.samples.push_back(s);
            star.now += fine_.samples()[s].area * distances_[s];
        }
        return star;
    }

    // Returns whether the collapse would cut off a limb: the edge is part of a ring round a neck.
    bool disconnects(Edge edge, const Star &star) const
    {
        if (star.after.size() + 2 == star.before.size() && common_neighbours(star, edge) == 2) return false;
        if (!non_manifold_allowed_) return true;
        const std::vector<Triangle> &all = level_.surface.triangles;
        return component_count(merge_vertices(edge.first, edge.second, all)) > component_count(all);
    }
    static size_t common_neighbours(const Star &star, Edge edge)
    {
        std::set<uint32_t> of_first, of_second;
        for (const Triangle &t : star.before) {
            if (has(t, edge.first)) of_first.insert(t.begin(), t.end());
            if (has(t, edge.second)) of_second.insert(t.begin(), t.end());
        }
        size_t both = 0;
        for (const uint32_t v : of_first) both += v != edge.first && v != edge.second && of_second.count(v);
        return both;
    }
    Collapse best_collapse(Edge edge) const
    {
        const Star star = star_of(edge);
        Collapse best;
        const auto try_position = [&](glm::dvec3 position) {
            const double cost = cost_of(edge, position, star, best.cost + star.now) - star.now;
            const bool better = cost < best.cost;
            if (better) best = {cost, position};
            return better;
        };
        if (star.after.empty() || disconnects(edge, star)) return best;
        for (const double of_b : {0.5, 0.0, 1.0})
            if (try_position((1 - of_b) * at(edge.first) + of_b * at(edge.second))) break;
        for (int round = 0; round < 2 && best.cost < illegal_cost; ++round)
            if (!try_position(least_squares_position(edge, best.at, star))) break;
        best.cost += variance_of(level_.features[edge.first], level_.features[edge.second]);
        return best;
    }

    // The corners with both ends of the edge at `position`.
    NearestPoint::Triangle corners(const Triangle &t, Edge edge, glm::dvec3 position) const
    {
        NearestPoint::Triangle out;
        for (size_t k = 0; k < 3; ++k) out[k] = t[k] == edge.first || t[k] == edge.second ? position : at(t[k]);
        return out;
    }
    FewTriangles after(const Star &star, Edge edge, glm::dvec3 position) const
    {
        std::vector<NearestPoint::Triangle> out;
        out.reserve(star.after.size());
        for (const Triangle &t : star.after) out.push_back(corners(t, edge, position));
        return FewTriangles(out);
    }
    bool flips(Edge edge, glm::dvec3 position, const Star &star) const
    {
        for (const Triangle &t : star.before) {
            if (has(t, edge.first) && has(t, edge.second)) continue;
            const glm::dvec3 was = twice_area({at(t[0]), at(t[1]), at(t[2])}),
                             is = twice_area(corners(t, edge, position));
            const double was_long = glm::length(was), is_long = glm::length(is);
            if (was_long > sliver_ && is_long > sliver_ && glm::dot(was, is) < 0.2 * was_long * is_long) return true;
        }
        return false;
    }
    double cost_of(Edge edge, glm::dvec3 position, const Star &star, double maximum) const
    {
        if (flips(edge, position, star)) return illegal_cost;
        const FewTriangles next = after(star, edge, position);
        double sum = 0;
        for (const uint32_t s : star.samples) {
            sum += fine_.samples()[s].area * next.to(fine_.samples()[s].at).distance_squared;
            if (sum >= maximum) return illegal_cost;
        }
        for (const PrecomputedTriangle &t : next.triangles()) {
            if (sum >= maximum) return illegal_cost;
            sum += distance_cost(t.corners, star.guess);
        }
        return sum;
    }

    // Returns the least-squares position of the merged vertex for the samples of its triangles.
    glm::dvec3 least_squares_position(Edge edge, glm::dvec3 position, const Star &star) const
    {
        const FewTriangles next = after(star, edge, position);
        glm::dvec3 sum(0);
        double all = 0;
        for (const uint32_t s : star.samples) {
            const FineSurface::Sample &sample = fine_.samples()[s];
            const NearestPoint::Found nearest = next.to(sample.at);
            const Triangle &t = star.after[nearest.triangle];
            int k = 0;
            while (k < 3 && t[size_t(k)] != edge.first) ++k;
            const double weight = k < 3 ? nearest.weights[k] : 0;
            const glm::dvec3 off = sample.at - point_on(next.triangles()[nearest.triangle].corners, nearest.weights);
            sum += sample.area * weight * (off + weight * position);
            all += sample.area * weight * weight;
        }
        return all > 0 ? sum / all : position;
    }

    void apply(Edge edge, glm::dvec3 position)
    {
        const Star star = star_of(edge);
        CoarseMesh next;
        next.features = level_.features;
        next.surface.positions = level_.surface.positions, next.surface.positions[edge.first] = position;
        next.features[edge.first] = merged(level_.features[edge.first], level_.features[edge.second]);
        std::set<uint32_t> touched;
        std::vector<double> back;
        std::vector<uint32_t> renamed;
        for (uint32_t t = 0; t < count(); ++t) {
            const Triangle &triangle = level_.surface.triangles[t];
            renamed.push_back(static_cast<uint32_t>(back.size()));
            if (has(triangle, edge.first) || has(triangle, edge.second)) {
                touched.insert(triangle.begin(), triangle.end());
                continue;
            }
            next.surface.triangles.push_back(triangle), back.push_back(distance_costs_[t]);
        }
        const size_t stay = back.size();
        const FewTriangles moved = after(star, edge, position);
        for (size_t i = 0; i < star.after.size(); ++i)
            next.surface.triangles.push_back(star.after[i]),
                back.push_back(distance_cost(moved.triangles()[i].corners, star.guess));
        for (uint32_t &t : nearest_triangles_) t = renamed[t];
        for (const uint32_t s : star.samples) {
            const NearestPoint::Found nearest = moved.to(fine_.samples()[s].at);
            nearest_triangles_[s] = static_cast<uint32_t>(stay + nearest.triangle),
            distances_[s] = nearest.distance_squared;
        }
        level_ = std::move(next), distance_costs_ = std::move(back);
        for (auto it = collapses_.begin(); it != collapses_.end();)
            it = touched.count(it->first.first) || touched.count(it->first.second) ? collapses_.erase(it)
                                                                                   : std::next(it);
    }

    const FineSurface &fine_;
    const base::Jobs &jobs_;
    CoarseMesh level_;
    std::vector<double> distance_costs_;       // [triangles]
    std::vector<uint32_t> nearest_triangles_;  // [samples] the nearest triangle
    std::vector<double> distances_;            // [samples] squared distance to it
    std::map<Edge, Collapse> collapses_;
    bool non_manifold_allowed_ = false;
    double sliver_ = 0;  // twice the area below which a triangle's normal is meaningless
};

}  // namespace

std::vector<CoarseMesh> reduce_by_distance(const FineSurface &fine, const CoarseMesh &from,
                                           const std::vector<size_t> &targets, const base::Jobs &jobs)
{
    Reduction work(fine, from, jobs);
    std::vector<CoarseMesh> out;
    const size_t *next = std::begin(fitted_at);
    const auto reduce_to = [&](size_t target) {
        if (target < min_manifold_triangles) work.allow_non_manifold();
        while (work.count() > target && work.collapse())
            if (work.count() <= refit_triangles) work.refit(2);
    };
    for (const size_t target : targets) {
        for (; next != std::end(fitted_at) && *next >= target; ++next) reduce_to(*next), work.refit(max_fit_rounds);
        reduce_to(target);
        CoarseMesh level = work.result();
        if (next == std::begin(fitted_at) || next[-1] != target) fit(fine, level, max_fit_rounds);
        out.push_back(std::move(level));
    }
    return out;
}

}  // namespace claque::lod
