// The link condition, compared with OpenMesh's answer on surfaces that are collapsed at random until no collapse is
// legal.
#include "lib/lod/surface/link_condition.h"

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/lod/decimation/welded_surface.h"

namespace claque::lod
{
namespace
{

using Base = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

Base requested(Base mesh)
{
    mesh.request_vertex_status(), mesh.request_edge_status(), mesh.request_halfedge_status(),
        mesh.request_face_status();
    return mesh;
}

// A sheet of quads with some faces missing; rows and columns may close on themselves.
Base sheet(int wide, int high, bool round, bool torus, uint64_t holes)
{
    Base mesh = requested({});
    const int columns = round || torus ? wide : wide + 1, rows = torus ? high : high + 1;
    std::vector<Base::VertexHandle> v;
    for (int i = 0; i < columns * rows; ++i)
        v.push_back(mesh.add_vertex(Base::Point(i % columns, i / columns, i * i % 7)));
    const auto at = [&](int x, int y) { return v[size_t(y % rows * columns + x % columns)]; };
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            if (holes != 0 && base::mix(holes + uint64_t(y * wide + x)) % 6 == 0) continue;
            mesh.add_face(at(x, y), at(x + 1, y), at(x + 1, y + 1));
            mesh.add_face(at(x, y), at(x + 1, y + 1), at(x, y + 1));
        }
    return mesh;
}

// A fan round one vertex with more neighbours than the linear search handles.
Base fan(int blades)
{
    Base mesh = requested({});
    const Base::VertexHandle hub = mesh.add_vertex(Base::Point(0, 0, 0)),
                             under = mesh.add_vertex(Base::Point(0, 0, -1));
    std::vector<Base::VertexHandle> rim;
    for (int i = 0; i < blades; ++i) rim.push_back(mesh.add_vertex(Base::Point(i, 1, 0)));
    for (int i = 0; i < blades; ++i) {
        mesh.add_face(hub, rim[size_t(i)], rim[size_t((i + 1) % blades)]);
        mesh.add_face(under, rim[size_t((i + 1) % blades)], rim[size_t(i)]);
    }
    return mesh;
}

struct Asked {
    size_t yes = 0, no = 0;
};

void collapse_at_random(Base mesh, uint64_t seed, Asked &asked)
{
    for (uint64_t step = 0;; ++step) {
        std::vector<Base::HalfedgeHandle> lawful;
        for (const Base::HalfedgeHandle h : mesh.all_halfedges()) {
            const bool expected = mesh.is_collapse_ok(h);
            if (mesh.status(mesh.edge_handle(h)).deleted()) continue;
            ASSERT_EQ(LinkCondition<Base>(mesh).holds(h), expected) << seed << " " << step << " " << h.idx();
            ++(expected ? asked.yes : asked.no);
            if (expected) lawful.push_back(h);
        }
        if (lawful.empty()) return;
        mesh.collapse(lawful[size_t(base::mix(seed + step) % lawful.size())]);
    }
}

TEST(LinkCondition, AgreesWithOpenMesh)
{
    Asked asked;
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const uint64_t holes = seed % 3 == 0 ? seed * 100 : 0;
        collapse_at_random(sheet(5, 4, false, false, holes), seed, asked);
        collapse_at_random(sheet(6, 5, true, false, holes), seed, asked);
        collapse_at_random(sheet(6, 5, true, true, holes), seed, asked);
        collapse_at_random(fan(int(3 + seed * 5)), seed, asked);
    }
    EXPECT_GT(asked.yes, 10000u);
    EXPECT_GT(asked.no, 10000u);
}

TEST(LinkCondition, IsNotMetByAnEdgeThatIsGone)
{
    Base mesh = sheet(4, 4, false, false, 0);
    const Base::HalfedgeHandle h = mesh.find_halfedge(Base::VertexHandle(6), Base::VertexHandle(7));
    ASSERT_TRUE(LinkCondition<Base>(mesh).holds(h));
    mesh.collapse(h);
    EXPECT_FALSE(LinkCondition<Base>(mesh).holds(h));
}

}  // namespace
}  // namespace claque::lod
