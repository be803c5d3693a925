// Vertices of later levels that need no second visit: only those that move as an earlier one did.
#include "meshsplit/known_vertices.h"

#include <gtest/gtest.h>

namespace claque::test
{
namespace
{

// Three vertices: two of one influence, one of two.
model::Level level()
{
    model::Level out(std::pmr::get_default_resource());
    out.positions = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    out.joints = {0, 1, 0, 1};
    out.weights = {1, 1, 0.5f, 0.5f};
    out.source_count = out.vertex_count = 3;
    out.runs = {{0, 2, 1, 0}, {2, 1, 2, 2}};
    return out;
}

using Flags = std::vector<uint8_t>;

TEST(KnownVertices, AreAllOfARepeatedLevel)
{
    meshsplit::KnownVertices known;
    EXPECT_EQ(known.among(level()), (Flags{0, 0, 0}));
    EXPECT_EQ(known.among(level()), (Flags{1, 1, 1}));
}

TEST(KnownVertices, AreNoneWithOtherPositionsOrInfluences)
{
    meshsplit::KnownVertices known;
    known.among(level());
    model::Level elsewhere = level(), follows = level(), weighs = level();
    elsewhere.positions[4] = 0.25f;
    EXPECT_EQ(known.among(elsewhere), (Flags{1, 0, 1}));
    follows.joints[0] = 1;
    EXPECT_EQ(known.among(follows), (Flags{0, 1, 1}));
    weighs.weights[2] = 0.25f, weighs.weights[3] = 0.75f;
    EXPECT_EQ(known.among(weighs), (Flags{1, 1, 0}));
}

TEST(KnownVertices, AreNoneWhereMorphTargetsMoveThem)
{
    meshsplit::KnownVertices known;
    known.among(level());
    model::Level morphed = level();
    morphed.morph_deltas.emplace_back();
    EXPECT_EQ(known.among(morphed), (Flags{0, 0, 0}));
}

}  // namespace
}  // namespace claque::test
