// The link condition: whether an edge of a triangle mesh may collapse and leave a surface (Dey, Edelsbrunner, Guha and
// Nekhayev 1999). It gives the same answer as OpenMesh's is_collapse_ok, which is compiled into its library with all
// its checks of handles and took two fifths of a decimation's time. Internal to lib/lod.
#pragma once

#include <algorithm>
#include <array>

#include <OpenMesh/Core/Mesh/Handles.hh>

namespace claque::lod
{

template <class Mesh>
class LinkCondition
{
public:
    using Halfedge = OpenMesh::HalfedgeHandle;
    using Vertex = OpenMesh::VertexHandle;

    explicit LinkCondition(const Mesh &mesh) : mesh_(mesh) {}

    // Tests the collapse of the start of `h` into its end.
    bool holds(Halfedge h) const
    {
        const Halfedge back = mesh_.opposite_halfedge_handle(h);
        const Vertex from = mesh_.to_vertex_handle(back), to = mesh_.to_vertex_handle(h);
        if (mesh_.status(mesh_.edge_handle(h)).deleted() || mesh_.status(from).deleted() || mesh_.status(to).deleted())
            return false;
        if (hangs_on_this_edge(h) || hangs_on_this_edge(back)) return false;
        const Vertex left = across(h), right = across(back);
        if (left == right || share_others(from, to, left, right)) return false;
        return is_border(h) || is_border(back) || !mesh_.is_boundary(from) || !mesh_.is_boundary(to);
    }

private:
    static constexpr size_t max_near = 32;  // larger neighbourhoods are not buffered for the linear search

    bool is_border(Halfedge h) const { return !mesh_.face_handle(h).is_valid(); }

    Vertex across(Halfedge h) const
    {
        return is_border(h) ? Vertex() : mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
    }

    // A triangle whose two other edges are open.
    bool hangs_on_this_edge(Halfedge h) const
    {
        if (is_border(h)) return false;
        const Halfedge next = mesh_.next_halfedge_handle(h), last = mesh_.next_halfedge_handle(next);
        return is_border(mesh_.opposite_halfedge_handle(next)) && is_border(mesh_.opposite_halfedge_handle(last));
    }

    template <class Visit>
    bool any_neighbour(Vertex v, const Visit &visit) const
    {
        const Halfedge first = mesh_.halfedge_handle(v);
        for (Halfedge h = first; h.is_valid();) {
            if (visit(mesh_.to_vertex_handle(h))) return true;
            h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
            if (h == first) break;
        }
        return false;
    }

    bool share_others(Vertex from, Vertex to, Vertex left, Vertex right) const
    {
        std::array<Vertex, max_near> near;
        size_t count = 0;
        const bool many = any_neighbour(to, [&](Vertex v) {
            if (count == max_near) return true;
            near[count++] = v;
            return false;
        });
        return any_neighbour(from, [&](Vertex v) {
            if (v == left || v == right) return false;
            if (many) return any_neighbour(to, [&](Vertex other) { return other == v; });
            return std::find(near.begin(), near.begin() + count, v) != near.begin() + count;
        });
    }

    const Mesh &mesh_;
};

}  // namespace claque::lod
