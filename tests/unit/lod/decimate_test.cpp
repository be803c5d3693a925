#include "lib/lod/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "lib/base/error.h"
#include "lib/figures/figure.h"

using namespace claque;

namespace
{

using Place = std::tuple<float, float, float>;

Place place(const model::Part &part, uint32_t v)
{
    return {part.positions[v].x, part.positions[v].y, part.positions[v].z};
}

size_t open_edges(const model::Part &part)
{
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto &t : model::triangles_of(part))
        for (size_t k = 0; k < 3; ++k) {
            const Place a = place(part, t[k]), b = place(part, t[(k + 1) % 3]);
            if (edges.count({b, a}) && edges[{b, a}] > 0) --edges[{b, a}];
            else ++edges[{a, b}];
        }
    size_t open = 0;
    for (const auto &[edge, count] : edges) open += static_cast<size_t>(count);
    return open;
}

// A closed, bumpy ball with a seam of texture coordinates along one meridian.
model::Part ball(int columns, int rows)
{
    model::Part part;
    part.name = "ball";
    const float pi = 3.14159265f;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) {
            const float u = float(c) / float(columns), v = float(r) / float(rows);
            const float a = 2 * pi * float(c % columns) / float(columns), b = pi * v;
            const float ring = r == 0 || r == rows ? 0 : std::sin(b);
            const float radius = 1 + 0.05f * std::sin(3 * a) * ring;
            part.positions.push_back({radius * ring * std::cos(a), radius * std::cos(b), radius * ring * std::sin(a)});
            part.uvs.push_back({u, v});
            part.joints.push_back(0);
            part.weights.push_back(1);
        }
    const auto at = [columns](int r, int c) { return uint32_t(r * (columns + 1) + c); };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            if (r > 0) part.indices.insert(part.indices.end(), {at(r, c), at(r, c + 1), at(r + 1, c)});
            if (r + 1 < rows) part.indices.insert(part.indices.end(), {at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
        }
    return part;
}

}  // namespace

TEST(Decimate, reaches_its_target_on_a_closed_surface_with_a_seam_and_leaves_it_closed)
{
    const model::Part source = ball(48, 24);
    ASSERT_EQ(open_edges(source), 0u);
    for (const size_t target : {1000u, 400u, 150u}) {
        const lod::Decimated less = lod::decimate(source, {target, 60});
        EXPECT_EQ(less.refused, 0u);
        EXPECT_LE(less.triangles, target);
        EXPECT_GE(less.triangles, target - 2);
        EXPECT_EQ(model::triangles_of(less.part).size(), less.triangles);
        EXPECT_EQ(open_edges(less.part), 0u);
    }
}

TEST(Decimate, keeps_close_to_the_surface)
{
    const lod::Decimated less = lod::decimate(ball(48, 24), {400, 60});
    for (const auto &t : model::triangles_of(less.part)) {
        const glm::vec3 middle =
            (less.part.positions[t[0]] + less.part.positions[t[1]] + less.part.positions[t[2]]) / 3.0f;
        EXPECT_NEAR(glm::length(middle), 1, 0.09f);
    }
}

// On the wrong side of a seam a triangle would run across the whole texture.
TEST(Decimate, never_lets_a_triangle_straddle_a_seam)
{
    const lod::Decimated less = lod::decimate(ball(48, 24), {300, 60});
    for (const auto &t : model::triangles_of(less.part)) {
        const float u[3] = {less.part.uvs[t[0]].x, less.part.uvs[t[1]].x, less.part.uvs[t[2]].x};
        const float v[3] = {less.part.uvs[t[0]].y, less.part.uvs[t[1]].y, less.part.uvs[t[2]].y};
        if (std::max({v[0], v[1], v[2]}) > 0.99f || std::min({v[0], v[1], v[2]}) < 0.01f) continue;  // at the poles
        EXPECT_LT(std::max({u[0], u[1], u[2]}) - std::min({u[0], u[1], u[2]}), 0.6f);
    }
}

TEST(Decimate, keeps_only_vertices_of_the_source_with_all_that_belongs_to_them)
{
    const model::Model citizen = figures::citizen();
    const model::Part &source = citizen.parts[0];
    std::map<std::tuple<float, float, float, float, float>, uint32_t> known;
    for (uint32_t v = 0; v < source.positions.size(); ++v)
        known[std::tuple_cat(place(source, v), std::make_tuple(source.uvs[v].x, source.uvs[v].y))] = v;
    const lod::Decimated less = lod::decimate(source, {600, 60});
    EXPECT_LE(less.triangles, 640u);
    EXPECT_LE(open_edges(less.part), open_edges(source));
    for (uint32_t v = 0; v < less.part.positions.size(); ++v) {
        const auto at =
            known.find(std::tuple_cat(place(less.part, v), std::make_tuple(less.part.uvs[v].x, less.part.uvs[v].y)));
        ASSERT_NE(at, known.end());
        for (size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(less.part.joints[4 * v + k], source.joints[4 * at->second + k]);
            EXPECT_EQ(less.part.weights[4 * v + k], source.weights[4 * at->second + k]);
        }
    }
}

TEST(Decimate, gives_the_same_result_twice)
{
    const model::Part source = ball(40, 20);
    EXPECT_EQ(lod::decimate(source, {300, 60}).part.indices, lod::decimate(source, {300, 60}).part.indices);
}

TEST(Decimate, refuses_what_it_cannot_do)
{
    model::Part empty;
    EXPECT_THROW(lod::decimate(empty, {10, 60}), base::Error);
    model::Part morphing = ball(8, 4);
    morphing.morphs.resize(1);
    EXPECT_THROW(lod::decimate(morphing, {10, 60}), base::Error);
}
