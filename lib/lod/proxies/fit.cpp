#include "lib/lod/proxies/fit.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/model/model.h"

namespace claque::lod
{

namespace
{

constexpr double hold = 0.02;      // weight that holds vertices at their position, against that of the samples
constexpr double max_lines = 12;   // limit of the sampling lines on a triangle
constexpr double min_gain = 0.01;  // of the squared distance: iteration stops if it gains less

// Least squares for positions that are weighted sums of n unknowns, solved by Cholesky factorisation.
class NormalEquations
{
public:
    explicit NormalEquations(size_t n) : n_(n), a_(n * n, 0) {}

    void add(const std::array<uint32_t, 3> &at, glm::dvec3 weights, double area)
    {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) a_[at[size_t(i)] * n_ + at[size_t(j)]] += area * weights[i] * weights[j];
    }
    void hold(size_t i, double weight) { a_[i * n_ + i] += weight; }
    void factor()
    {
        for (size_t j = 0; j < n_; ++j) {
            for (size_t k = 0; k < j; ++k) a_[j * n_ + j] -= a_[j * n_ + k] * a_[j * n_ + k];
            a_[j * n_ + j] = std::sqrt(a_[j * n_ + j]);
            for (size_t i = j + 1; i < n_; ++i) {
                for (size_t k = 0; k < j; ++k) a_[i * n_ + j] -= a_[i * n_ + k] * a_[j * n_ + k];
                a_[i * n_ + j] /= a_[j * n_ + j];
            }
        }
    }
    void solve(std::vector<glm::dvec3> &b) const
    {
        for (size_t i = 0; i < n_; ++i) {
            for (size_t k = 0; k < i; ++k) b[i] -= a_[i * n_ + k] * b[k];
            b[i] /= a_[i * n_ + i];
        }
        for (size_t i = n_; i-- > 0;) {
            for (size_t k = i + 1; k < n_; ++k) b[i] -= a_[k * n_ + i] * b[k];
            b[i] /= a_[i * n_ + i];
        }
    }

private:
    size_t n_;
    std::vector<double> a_;
};

bool any_flips(const ClosedMesh &was, const std::vector<glm::dvec3> &positions, double sliver)
{
    for (const auto &t : was.triangles) {
        const glm::dvec3 before = twice_area({was.positions[t[0]], was.positions[t[1]], was.positions[t[2]]});
        const glm::dvec3 after = twice_area({positions[t[0]], positions[t[1]], positions[t[2]]});
        if (glm::length(before) < sliver) continue;
        if (glm::dot(before, after) < 0.2 * glm::length(before) * glm::length(after)) return true;
    }
    return false;
}

struct Correspondence {  // a point of the coarse surface and its target
    std::array<uint32_t, 3> vertices{};
    glm::dvec3 weights = glm::dvec3(0);
    glm::dvec3 target = glm::dvec3(0);
    double area = 0;
    const Attributes *features = nullptr;  // null for samples of the coarse surface itself
};

// Returns the correspondences of the fine surface's samples and of about as many samples of the coarse surface for its
// area.
std::vector<Correspondence> correspondences_of(const FineSurface &fine, const ClosedMesh &coarse)
{
    const std::vector<NearestPoint::Triangle> triangles = corners_of(coarse);
    const NearestPoint nearest(triangles);
    std::vector<Correspondence> out;
    uint32_t guess = model::none;
    for (const FineSurface::Sample &sample : fine.samples()) {
        const NearestPoint::Found found = nearest.to(sample.at, guess);
        guess = found.triangle;
        out.push_back({coarse.triangles[found.triangle], found.weights, sample.at, sample.area, sample.features});
    }
    const double each = fine.area() / double(fine.samples().size());
    guess = model::none;
    for (size_t t = 0; t < triangles.size(); ++t) {
        const double area = 0.5 * glm::length(twice_area(triangles[t]));
        const double n = std::clamp(std::ceil(std::sqrt(area / each)), 1.0, max_lines);
        for (double i = 0; i < n; ++i)
            for (double j = 0; i + j < n; ++j)
                for (const double third : {1.0, 2.0}) {
                    if (third == 2 && i + j + 2 > n) continue;
                    const double b = (i + third / 3) / n, c = (j + third / 3) / n;
                    const glm::dvec3 weights(1 - b - c, b, c);
                    out.push_back({coarse.triangles[t], weights, fine.nearest(point_on(triangles[t], weights), guess),
                                   area / (n * n), nullptr});
                }
    }
    return out;
}

double sum_of(const std::vector<Correspondence> &links, const ClosedMesh &coarse)
{
    double sum = 0;
    for (const Correspondence &link : links) {
        const auto &v = link.vertices;
        const glm::dvec3 at =
            point_on({coarse.positions[v[0]], coarse.positions[v[1]], coarse.positions[v[2]]}, link.weights);
        sum += link.area * glm::dot(at - link.target, at - link.target);
    }
    return sum;
}

std::vector<glm::dvec3> solve_positions(const FineSurface &fine, const std::vector<Correspondence> &links,
                                        const ClosedMesh &coarse)
{
    const size_t n = coarse.positions.size();
    const double held = hold * fine.area() / double(n);
    NormalEquations normal(n);
    std::vector<glm::dvec3> positions(n);
    for (const Correspondence &link : links) {
        normal.add(link.vertices, link.weights, link.area);
        for (int k = 0; k < 3; ++k) positions[link.vertices[size_t(k)]] += link.area * link.weights[k] * link.target;
    }
    for (size_t v = 0; v < n; ++v) normal.hold(v, held), positions[v] += held * coarse.positions[v];
    normal.factor();
    normal.solve(positions);
    return positions;
}

// Sets the features of each vertex to the mean of the samples nearest to it, by their weights.
void update_features(const std::vector<Correspondence> &links, CoarseMesh &coarse)
{
    std::vector<Features> sums(coarse.features.size());
    for (const Correspondence &link : links)
        for (int k = 0; k < 3 && link.features; ++k) {
            Features &sum = sums[link.vertices[size_t(k)]];
            if (link.weights[k] > 0) sum = merged(sum, {link.area * link.weights[k], *link.features});
        }
    for (size_t v = 0; v < sums.size(); ++v)
        if (sums[v].area > 0) coarse.features[v] = std::move(sums[v]);
}

}  // namespace

void fit(const FineSurface &fine, CoarseMesh &coarse, int rounds)
{
    ClosedMesh &surface = coarse.surface;
    if (surface.triangles.empty() || fine.samples().empty()) return;
    const double sliver = 0.05 * fine.area() / double(surface.triangles.size());
    std::vector<Correspondence> links = correspondences_of(fine, surface);
    double sum = sum_of(links, surface);
    for (int round = 0; round < rounds; ++round) {
        const std::vector<glm::dvec3> target = solve_positions(fine, links, surface);
        const double before = sum;
        for (double step = 1; step > 0.1 && sum == before; step *= 0.5) {
            ClosedMesh next = surface;
            for (size_t v = 0; v < target.size(); ++v) next.positions[v] += step * (target[v] - surface.positions[v]);
            if (any_flips(surface, next.positions, sliver)) continue;
            std::vector<Correspondence> then = correspondences_of(fine, next);
            const double sum_then = sum_of(then, next);
            if (sum_then < sum) surface = std::move(next), links = std::move(then), sum = sum_then;
        }
        if (before - sum < min_gain * before) break;
    }
    update_features(links, coarse);
}

}  // namespace claque::lod
