// The smallest number of provoking vertices, compared with exhaustive search.
#include "passes/provoking.h"

#include <map>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/hash.h"

namespace claque::passes
{
namespace
{

uint32_t vertices_of(const std::vector<FlatTriangle> &triangles, const std::vector<Provoking> &ends)
{
    std::set<uint32_t> vertices;
    for (const FlatTriangle &t : triangles) vertices.insert(t.vertices.begin(), t.vertices.end());
    for (const Provoking &end : ends) vertices.erase(end.vertex);
    return static_cast<uint32_t>(ends.size() + vertices.size());
}

// The fewest for triangles of one orientation: tries each of the three corners of each triangle.
uint32_t fewest(const std::vector<FlatTriangle> &triangles)
{
    uint32_t least = ~0u;
    std::vector<uint32_t> choice(triangles.size(), 0);
    for (;;) {
        std::map<uint32_t, std::set<uint32_t>> colour_entries;
        for (const FlatTriangle &t : triangles)
            for (const uint32_t vertex : t.vertices) colour_entries[vertex];
        for (size_t t = 0; t < triangles.size(); ++t)
            colour_entries[triangles[t].vertices[choice[t]]].insert(triangles[t].colour_entry);
        uint32_t count = 0;
        for (const auto &[vertex, shown] : colour_entries)
            count += std::max<uint32_t>(1, static_cast<uint32_t>(shown.size()));
        least = std::min(least, count);
        size_t t = 0;
        while (t < choice.size() && ++choice[t] == 3) choice[t++] = 0;
        if (t == choice.size()) return least;
    }
}

std::vector<FlatTriangle> octahedron(const std::array<uint32_t, 8> &colour_entries)
{
    constexpr uint32_t faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    std::vector<FlatTriangle> out;
    for (size_t t = 0; t < 8; ++t)
        out.push_back({{faces[t][0], faces[t][1], faces[t][2]}, colour_entries[t], glm::vec3(0, 0, 1)});
    return out;
}

TEST(ProvokingVertices, AreNearlyAsFewAsPossible)
{
    uint32_t more = 0, meshes = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
        std::array<uint32_t, 8> colour_entries;
        const uint64_t count = 1 + seed % 4;
        for (uint64_t t = 0; t < 8; ++t) colour_entries[t] = static_cast<uint32_t>(base::mix(8 * seed + t + 1) % count);
        const std::vector<FlatTriangle> triangles = octahedron(colour_entries);
        const uint32_t made = vertices_of(triangles, provoking_vertices(triangles)), best = fewest(triangles);
        EXPECT_GE(made, best);
        EXPECT_LE(made, best + 1) << seed;
        more += made - best;
        ++meshes;
    }
    EXPECT_LE(more, meshes / 10);
}

TEST(ProvokingVertices, HoldEveryTriangleOnceAtACornerOfItsOwnWithItsAttributes)
{
    const std::vector<FlatTriangle> triangles = octahedron({0, 1, 2, 0, 1, 1, 2, 0});
    std::multiset<uint32_t> held;
    for (const Provoking &end : provoking_vertices(triangles))
        for (const uint32_t t : end.triangles) {
            held.insert(t);
            const auto &vertices = triangles[t].vertices;
            EXPECT_TRUE(std::count(vertices.begin(), vertices.end(), end.vertex));
            EXPECT_EQ(triangles[t].colour_entry, end.colour_entry);
        }
    EXPECT_EQ(held, (std::multiset<uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(ProvokingVertices, SeparateTrianglesOfDifferentNormals)
{
    std::vector<FlatTriangle> triangles = octahedron({0, 0, 0, 0, 0, 0, 0, 0});
    for (size_t t = 4; t < 8; ++t) triangles[t].normal = glm::vec3(0, 0, -1);
    for (const Provoking &end : provoking_vertices(triangles))
        for (const uint32_t t : end.triangles)
            EXPECT_GT(glm::dot(triangles[t].normal, triangles[end.triangles[0]].normal), 0);
}

TEST(ProvokingVertices, OfNothingAreNone) { EXPECT_TRUE(provoking_vertices({}).empty()); }

}  // namespace
}  // namespace claque::passes
