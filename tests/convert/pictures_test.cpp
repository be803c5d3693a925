// Materials of old files that name no picture, and pictures with holes.
#include <fstream>

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <gtest/gtest.h>

#include "samples/convert/picture_codec.h"
#include "samples/convert/scene.h"

namespace convert_test
{
namespace
{

// One material of this colour on a mesh with bones and texture coordinates.
struct Skinned {
    aiScene from;
    explicit Skinned(aiColor4D colour)
    {
        auto *material = new aiMaterial;
        material->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
        from.mMaterials = new aiMaterial *[from.mNumMaterials = 1] { material };
        auto *mesh = new aiMesh;
        mesh->mNumVertices = 1, mesh->mTextureCoords[0] = new aiVector3D[1];
        mesh->mBones = new aiBone *[mesh->mNumBones = 1] { new aiBone };
        from.mMeshes = new aiMesh *[from.mNumMeshes = 1] { mesh };
    }
};

TEST(PicturesOfMaterials, AreAskedForWhereAGreySurfaceNamesNone)
{
    const convert::Options options;
    for (const float red : {1.0f, 0.5f}) {
        const Skinned skinned({red, 1, 1, 1});
        convert::Scene scene{skinned.from, options, "person.b3d"};
        convert::add_materials(scene);
        ASSERT_EQ(scene.warnings.size(), red == 1 ? 1u : 0u);
        if (red == 1)
            EXPECT_EQ(scene.warnings[0],
                      "material 'material 1' is grey and without a picture: --picture FILE gives one");
    }
}

// Files with pictures have plain materials on purpose.
TEST(PicturesOfMaterials, AreAskedForOnlyWhereNoMaterialNamesOne)
{
    const convert::Options options;
    Skinned skinned({1, 1, 1, 1});
    auto *pictured = new aiMaterial;
    const aiString name("lost.png");
    pictured->AddProperty(&name, AI_MATKEY_TEXTURE_DIFFUSE(0));
    aiMaterial *const plain = skinned.from.mMaterials[0];
    delete[] skinned.from.mMaterials;
    skinned.from.mMaterials = new aiMaterial *[skinned.from.mNumMaterials = 2] { plain, pictured };
    convert::Scene scene{skinned.from, options, "person.b3d"};
    convert::add_materials(scene);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "the picture 'lost.png' is missing or no picture that is read: 'material 2' shows its base colour; "
              "--picture FILE gives them one");
}

TEST(PicturesOfMaterials, ThatAreMissingAreNamedOnceWithTheMaterialsThatLackThem)
{
    const convert::Options options;
    Skinned skinned({1, 1, 1, 1});
    const aiString name("lost.png");
    delete skinned.from.mMaterials[0];
    delete[] skinned.from.mMaterials;
    skinned.from.mMaterials = new aiMaterial *[skinned.from.mNumMaterials = 6];
    for (unsigned m = 0; m < 6; ++m) {
        skinned.from.mMaterials[m] = new aiMaterial;
        skinned.from.mMaterials[m]->AddProperty(&name, AI_MATKEY_TEXTURE_DIFFUSE(0));
    }
    convert::Scene scene{skinned.from, options, "person.b3d"};
    convert::add_materials(scene);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("'material 1', 'material 2', 'material 3', 'material 4' and 2 more show their "),
              std::string::npos)
        << scene.warnings[0];
}

TEST(PicturesOfMaterials, WithHolesAreTestedByAlpha)
{
    const std::string path = testing::TempDir() + "claque-holes.png";
    for (const int alpha : {127, 128}) {
        std::ofstream(path, std::ios::binary)
            << convert::png_of(std::string("\x10\x20\x30\xff\x10\x20\x30", 7) + static_cast<char>(alpha), 2, 1);
        convert::Options options;
        options.picture = path;
        const Skinned skinned({1, 1, 1, 1});
        convert::Scene scene{skinned.from, options, "person.b3d"};
        convert::add_materials(scene);
        const convert::Json &material = scene.glb.json["materials"][0];
        EXPECT_EQ(material.value("alphaMode", "OPAQUE"), alpha < 128 ? "MASK" : "OPAQUE");
        EXPECT_TRUE(scene.warnings.empty());
    }
}

}  // namespace
}  // namespace convert_test
