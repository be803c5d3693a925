// Decimation: targets, seams, parts, attributes and determinism.
#include "lib/lod/decimation/decimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/lod/surface/quadric.h"

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

lod::Decimated to(const model::Part &part, size_t target) { return lod::decimate({{&part}}, {{target}})[0]; }

// An upright tube that bends in the middle: two joints with a gradual change of weights.
model::Part tube(int columns, int rows)
{
    model::Part part;
    part.name = "tube";
    part.skinned = true;
    part.influence_count = 2;
    const float pi = 3.14159265f;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const float a = 2 * pi * float(c) / float(columns), h = 2 * float(r) / float(rows);
            part.positions.push_back({0.2f * std::cos(a), h, 0.2f * std::sin(a)});
            const float w = std::clamp((h - 0.8f) / 0.4f, 0.0f, 1.0f);
            part.joints.insert(part.joints.end(), {0, 1});
            part.weights.insert(part.weights.end(), {1 - w, w});
        }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto at = [&](int row, int column) { return uint32_t(row * columns + column % columns); };
            part.indices.insert(part.indices.end(), {at(r, c), at(r + 1, c), at(r, c + 1)});
            part.indices.insert(part.indices.end(), {at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)});
        }
    return part;
}

// The heights that still have a ring of vertices: the tube needs rings where it bends.
size_t vertices_between(const model::Part &part, float first, float last)
{
    return size_t(std::count_if(part.positions.begin(), part.positions.end(),
                                [=](glm::vec3 p) { return p.y > first && p.y < last; }));
}

}  // namespace

TEST(Decimate, ReachesItsTargetOnAClosedSurfaceWithASeamAndLeavesItClosed)
{
    const model::Part source = ball(48, 24);
    ASSERT_EQ(open_edges(source), 0u);
    for (const size_t target : {1000u, 400u, 150u}) {
        const lod::Decimated less = to(source, target);
        EXPECT_EQ(less.non_manifold_triangles, 0u);
        EXPECT_LE(less.triangles, target);
        EXPECT_GE(less.triangles, target - 2);
        EXPECT_EQ(model::triangles_of(less.parts[0]).size(), less.triangles);
        EXPECT_EQ(open_edges(less.parts[0]), 0u);
    }
}

TEST(Decimate, KeepsCloseToTheSurface)
{
    const lod::Decimated less = to(ball(48, 24), 400);
    for (const auto &t : model::triangles_of(less.parts[0])) {
        const glm::vec3 middle =
            (less.parts[0].positions[t[0]] + less.parts[0].positions[t[1]] + less.parts[0].positions[t[2]]) / 3.0f;
        EXPECT_NEAR(glm::length(middle), 1, 0.09f);
    }
}

// A joint that a vertex names twice counts with the sum of both weights.
TEST(Decimate, TakesAnInfluenceInTwoHalvesAsTheWhole)
{
    const model::Part whole = tube(12, 24);
    model::Part halves = whole;
    halves.influence_count = 3;
    halves.joints.clear(), halves.weights.clear();
    for (size_t v = 0; v < whole.positions.size(); ++v) {
        const float half = 0.5f * whole.weights[2 * v + 1];
        halves.joints.insert(halves.joints.end(), {1, 0, 1});
        halves.weights.insert(halves.weights.end(), {half, whole.weights[2 * v], half});
    }
    for (const size_t target : {400u, 200u, 60u}) {
        const lod::Decimated a = to(whole, target), b = to(halves, target);
        EXPECT_EQ(a.parts[0].positions, b.parts[0].positions) << target;
        EXPECT_EQ(a.parts[0].indices, b.parts[0].indices) << target;
    }
}

// On the wrong side of a seam a triangle would span the whole texture.
TEST(Decimate, NeverLetsATriangleStraddleASeam)
{
    const lod::Decimated less = to(ball(48, 24), 300);
    for (const auto &t : model::triangles_of(less.parts[0])) {
        const float u[3] = {less.parts[0].uvs[t[0]].x, less.parts[0].uvs[t[1]].x, less.parts[0].uvs[t[2]].x};
        const float v[3] = {less.parts[0].uvs[t[0]].y, less.parts[0].uvs[t[1]].y, less.parts[0].uvs[t[2]].y};
        if (std::max({v[0], v[1], v[2]}) > 0.99f || std::min({v[0], v[1], v[2]}) < 0.01f) continue;  // at the poles
        EXPECT_LT(std::max({u[0], u[1], u[2]}) - std::min({u[0], u[1], u[2]}), 0.6f);
    }
}

TEST(Decimate, KeepsSourceVerticesWithAllTheirAttributes)
{
    const model::Model citizen = figures::citizen();
    const model::Part &source = citizen.parts[0];
    std::map<std::tuple<float, float, float, float, float>, uint32_t> known;
    for (uint32_t v = 0; v < source.positions.size(); ++v)
        known[std::tuple_cat(place(source, v), std::make_tuple(source.uvs[v].x, source.uvs[v].y))] = v;
    const lod::Decimated less = to(source, 600);
    EXPECT_LE(less.triangles, 640u);
    EXPECT_LE(open_edges(less.parts[0]), open_edges(source));
    for (uint32_t v = 0; v < less.parts[0].positions.size(); ++v) {
        const auto at = known.find(
            std::tuple_cat(place(less.parts[0], v), std::make_tuple(less.parts[0].uvs[v].x, less.parts[0].uvs[v].y)));
        ASSERT_NE(at, known.end());
        for (size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(less.parts[0].joints[4 * v + k], source.joints[4 * at->second + k]);
            EXPECT_EQ(less.parts[0].weights[4 * v + k], source.weights[4 * at->second + k]);
        }
    }
}

TEST(Decimate, GivesTheSameResultTwice)
{
    const model::Part source = ball(40, 20);
    EXPECT_EQ(to(source, 300).parts[0].indices, to(source, 300).parts[0].indices);
}

TEST(Decimate, HasTheVerticesOfALevelFirstInEveryFinerOne)
{
    const model::Part source = ball(40, 20);
    const std::vector<lod::Decimated> chain = lod::decimate({{&source}}, {{900, 500, 200, 60}});
    ASSERT_EQ(chain.size(), 4u);
    for (size_t k = 1; k < chain.size(); ++k) {
        const model::Part &fine = chain[k - 1].parts[0], &coarse = chain[k].parts[0];
        EXPECT_LT(chain[k].triangles, chain[k - 1].triangles);
        ASSERT_LT(coarse.positions.size(), fine.positions.size());
        for (size_t v = 0; v < coarse.positions.size(); ++v) {
            EXPECT_EQ(coarse.positions[v], fine.positions[v]);
            EXPECT_EQ(coarse.uvs[v], fine.uvs[v]);
        }
    }
}

TEST(Decimate, TurnsNoTriangleOverInItsTexture)
{
    const lod::Decimated less = to(ball(48, 24), 120);
    for (const auto &t : model::triangles_of(less.parts[0])) {
        const glm::vec2 a = less.parts[0].uvs[t[0]], b = less.parts[0].uvs[t[1]], c = less.parts[0].uvs[t[2]];
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        EXPECT_GE(area, 0) << "u runs round, v down: all triangles of the source have one orientation";
    }
}

// Two halves of a ball as separate parts, like trousers and a shirt.
TEST(Decimate, OpensNoCrackBetweenPartsThatTouch)
{
    const model::Part whole = ball(40, 20);
    model::Part upper = whole, lower = whole;
    upper.indices.clear(), lower.indices.clear();
    for (const auto &t : model::triangles_of(whole)) {
        const float y = whole.positions[t[0]].y + whole.positions[t[1]].y + whole.positions[t[2]].y;
        std::vector<uint32_t> &to_half = y > 0.1f ? upper.indices : lower.indices;
        to_half.insert(to_half.end(), t.begin(), t.end());
    }
    upper.node = lower.node = 0;
    const lod::Decimated less = lod::decimate({{&upper}, {&lower}}, {{300}})[0];
    EXPECT_LE(less.triangles, 300u);
    model::Part joined = less.parts[0];
    const uint32_t shift = uint32_t(joined.positions.size());
    joined.positions.insert(joined.positions.end(), less.parts[1].positions.begin(), less.parts[1].positions.end());
    for (const uint32_t i : less.parts[1].indices) joined.indices.push_back(shift + i);
    EXPECT_GT(open_edges(less.parts[0]), 0u);
    EXPECT_EQ(open_edges(joined), 0u);
}

TEST(Decimate, KeepsRingsWhereInfluencesChangeAndRemovesFlatOnes)
{
    const model::Part source = tube(16, 40);
    const lod::Decimated with = lod::decimate({{&source}}, {{160}, 60, 0.1, 0})[0];
    const lod::Decimated without = lod::decimate({{&source}}, {{160}, 60, 0, 0})[0];
    EXPECT_GT(vertices_between(with.parts[0], 0.7f, 1.3f), 2 * vertices_between(with.parts[0], 0.05f, 0.65f));
    EXPECT_LT(vertices_between(without.parts[0], 0.7f, 1.3f), vertices_between(with.parts[0], 0.7f, 1.3f));
}

TEST(Decimate, KeepsMorphTargets)
{
    model::Part source = ball(16, 8);
    source.morphs.resize(1);
    for (const glm::vec3 p : source.positions) source.morphs[0].positions.push_back(2.0f * p);
    const lod::Decimated less = to(source, 100);
    ASSERT_EQ(less.parts[0].morphs[0].positions.size(), less.parts[0].positions.size());
    for (size_t v = 0; v < less.parts[0].positions.size(); ++v)
        EXPECT_EQ(less.parts[0].morphs[0].positions[v], 2.0f * less.parts[0].positions[v]);
}

TEST(Decimate, RefusesWhatItCannotDo)
{
    const model::Part empty, some = ball(8, 4);
    EXPECT_THROW(lod::decimate({{&empty}}, {{10}}), base::Error);
    EXPECT_THROW(lod::decimate({{&some}}, {}), base::Error);
}

// The quadric of a triangle's attribute, compared with the sampled integral of the difference of two linear functions:
// at a point p with value s it is the area times the squared difference between s and the plane's value there.
TEST(AttributeQuadric, IsTheSquaredDifferenceFromTheLinearFunction)
{
    const glm::dvec3 p0(0, 0, 0), p1(2, 0, 0), p2(0, 1, 1);
    lod::AttributeQuadric quadric;
    const lod::TriangleFrame frame(p0, p1, p2);
    quadric.add_triangle(frame, {{0, 1.0}}, {{0, 5.0}}, {{0, 2.0}, {7, 1.0}});
    EXPECT_NEAR(frame.area, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(quadric.at(p1, {{0, 5.0}}), 0, 1e-12);
    EXPECT_NEAR(quadric.at((p0 + p1) * 0.5, {{0, 3.0}}), 0, 1e-12);
    EXPECT_NEAR(quadric.at(p1, {{0, 4.0}}), frame.area, 1e-9);
    EXPECT_NEAR(quadric.at(p1, {{0, 5.0}, {9, 2.0}}), 4 * frame.area, 1e-9) << "an attribute that no vertex there has";
    EXPECT_NEAR(quadric.at(p2, {{0, 2.0}}), frame.area, 1e-9) << "an attribute that is missing here";
}
