#include "lib/lod/coarsen.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "lib/lod/surface.h"

namespace claque::lod
{

namespace
{

// Squared distance of two means, and the mean of both.
double apart(const Attributes &a, const Attributes &b)
{
    double sum = 0;
    for (size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        const bool left = j == b.size() || (i < a.size() && a[i].id <= b[j].id);
        const bool right = i == a.size() || (j < b.size() && b[j].id <= a[i].id);
        const double difference = (left ? a[i].value : 0) - (right ? b[j].value : 0);
        sum += difference * difference;
        i += left, j += right;
    }
    return sum;
}

Features joined(const Features &a, const Features &b)
{
    Features out;
    out.area = a.area + b.area;
    const double of_a = out.area > 0 ? a.area / out.area : 0.5, of_b = 1 - of_a;
    for (size_t i = 0, j = 0; i < a.mean.size() || j < b.mean.size();) {
        const bool left = j == b.mean.size() || (i < a.mean.size() && a.mean[i].id <= b.mean[j].id);
        const bool right = i == a.mean.size() || (j < b.mean.size() && b.mean[j].id <= a.mean[i].id);
        out.mean.push_back({left ? a.mean[i].id : b.mean[j].id,
                            (left ? of_a * a.mean[i].value : 0) + (right ? of_b * b.mean[j].value : 0)});
        i += left, j += right;
    }
    return out;
}

class Coarsening
{
public:
    Coarsening(const Boundary &surface, const std::vector<Attributes> &features);
    void run(size_t target);
    Coarse result() const;

private:
    struct Wish {
        double cost = 0;
        int from = 0, to = 0;
        uint32_t from_age = 0, to_age = 0;
        bool operator<(const Wish &o) const  // the queue's top is the largest: the cheapest, then the first
        {
            if (cost != o.cost) return cost > o.cost;
            return from != o.from ? from > o.from : to > o.to;
        }
    };
    void wish(Mesh::HalfedgeHandle h);
    glm::dvec3 best_place(int a, int b) const;
    double cost(int a, int b, glm::dvec3 at) const;
    bool turns(Mesh::VertexHandle moved, Mesh::VertexHandle other, glm::dvec3 at) const;
    void collapse(Mesh::HalfedgeHandle h, glm::dvec3 at);

    Mesh mesh_;
    size_t faces_ = 0;
    double sliver_ = 0;  // area
    std::vector<PlaneQuadric> planes_;
    std::vector<Features> features_;
    std::vector<uint32_t> ages_;
    std::priority_queue<Wish> queue_;
};

Coarsening::Coarsening(const Boundary &surface, const std::vector<Attributes> &features)
{
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
    for (size_t v = 0; v < surface.positions.size(); ++v) {
        const glm::dvec3 p = surface.positions[v];
        mesh_.add_vertex({p.x, p.y, p.z});
        features_.push_back({0, features[v]});
    }
    planes_.resize(surface.positions.size());
    ages_.resize(surface.positions.size(), 0);
    for (const auto &t : surface.triangles) {
        const auto handle = [](uint32_t v) { return Mesh::VertexHandle(static_cast<int>(v)); };
        if (!mesh_.add_face(handle(t[0]), handle(t[1]), handle(t[2])).is_valid()) continue;
        ++faces_;
        const TriangleFrame frame(surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]);
        for (const uint32_t v : t) {
            features_[v].area += frame.area / 3;
            if (frame.area > 0) planes_[v].add_plane(frame.normal, frame.origin, frame.area);
        }
    }
    double all = 0;
    for (const Features &one : features_) all += one.area;
    if (faces_ > 0) sliver_ = 0.05 * all / double(faces_);
    for (const auto edge : mesh_.edges()) wish(mesh_.halfedge_handle(edge, 0));
}

glm::dvec3 Coarsening::best_place(int a, int b) const
{
    PlaneQuadric sum = planes_[size_t(a)];
    sum += planes_[size_t(b)];
    const glm::dvec3 p = point(mesh_, Mesh::VertexHandle(a)), q = point(mesh_, Mesh::VertexHandle(b));
    const glm::dvec3 middle = 0.5 * (p + q);
    glm::dvec3 best = middle;
    // Not far from the edge: flat regions have no best place along themselves.
    const double reach = 2 * glm::length(q - p);
    glm::dvec3 found;
    if (sum.lowest(middle, found) && glm::length(found - middle) <= reach) best = found;
    for (const glm::dvec3 other : {p, q, middle})
        if (sum.at(other) < sum.at(best)) best = other;
    return best;
}

double Coarsening::cost(int a, int b, glm::dvec3 at) const
{
    const Features &fa = features_[size_t(a)], &fb = features_[size_t(b)];
    const double areas = fa.area + fb.area;
    const double variance = areas > 0 ? fa.area * fb.area / areas * apart(fa.mean, fb.mean) : 0;
    return std::max(planes_[size_t(a)].at(at) + planes_[size_t(b)].at(at), 0.0) + variance;
}

void Coarsening::wish(Mesh::HalfedgeHandle h)
{
    const int a = mesh_.from_vertex_handle(h).idx(), b = mesh_.to_vertex_handle(h).idx();
    const int from = std::min(a, b), to = std::max(a, b);
    queue_.push({cost(from, to, best_place(from, to)), from, to, ages_[size_t(from)], ages_[size_t(to)]});
}

// Whether a triangle of `moved` that stays would turn away when it goes to `at`.
bool Coarsening::turns(Mesh::VertexHandle moved, Mesh::VertexHandle other, glm::dvec3 at) const
{
    for (auto f = mesh_.cvf_iter(moved); f.is_valid(); ++f) {
        std::array<glm::dvec3, 3> before, after;
        size_t k = 0;
        bool goes = false;
        for (auto v = mesh_.cfv_iter(*f); v.is_valid() && k < 3; ++v, ++k) {
            goes = goes || *v == other;
            before[k] = point(mesh_, *v);
            after[k] = *v == moved ? at : before[k];
        }
        if (goes) continue;
        const TriangleFrame was(before[0], before[1], before[2]), is(after[0], after[1], after[2]);
        // Slivers point anywhere.
        if (was.area < sliver_ || is.area < sliver_) continue;
        if (glm::dot(was.normal, is.normal) < 0.2) return true;
    }
    return false;
}

void Coarsening::collapse(Mesh::HalfedgeHandle h, glm::dvec3 at)
{
    const Mesh::VertexHandle from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
    faces_ -= 2;
    planes_[size_t(to.idx())] += planes_[size_t(from.idx())];
    features_[size_t(to.idx())] = joined(features_[size_t(from.idx())], features_[size_t(to.idx())]);
    mesh_.collapse(h);
    mesh_.set_point(to, {at.x, at.y, at.z});
    ++ages_[size_t(to.idx())];
    for (auto out = mesh_.cvoh_iter(to); out.is_valid(); ++out) wish(*out);
}

void Coarsening::run(size_t target)
{
    std::vector<Wish> refused;  // what is not lawful now may be later, when more round it has gone
    while (faces_ > target && !queue_.empty()) {
        const Wish next = queue_.top();
        queue_.pop();
        const Mesh::VertexHandle from(next.from), to(next.to);
        if (mesh_.status(from).deleted() || mesh_.status(to).deleted()) continue;
        if (ages_[size_t(next.from)] != next.from_age || ages_[size_t(next.to)] != next.to_age) continue;
        const Mesh::HalfedgeHandle h = mesh_.find_halfedge(from, to);
        if (!h.is_valid()) continue;
        const glm::dvec3 at = best_place(next.from, next.to);
        if (!mesh_.is_collapse_ok(h) || turns(from, to, at) || turns(to, from, at)) {
            refused.push_back(next);
            continue;
        }
        collapse(h, at);
        // All of them would be asked again after every step otherwise.
        if (queue_.empty() || refused.size() > 256 + faces_) {
            for (const Wish &again : refused) queue_.push(again);
            refused.clear();
        }
    }
    for (const Wish &again : refused) queue_.push(again);
}

Coarse Coarsening::result() const
{
    Coarse out;
    std::vector<uint32_t> number(mesh_.n_vertices(), model::none);
    for (const Mesh::FaceHandle face : mesh_.all_faces()) {
        if (mesh_.status(face).deleted()) continue;
        std::array<uint32_t, 3> t{};
        size_t k = 0;
        for (auto v = mesh_.cfv_iter(face); v.is_valid() && k < 3; ++v, ++k) {
            uint32_t &n = number[size_t(v->idx())];
            if (n == model::none) {
                n = static_cast<uint32_t>(out.surface.positions.size());
                out.surface.positions.push_back(point(mesh_, *v));
                out.features.push_back(features_[size_t(v->idx())]);
            }
            t[k] = n;
        }
        out.surface.triangles.push_back(t);
    }
    return out;
}

// Without the small pieces.
Boundary large_pieces_of(const Boundary &surface)
{
    std::vector<uint32_t> piece(surface.positions.size());
    std::iota(piece.begin(), piece.end(), 0u);
    const auto root = [&](uint32_t i) {
        while (piece[i] != i) i = piece[i] = piece[piece[i]];
        return i;
    };
    for (const auto &t : surface.triangles)
        for (size_t k = 1; k < 3; ++k) piece[root(t[k])] = root(t[0]);
    std::vector<double> areas(surface.positions.size(), 0);
    double all = 0;
    for (const auto &t : surface.triangles) {
        const double area =
            TriangleFrame(surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]).area;
        areas[root(t[0])] += area;
        all += area;
    }
    Boundary out;
    out.positions = surface.positions;
    const double most = *std::max_element(areas.begin(), areas.end());
    for (const auto &t : surface.triangles)
        if (areas[root(t[0])] >= std::min(most, all / 50)) out.triangles.push_back(t);
    return out;
}

}  // namespace

std::vector<Coarse> coarsened(const Boundary &surface, const std::vector<Attributes> &features,
                              const std::vector<size_t> &targets)
{
    Coarsening work(large_pieces_of(surface), features);
    std::vector<Coarse> out;
    for (const size_t target : targets) {
        work.run(target);
        out.push_back(work.result());
    }
    return out;
}

}  // namespace claque::lod
