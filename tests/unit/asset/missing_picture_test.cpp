// Pictures whose files are missing.
#include "assets.h"

namespace claque::testing
{
namespace
{

struct MissingPicture : ::testing::Test {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / "claque-missing-XXXXXX";
    asset::LoadOptions options;
    Maker maker;

    void SetUp() override
    {
        std::string name = folder.string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        options.base_folder = name;
        maker.triangle();
        maker.add("images", {{"uri", "shirt.png"}});
        maker.add("textures", {{"source", 0}});
        maker.add("materials", {{"name", "Shirt"},
                                {"pbrMetallicRoughness",
                                 {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 0, 0, 1}}}}});
        maker.primitive()["material"] = 0;
        maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
};

TEST_F(MissingPicture, GivesAWarningAndTheBaseColour)
{
    const model::Model model = load(maker.glb(), options);
    EXPECT_EQ(model.images.size(), 0u);
    EXPECT_EQ(model.materials[0].image, model::none);
    EXPECT_EQ(model.materials[0].base_colour[0], 1);
    EXPECT_EQ(model.materials[0].base_colour[1], 0);
    EXPECT_NE(model.materials[0].zone, model::none);
    ASSERT_EQ(model.warnings.size(), 1u);
    for (const char *word : {"images[0]", "shirt.png", "base colour"})
        EXPECT_NE(model.warnings[0].find(word), std::string::npos) << model.warnings[0];
}

TEST_F(MissingPicture, OfTwoMaterialsGivesOneWarning)
{
    maker.json["materials"].push_back(maker.json["materials"][0]);
    maker.json["meshes"][0]["primitives"].push_back(maker.primitive());
    maker.json["meshes"][0]["primitives"][1]["material"] = 1;
    EXPECT_EQ(load(maker.glb(), options).warnings.size(), 1u);
}

TEST_F(MissingPicture, FailsWhereTheHostIsStrict)
{
    options.strict = true;
    const Outcome outcome = outcome_of(maker.glb(), options);
    EXPECT_EQ(outcome.status, CLQ_IO);
    EXPECT_NE(outcome.text.find("shirt.png"), std::string::npos) << outcome.text;
}

TEST_F(MissingPicture, OfAVariantLeavesTheMaterialsOwn)
{
    maker.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "winter"}}};
    maker.json["materials"].push_back(maker.json["materials"][0]);
    maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
    const model::Model model = load(maker.glb(), options);
    EXPECT_EQ(model.images.size(), 0u);
}

TEST_F(MissingPicture, IsNoExcuseForADamagedOneOrForLeavingTheFolder)
{
    std::ofstream(folder / "shirt.png") << "no picture";
    EXPECT_EQ(outcome_of(maker.glb(), options).status, CLQ_FORMAT);
    maker.json["images"][0]["uri"] = "../shirt.png";
    EXPECT_NE(outcome_of(maker.glb(), options).status, 0);
    maker.json["images"][0]["uri"] = "shirt.png";
    options.base_folder.clear();
    EXPECT_EQ(outcome_of(maker.glb(), options).status, CLQ_IO) << "the host gave no folder";
}

}  // namespace
}  // namespace claque::testing
