#include "lib/lod/proxies/coarsen.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <queue>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "lib/lod/proxies/non_manifold_collapse.h"
#include "lib/lod/surface/mesh.h"
#include "lib/model/template.h"

namespace claque::lod
{

namespace
{

class Coarsening
{
public:
    Coarsening(const ClosedMesh &surface, const std::vector<Attributes> &features);
    // What it reaches does not depend on the targets before.
    void run(size_t target);
    size_t triangles() const { return faces_; }
    CoarseMesh result() const { return result(nullptr); }
    NonManifoldCollapse non_manifold() const;  // continues where no manifold collapse is left

private:
    struct Collapse {
        double cost = 0;
        int from = 0, to = 0;
        uint32_t from_age = 0, to_age = 0;
        // The top of the queue is the largest element: the cheapest collapse, then the first by index.
        bool operator<(const Collapse &o) const
        {
            if (cost != o.cost) return cost > o.cost;
            return from != o.from ? from > o.from : to > o.to;
        }
    };
    void enqueue(Mesh::HalfedgeHandle h);
    glm::dvec3 collapse_position(int a, int b) const;
    double cost(int a, int b, glm::dvec3 at) const;
    bool flips(Mesh::VertexHandle moved, Mesh::VertexHandle other, glm::dvec3 at) const;
    void collapse(Mesh::HalfedgeHandle h, glm::dvec3 at);
    // `planes`: receives the quadrics of its vertices; may be null
    CoarseMesh result(std::vector<PlaneQuadric> *planes) const;

    Mesh mesh_;
    size_t faces_ = 0;
    double sliver_ = 0;  // area below which a triangle's normal is meaningless
    std::vector<PlaneQuadric> planes_;
    std::vector<Features> features_;
    std::vector<uint32_t> ages_;
    std::priority_queue<Collapse> queue_;
    std::vector<Collapse> refused_;  // illegal when they were tried; they may become legal after others round them
    bool collapsed_ = true;          // since the refused ones were tried last
};

Coarsening::Coarsening(const ClosedMesh &surface, const std::vector<Attributes> &features)
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
    for (const auto edge : mesh_.edges()) enqueue(mesh_.halfedge_handle(edge, 0));
}

glm::dvec3 Coarsening::collapse_position(int a, int b) const
{
    PlaneQuadric sum = planes_[size_t(a)];
    sum += planes_[size_t(b)];
    return optimal_position(sum, point(mesh_, Mesh::VertexHandle(a)), point(mesh_, Mesh::VertexHandle(b)));
}

double Coarsening::cost(int a, int b, glm::dvec3 at) const
{
    return std::max(planes_[size_t(a)].at(at) + planes_[size_t(b)].at(at), 0.0) +
           variance_of(features_[size_t(a)], features_[size_t(b)]);
}

void Coarsening::enqueue(Mesh::HalfedgeHandle h)
{
    const int a = mesh_.from_vertex_handle(h).idx(), b = mesh_.to_vertex_handle(h).idx();
    const int from = std::min(a, b), to = std::max(a, b);
    queue_.push({cost(from, to, collapse_position(from, to)), from, to, ages_[size_t(from)], ages_[size_t(to)]});
}

// Returns whether moving `moved` to `at` flips one of its remaining triangles.
bool Coarsening::flips(Mesh::VertexHandle moved, Mesh::VertexHandle other, glm::dvec3 at) const
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
        if (lod::flips(TriangleFrame(before[0], before[1], before[2]), TriangleFrame(after[0], after[1], after[2]),
                       sliver_))
            return true;
    }
    return false;
}

void Coarsening::collapse(Mesh::HalfedgeHandle h, glm::dvec3 at)
{
    const Mesh::VertexHandle from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
    faces_ -= 2;
    planes_[size_t(to.idx())] += planes_[size_t(from.idx())];
    features_[size_t(to.idx())] = merged(features_[size_t(from.idx())], features_[size_t(to.idx())]);
    mesh_.collapse(h);
    mesh_.set_point(to, {at.x, at.y, at.z});
    ++ages_[size_t(to.idx())];
    for (auto out = mesh_.cvoh_iter(to); out.is_valid(); ++out) enqueue(*out);
}

void Coarsening::run(size_t target)
{
    while (faces_ > target) {
        // Illegal collapses are tried again in bulk: after every step would cost too much.
        if (queue_.empty() || (collapsed_ && refused_.size() > 32 + faces_ / 16)) {
            if (!collapsed_) return;
            for (const Collapse &again : refused_) queue_.push(again);
            refused_.clear(), collapsed_ = false;
            if (queue_.empty()) return;
        }
        const Collapse next = queue_.top();
        queue_.pop();
        const Mesh::VertexHandle from(next.from), to(next.to);
        if (mesh_.status(from).deleted() || mesh_.status(to).deleted()) continue;
        if (ages_[size_t(next.from)] != next.from_age || ages_[size_t(next.to)] != next.to_age) continue;
        const Mesh::HalfedgeHandle h = mesh_.find_halfedge(from, to);
        if (!h.is_valid()) continue;
        const glm::dvec3 at = collapse_position(next.from, next.to);
        if (!mesh_.is_collapse_ok(h) || flips(from, to, at) || flips(to, from, at)) {
            refused_.push_back(next);
            continue;
        }
        collapse(h, at);
        collapsed_ = true;
    }
}

CoarseMesh Coarsening::result(std::vector<PlaneQuadric> *planes) const
{
    CoarseMesh out;
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
                if (planes) planes->push_back(planes_[size_t(v->idx())]);
            }
            t[k] = n;
        }
        out.surface.triangles.push_back(t);
    }
    return out;
}

NonManifoldCollapse Coarsening::non_manifold() const
{
    std::vector<PlaneQuadric> planes;
    CoarseMesh level = result(&planes);
    return NonManifoldCollapse(std::move(level), std::move(planes), sliver_);
}

// Removes the small connected components.
ClosedMesh large_pieces_of(const ClosedMesh &surface)
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
    ClosedMesh out;
    out.positions = surface.positions;
    const double maximum = *std::max_element(areas.begin(), areas.end());
    for (const auto &t : surface.triangles)
        if (areas[root(t[0])] >= std::min(maximum, all / 50)) out.triangles.push_back(t);
    return out;
}

}  // namespace

CoarseMesh without_unused_vertices(const CoarseMesh &mesh)
{
    CoarseMesh out;
    std::map<uint32_t, uint32_t> numbers;
    for (std::array<uint32_t, 3> t : mesh.surface.triangles) {
        for (uint32_t &v : t) {
            const auto [found, is_new] = numbers.try_emplace(v, static_cast<uint32_t>(numbers.size()));
            if (is_new) {
                out.surface.positions.push_back(mesh.surface.positions[v]);
                out.features.push_back(mesh.features[v]);
            }
            v = found->second;
        }
        out.surface.triangles.push_back(t);
    }
    return out;
}

std::vector<CoarseMesh> coarsen(const ClosedMesh &surface, const std::vector<Attributes> &features,
                                const std::vector<size_t> &targets)
{
    Coarsening work(large_pieces_of(surface), features);
    std::vector<CoarseMesh> out;
    std::optional<NonManifoldCollapse> last;
    for (const size_t target : targets) {
        if (!last) work.run(target);
        if (!last && work.triangles() > target) last = work.non_manifold();
        if (last) last->run(target);
        out.push_back(last ? last->result() : work.result());
    }
    return out;
}

}  // namespace claque::lod
