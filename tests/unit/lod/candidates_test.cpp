// The levels that a chain keeps of its candidates.
#include "lib/lod/candidates.h"

#include <gtest/gtest.h>

#include "lib/lod/surface/area_fractions.h"

using namespace claque;

namespace
{

lod::Candidate of(size_t triangles, double error_m, bool is_proxy)
{
    lod::Candidate made;
    made.target = made.level.triangles = triangles, made.level.error_m = error_m, made.is_proxy = is_proxy;
    made.level.distance_m = lod::switch_distance(error_m, 1);
    made.parts.emplace_back();
    made.parts[0].indices.assign(3 * triangles, 0), made.parts[0].positions.resize(3);
    return made;
}

std::vector<size_t> triangles_of(const std::vector<lod::Candidate> &made)
{
    std::vector<size_t> out;
    for (const lod::Candidate &one : made) out.push_back(one.level.triangles);
    return out;
}

}  // namespace

TEST(Candidates, OfADecimatedLevelAndAProxyOfAsManyTrianglesTheOneWithTheSmallerErrorIsKept)
{
    std::vector<size_t> targets = {250, 120, 30};
    std::vector<lod::Candidate> made = {of(1000, 0, false),  of(490, 0.01, false), of(249, 0.02, false),
                                        of(250, 0.03, true), of(120, 0.05, true),  of(30, 0.09, true)};
    lod::prefer_near(made, targets);
    EXPECT_EQ(triangles_of(made), (std::vector<size_t>{1000, 490, 249}));
    EXPECT_EQ(targets, (std::vector<size_t>{120, 30}));

    targets = {250, 120, 30};
    made = {of(1000, 0, false),  of(490, 0.01, false), of(249, 0.04, false),
            of(250, 0.03, true), of(120, 0.05, true),  of(30, 0.09, true)};
    lod::prefer_near(made, targets);
    EXPECT_EQ(triangles_of(made), (std::vector<size_t>{1000, 490}));
    EXPECT_EQ(targets, (std::vector<size_t>{250, 120, 30}));
}

// Those of 20 triangles and more stay: a chain needs them.
TEST(Candidates, OfFewTrianglesThatLoseAZoneAreDropped)
{
    std::vector<lod::Candidate> made = {of(1000, 0, false), of(60, 0.01, true), of(30, 0.02, true), of(14, 0.05, true)};
    made[1].loses_zone = true;
    EXPECT_EQ(triangles_of(lod::prune(made)), (std::vector<size_t>{1000, 60, 30, 14}));
    made[3].loses_zone = true;
    EXPECT_EQ(triangles_of(lod::prune(made)), (std::vector<size_t>{1000, 60, 30}));
    const std::vector<double> source = {0.5, 0.485, 0.015, 0.009};
    EXPECT_FALSE(lod::loses_zone(source, {0.52, 0.46, 0.01, 0}));
    EXPECT_TRUE(lod::loses_zone(source, {0.52, 0.47, 0.0014, 0.0086}));
}

TEST(Candidates, ThatHaveLargerErrorsThanProxiesOfFewerTrianglesAreReplaced)
{
    std::vector<size_t> targets = {250};
    std::vector<lod::Candidate> made = {of(1000, 0, false), of(800, 0.01, false), of(490, 0.05, false),
                                        of(250, 0.03, true)};
    EXPECT_TRUE(lod::replace_by_proxy(made, targets));
    EXPECT_EQ(triangles_of(made), (std::vector<size_t>{1000, 800}));
    EXPECT_EQ(targets, (std::vector<size_t>{490, 250}));
}

TEST(Candidates, WithoutAUsefulDistanceAreDropped)
{
    const std::vector<lod::Candidate> made = {of(1000, 0, false), of(800, 0.03, false), of(600, 0.02, false),
                                              of(570, 0.03, false), of(300, 0.06, false)};
    EXPECT_EQ(triangles_of(lod::prune(made)), (std::vector<size_t>{1000, 570, 300}));
}
