// Nodes hang below the nodes that they name as their parents, wherever Assimp lists them.
#include <gtest/gtest.h>

#include "samples/convert/scene.h"

namespace convert_test
{
namespace
{

aiNode *add(aiNode &by, const char *name)
{
    auto *made = new aiNode(name);
    by.addChildren(1, &made);
    return made;
}

TEST(ConvertedNodes, HangBelowTheParentsThatTheyName)
{
    aiNode root("root");
    aiNode *bones = add(root, "bones"), *hips = add(*bones, "hips"), *leg = add(*bones, "leg"),
           *foot = add(*bones, "foot");
    leg->mParent = hips, foot->mParent = leg;
    convert::hang_below_parents(root);
    ASSERT_EQ(bones->mNumChildren, 1u);
    EXPECT_EQ(bones->mChildren[0], hips);
    ASSERT_EQ(hips->mNumChildren, 1u);
    EXPECT_EQ(hips->mChildren[0], leg);
    ASSERT_EQ(leg->mNumChildren, 1u);
    EXPECT_EQ(leg->mChildren[0], foot);
}

TEST(ConvertedNodes, StayWhereTheirParentIsBelowThemOrAbsent)
{
    aiNode root("root"), other("other");
    aiNode *above = add(root, "above"), *below = add(*above, "below"), *lost = add(root, "lost");
    above->mParent = below, lost->mParent = &other;
    convert::hang_below_parents(root);
    EXPECT_EQ(root.mNumChildren, 2u);
    EXPECT_EQ(above->mNumChildren, 1u);
}

}  // namespace
}  // namespace convert_test
