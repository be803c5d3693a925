// The matching of split vertices has to fail as well, on each kind of damage that splitting can do.
#include "tests/reference/trajectories.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/reference/asset_files.h"
#include "tests/reference/comparison.h"
#include "tests/reference/triangles.h"
#include "tests/support/written_characters.h"

namespace claque::reference
{
namespace
{

class MatchingOfACharacter : public testing::TestWithParam<const char *>
{
protected:
    void SetUp() override
    {
        if (!written::is_written(GetParam()) && assets_folder().empty())
            GTEST_SKIP() << "no folder " << CLAQUE_ASSETS_DIR;
        character_ = load_character(written::path_of(GetParam(), assets_folder()));
        size_ = size_of(character_);
        triangles_ = triangles_of(character_, size_);
        used_ = vertices_of(triangles_, character_.vertex_count());
        for (const double time_s : {0.3, 0.9, 1.4}) add(character_, time_s);
    }

    // What the evaluation of `shown` gives, as if it had been split.
    void add(const Character &shown, double time_s)
    {
        const Shape shape = evaluate(shown, 0, time_s);
        poses_.push_back({evaluate(character_, 0, time_s), {shape.positions, shape.normals}});
    }

    // A vertex of the file by its share of all of them.
    size_t vertex(double share) const
    {
        return static_cast<size_t>(share * static_cast<double>(character_.vertex_count()));
    }

    Matching matching() const { return match(poses_, used_, tolerance * size_); }

    Character character_;
    double size_ = 0;
    Triangles triangles_;
    std::vector<bool> used_;
    std::vector<Pose> poses_;
};

TEST_P(MatchingOfACharacter, TheSameMatches) { EXPECT_TRUE(matching().same) << matching().text; }

TEST_P(MatchingOfACharacter, OrderAndCopiesDoNotMatter)
{
    for (Pose &pose : poses_) {
        Vertices &actual = pose.actual;
        std::swap(actual.positions[3], actual.positions[vertex(0.3)]);
        std::swap(actual.normals[3], actual.normals[vertex(0.3)]);
        actual.positions.push_back(actual.positions[17]);
        actual.normals.push_back(actual.normals[17]);
    }
    EXPECT_TRUE(matching().same) << matching().text;
}

TEST_P(MatchingOfACharacter, AVertexThatFollowsAnotherInOnePoseIsAStray)
{
    // Where it is then, there is a vertex of the file; only its way gives it away.
    poses_[2].actual.positions[40] = poses_[2].expected.positions[vertex(0.6)];
    EXPECT_EQ(1u, matching().strays) << matching().text;
}

TEST_P(MatchingOfACharacter, AVertexWithAnotherJointIsAStray)
{
    Character damaged = character_;
    size_t skinned = 0;
    while (damaged.parts.at(skinned).skin < 0) ++skinned;
    Part &part = damaged.parts[skinned];
    size_t influence = 0;
    while (part.weights.at(influence) < 0.9) ++influence;
    part.joints[influence] = (part.joints[influence] + 9) % character_.skins.at(0).joints.size();
    poses_.clear();
    for (const double time_s : {0.3, 0.9, 1.4}) add(damaged, time_s);
    EXPECT_EQ(1u, matching().strays) << matching().text;
}

TEST_P(MatchingOfACharacter, AVertexThatIsNotThereIsMissing)
{
    const Vec3 lonely = poses_[0].expected.positions.at(100);
    for (size_t v = poses_[0].actual.positions.size(); v-- > 0;) {
        if (length(poses_[0].actual.positions[v] - lonely) > 2 * tolerance * size_) continue;
        for (Pose &pose : poses_) {
            pose.actual.positions.erase(pose.actual.positions.begin() + static_cast<std::ptrdiff_t>(v));
            pose.actual.normals.erase(pose.actual.normals.begin() + static_cast<std::ptrdiff_t>(v));
        }
    }
    EXPECT_GE(matching().missing, 1u) << matching().text;
}

TEST_P(MatchingOfACharacter, ANormalThatLiesWrongIsNoticed)
{
    for (Pose &pose : poses_) {
        Vec3 &n = pose.actual.normals[123];
        n = {-n.x, n.y, n.z + 0.3};
    }
    EXPECT_EQ(1u, matching().bad_normals) << matching().text;
}

TEST_P(MatchingOfACharacter, ATurnedAMissingAndAStretchedTriangleAreNoticed)
{
    const std::vector<Vec3> &at = poses_[0].expected.positions;
    std::vector<Facet> facets;
    for (const Triangle &t : triangles_.all) facets.push_back(facet(at[t[0]], at[t[1]], at[t[2]]));
    const double distance = tolerance * size_;
    EXPECT_TRUE(match(facets, triangles_.has_area, facets, distance).same);

    std::vector<Facet> turned = facets;
    const auto large = std::max_element(facets.begin(), facets.end(),
                                        [](const Facet &a, const Facet &b) { return length(a.area) < length(b.area); });
    const size_t chosen = static_cast<size_t>(large - facets.begin());
    turned[chosen].area = turned[chosen].area * -1;
    EXPECT_EQ(1u, match(facets, triangles_.has_area, turned, distance).turned);
    EXPECT_EQ(1u, match(facets, triangles_.has_area, turned, distance).missing);

    std::vector<Facet> stretched = facets;
    stretched[chosen].area = stretched[chosen].area * 1.2;
    EXPECT_EQ(1u, match(facets, triangles_.has_area, stretched, distance).strays);

    std::vector<Facet> twice = facets;
    twice.push_back(facets[chosen]);
    EXPECT_FALSE(match(facets, triangles_.has_area, twice, distance).same);

    std::vector<Facet> fewer = facets;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(chosen));
    EXPECT_EQ(1u, match(facets, triangles_.has_area, fewer, distance).missing);
}

INSTANTIATE_TEST_SUITE_P(Of, MatchingOfACharacter,
                         testing::Values("humanoids/khronos/CesiumMan.glb", "WrittenPerson.glb"),
                         [](const auto &shown) {
                             return written::is_written(shown.param) ? "WrittenPerson" : "CesiumMan";
                         });

TEST(TrianglesOfAPart, FollowTheSpecificationForStripsFansAndMirroredNodes)
{
    Character character;
    character.nodes.resize(1);
    Part part;
    part.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    part.indices = {0, 1, 2, 3};
    part.mode = 5;
    character.parts = {part};
    EXPECT_EQ((std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}), triangles_of(character, 1).all);
    character.parts[0].mode = 6;
    EXPECT_EQ((std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}}), triangles_of(character, 1).all);
    character.nodes[0].scale = {-1, 1, 1};
    EXPECT_EQ((std::vector<Triangle>{{1, 0, 2}, {2, 0, 3}}), triangles_of(character, 1).all);
}

TEST(NormalLimit, IsTheSlackAloneWhereNothingIsStretched)
{
    EXPECT_NEAR(normal_slack, normal_limit(1, normal_slack), 1e-7);
    // The worst case of stretch 2: a normal at an angle whose tangent is 2 to the short axis, or 1 / 2.
    EXPECT_NEAR(std::atan(2.0) - std::atan(0.5), normal_limit(2, 0), 1e-12);
}

}  // namespace
}  // namespace claque::reference
