// Triangles on edges of more than two faces stand apart, exactly where the source has them.
#include "lib/lod/decimation/welded_surface.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace claque;

namespace
{

// A book: all its pages are triangles on one edge, which stands on the spine's two vertices.
model::Part book(uint32_t pages)
{
    model::Part part;
    part.name = "book";
    part.positions = {{7, 5, 3}, {7, 6, 3}};
    for (uint32_t page = 0; page < pages; ++page) {
        const float turn = 6.2f * float(page) / float(pages);
        part.positions.push_back({7 + std::cos(turn), 5.5f, 3 + std::sin(turn)});
        part.indices.insert(part.indices.end(), {0, 1, page + 2});
    }
    part.joints.assign(part.positions.size(), 0);
    part.weights.assign(part.positions.size(), 1);
    return part;
}

}  // namespace

// The number of pages decides at which vertex the mesh's arrays grow.
TEST(WeldedSurface, TrianglesOnAnEdgeOfManyFacesKeepTheirPlaces)
{
    omerr().disable();  // OpenMesh reports each such edge
    for (uint32_t pages = 1; pages <= 120; ++pages) {
        const model::Part part = book(pages);
        const lod::WeldedSurface surface({{&part}});
        ASSERT_EQ(surface.mesh.n_faces(), pages);
        // The edge holds two faces at most; all others are apart.
        EXPECT_GE(surface.non_manifold_triangles, pages > 2 ? pages - 2 : 0);
        for (const auto face : surface.mesh.faces()) {
            const lod::Corners &corners = surface.mesh.property(surface.corners, face);
            for (size_t k = 0; k < 3; ++k) {
                const auto point = surface.mesh.point(lod::Mesh::VertexHandle(corners.at[k]));
                const glm::vec3 wanted = surface.at_rest(corners.corner[k]);
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_EQ(point[static_cast<size_t>(axis)], double(wanted[axis]))
                        << pages << " pages, corner " << k;
            }
        }
    }
}
