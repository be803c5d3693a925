// Merging parts into one vertex order: welding, dropping, reversing, sorting.
#include <algorithm>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "models.h"

namespace claque::test
{

namespace
{

model::Model plain(const model::Part &part)
{
    model::Model m = empty_model();
    m.parts.push_back(part);
    m.parts[0].material = model::none;
    return m;
}

model::Part soup(const std::vector<glm::vec3> &positions)
{
    model::Part part;
    part.node = 0;
    part.positions = positions;
    part.joints.assign(positions.size(), 0);
    part.weights.assign(positions.size(), 1);
    return part;
}

glm::vec3 position(const model::Level &level, uint32_t v)
{
    return {level.positions[3 * v], level.positions[3 * v + 1], level.positions[3 * v + 2]};
}

glm::vec3 face_of(const model::Level &level, uint32_t first)
{
    const glm::vec3 a = position(level, level.indices[first]), b = position(level, level.indices[first + 1]),
                    c = position(level, level.indices[first + 2]);
    return glm::normalize(glm::cross(b - a, c - a));
}

}  // namespace

TEST(Mesh, VerticesEqualInEverythingAreWeldedAndNoOthers)
{
    model::Part part = sheet_part(3, 3);
    model::Part unwelded = part;
    unwelded.indices.clear();
    unwelded.positions.clear(), unwelded.normals.clear(), unwelded.uvs.clear();
    unwelded.joints.clear(), unwelded.weights.clear();
    for (const uint32_t v : part.indices) {
        unwelded.positions.push_back(part.positions[v]);
        unwelded.normals.push_back(part.normals[v]);
        unwelded.uvs.push_back(part.uvs[v]);
        unwelded.joints.push_back(0);
        unwelded.weights.push_back(1);
    }
    EXPECT_EQ(built(plain(unwelded))->levels[0].source_count, 16u);
    unwelded.normals[4] = glm::vec3(0, 1, 0);
    EXPECT_EQ(built(plain(unwelded))->levels[0].source_count, 17u);
}

TEST(Mesh, NoPositionOrUvIsLost)
{
    const model::Part part = sheet_part(5, 4);
    model::Model m = torture(3, 1, 9);
    m.parts[0] = part;
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[0];
    std::set<std::array<float, 5>> wanted, found;
    for (size_t v = 0; v < part.positions.size(); ++v)
        wanted.insert({part.positions[v].x, part.positions[v].y, part.positions[v].z, part.uvs[v].x, part.uvs[v].y});
    for (uint32_t v = 0; v < level.source_count; ++v) {
        const glm::vec3 p = position(level, v);
        found.insert({p.x, p.y, p.z, level.uvs[2 * v], level.uvs[2 * v + 1]});
    }
    EXPECT_EQ(found, wanted);
}

TEST(Mesh, TrianglesWithoutAreaInAnyPoseAreDroppedAndCounted)
{
    model::Part part = soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 0, 0}});
    part.indices = {0, 1, 2, 0, 1, 3, 1, 4, 2};  // valid, collinear, two corners at one point
    const auto tmpl = built(plain(part));
    EXPECT_EQ(tmpl->report.triangles, 1u);
    EXPECT_EQ(tmpl->report.degenerate, 2u);
    EXPECT_EQ(tmpl->levels[0].source_count, 3u) << "unused vertices go too";
}

TEST(Mesh, ATriangleThatOpensWhenAJointMovesIsKept)
{
    model::Part part = soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}});
    part.indices = {0, 1, 2, 0, 1, 3};
    model::Model m = plain(part);
    m.rig.palette.push_back({0, math::Affine()});
    m.parts[0].joints[3] = 1;
    EXPECT_EQ(built(m)->report.triangles, 2u);
}

TEST(Mesh, PartsWithoutNormalsGetFlatOnes)
{
    model::Part part = soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    part.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const auto tmpl = built(plain(part));
    const model::Level &level = tmpl->levels[0];
    EXPECT_EQ(level.source_count, 12u);
    for (uint32_t i = 0; i < level.surfaces[0].clean[0].range.count; i += 3)
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = level.indices[i + k];
            const glm::vec3 n(level.normals[3 * v], level.normals[3 * v + 1], level.normals[3 * v + 2]);
            EXPECT_NEAR(glm::distance(n, face_of(level, i)), 0, 1e-6f);
            EXPECT_GT(glm::dot(n, position(level, v) - glm::vec3(0.2f)), 0) << "outwards";
        }
}

TEST(Mesh, PartsThatHangMirroredAreWoundTheOtherWay)
{
    model::Model m = plain(sheet_part(1, 1));
    const float before = face_of(built(m)->levels[0], 0).z;
    m.rig.rest[0].scale = glm::vec3(1, 1, -1);
    const auto tmpl = built(m);
    EXPECT_EQ(face_of(tmpl->levels[0], 0).z, -before);
    EXPECT_EQ(tmpl->levels[0].normals[2], 1) << "normals follow the matrix by themselves";
}

TEST(Mesh, VerticesAreSortedIntoRunsByInfluencesWithoutZeroWeights)
{
    model::Model m = plain(sheet_part(3, 1));
    for (int i = 0; i < 3; ++i) m.rig.palette.push_back({0, math::Affine()});
    model::Part &part = m.parts[0];
    part.influence_count = 4;
    part.joints.clear(), part.weights.clear();
    for (uint32_t v = 0; v < 8; ++v) {
        part.joints.insert(part.joints.end(), {0, 1, 2, 3});
        const std::vector<float> weights = v % 3 == 0   ? std::vector<float>{0.25f, 0.5f, 0.125f, 0.125f}
                                           : v % 3 == 1 ? std::vector<float>{0, 0, 1, 0}
                                                        : std::vector<float>{0.3f, 0, 0.7f, 0};
        part.weights.insert(part.weights.end(), weights.begin(), weights.end());
    }
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[0];
    ASSERT_EQ(level.runs.size(), 3u);
    const uint32_t influences[3] = {1, 2, 4}, counts[3] = {3, 2, 3};
    for (size_t r = 0; r < 3; ++r) {
        EXPECT_EQ(level.runs[r].influences, influences[r]);
        EXPECT_EQ(level.runs[r].count, counts[r]);
        for (uint32_t v = 0; v < level.runs[r].count; ++v) {
            float sum = 0;
            for (uint32_t i = 0; i < influences[r]; ++i) {
                const float w = level.weights[level.runs[r].first_influence + v * influences[r] + i];
                EXPECT_GT(w, 0);
                sum += w;
            }
            EXPECT_FLOAT_EQ(sum, 1);
        }
    }
    EXPECT_EQ(level.joints[0], 2);
}

TEST(Mesh, CoincidentFacesAreCountedWhereTheyCanTie)
{
    model::Model m = plain(sheet_part(1, 1));
    m.parts.push_back(m.parts[0]);
    EXPECT_EQ(built(m)->report.coincident, 2u);
    std::swap(m.parts[1].indices[0], m.parts[1].indices[1]);
    std::swap(m.parts[1].indices[3], m.parts[1].indices[4]);
    EXPECT_EQ(built(m)->report.coincident, 0u) << "back to back, one of them is culled";
    m.materials.emplace_back();
    m.materials[0].double_sided = true;
    m.parts[1].material = 0;
    EXPECT_EQ(built(m)->report.coincident, 2u);
}

TEST(Mesh, ColoursAreKeptOnlyWhereSomePartHasThem)
{
    model::Model m = plain(sheet_part(1, 1));
    EXPECT_TRUE(built(m)->levels[0].colours.empty());
    m.parts.push_back(m.parts[0]);
    m.parts[1].colours.assign(4, {10, 20, 30, 40});
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[0];
    ASSERT_EQ(level.colours.size(), 4u * level.vertex_count);
    EXPECT_EQ(level.source_count, 8u);
    EXPECT_EQ(level.colours[0], 255);
    EXPECT_EQ(level.colours[4 * 4], 10);
    EXPECT_EQ(level.colours[4 * 4 + 3], 255) << "alpha belongs to the zones";
}

TEST(Mesh, MorphDeltasAreListedByWeightAndKeepVerticesApart)
{
    model::Model m = plain(sheet_part(1, 1));
    m.rig.morph_sets.push_back({0, 0, 2});
    m.rig.rest_weights = {0, 0};
    m.parts[0].morph_set = 0;
    m.parts[0].morphs.resize(2);
    m.parts[0].morphs[0].positions.assign(4, glm::vec3(0));
    m.parts[0].morphs[1].positions.assign(4, glm::vec3(0));
    m.parts[0].morphs[0].positions[3] = glm::vec3(0, 0, 2);
    m.parts[0].morphs[1].positions[1] = glm::vec3(0, 3, 0);
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[0];
    ASSERT_EQ(level.morph_ranges.size(), 2u);
    EXPECT_EQ(level.morph_ranges[1].weight, 1u);
    ASSERT_EQ(level.morph_deltas.size(), 2u);
    EXPECT_EQ(position(level, level.morph_deltas[0].vertex), glm::vec3(1, 1, 0));
    EXPECT_EQ(level.morph_deltas[1].position[1], 3);
}

}  // namespace claque::test
