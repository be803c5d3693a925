// Bones of one name, as files have them that hold two armatures: Assimp names the node of a bone and no more.
#include <gtest/gtest.h>

#include "samples/convert/scene.h"

namespace convert_test
{
namespace
{

aiNode *node_at(aiNode &parent, const char *name, float height)
{
    auto *node = new aiNode(name);  // its parent deletes it
    node->mTransformation.b4 = height;
    parent.addChildren(1, &node);
    return node;
}

TEST(Skins, ChooseTheBoneThatLeavesTheMeshInPlace)
{
    for (const bool hat_first : {false, true}) {
        aiScene from;
        from.mRootNode = new aiNode("root");
        aiNode *bones[2] = {};
        for (const bool hat : {hat_first, !hat_first}) {
            aiNode *armature = node_at(*from.mRootNode, hat ? "hat armature" : "armature", hat ? 1.5f : 0.25f);
            bones[hat] = node_at(*armature, "Bone", 0.125f);
        }
        aiNode *hat = node_at(*from.mRootNode, "hat", 1.75f), *boots = node_at(*from.mRootNode, "boots", 0);
        aiMesh mesh;
        mesh.mNumVertices = 1;
        mesh.mBones = new aiBone *[mesh.mNumBones = 1] { new aiBone };
        aiBone &bone = *mesh.mBones[0];
        bone.mName = "Bone";
        bone.mWeights = new aiVertexWeight[bone.mNumWeights = 1]{{0, 1.0f}};

        const convert::Options options;
        convert::Scene scene{from, options, "two_armatures.fbx"};
        convert::add_nodes(scene);
        bone.mOffsetMatrix.b4 = 1.75f - 1.625f;
        const convert::Skin of_hat = convert::skin_of(scene, *hat, mesh);
        ASSERT_EQ(of_hat.joints.size(), 1u);
        EXPECT_EQ(of_hat.joints[0], bones[1]);
        bone.mOffsetMatrix.b4 = 0 - 0.375f;
        EXPECT_EQ(convert::skin_of(scene, *boots, mesh).joints[0], bones[0]);
        bone.mName = "Spine";
        EXPECT_EQ(convert::skin_of(scene, *boots, mesh).joints[0], boots) << "a bone without a node";
    }
}

}  // namespace
}  // namespace convert_test
