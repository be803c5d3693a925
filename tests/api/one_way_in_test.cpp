// A character of a file and a host's own arrays become the same Template, byte for byte; libraries of two builds share
// none.
#include <claque/assets.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>

#include "lib/api/model_entry.h"
#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "lib/figures/figure.h"
#include "tests/api/arrays_of_model.h"
#include "tests/support/written_characters.h"

namespace claque::test
{

namespace
{

const char *const characters[] = {"humanoids/kaykit/Barbarian.glb",       "humanoids/quaternius-modular/Man_Suit.glb",
                                  "humanoids/gdquest/gdbot.glb",          "humanoids/khronos/CesiumMan.glb",
                                  "machines/khronos/CesiumMilkTruck.glb", "animals/khronos/Fox.glb",
                                  "animals/quaternius/Spider.glb",        "conformance/khronos/MorphStressTest.glb"};

using Bytes = std::vector<uint8_t>;

int append(void *user, const void *bytes, size_t size)
{
    Bytes &out = *static_cast<Bytes *>(user);
    out.insert(out.end(), static_cast<const uint8_t *>(bytes), static_cast<const uint8_t *>(bytes) + size);
    return 0;
}

class OneWayIn : public testing::Test
{
protected:
    void SetUp() override { ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    void TearDown() override { EXPECT_EQ(clq_context_destroy(context_), CLQ_OK); }

    Bytes saved(const std::function<clq_status(clq_template **)> &build)
    {
        Bytes out;
        clq_template *tmpl = nullptr;
        EXPECT_EQ(build(&tmpl), CLQ_OK) << clq_last_error();
        if (!tmpl) return out;
        EXPECT_EQ(clq_template_save(tmpl, append, &out), CLQ_OK);
        clq_template_destroy(tmpl);
        return out;
    }

    Bytes of_arrays(const model::Model &model)
    {
        const ArraysOfModel arrays(model);
        return saved([&](clq_template **out) { return clq_template_build(context_, &arrays.def, out); });
    }

    Bytes of_asset(clq_asset *asset)
    {
        const Bytes out = saved([&](clq_template **tmpl) { return clq_asset_build(context_, asset, 0, tmpl); });
        clq_asset_destroy(asset);
        return out;
    }

    void expect_the_same_through_arrays(const std::string &name)
    {
        const std::string path = written::path_of(name, CLAQUE_ASSETS_DIR);
        clq_asset *loaded = nullptr;
        ASSERT_EQ(clq_asset_load_file(context_, path.c_str(), nullptr, &loaded), CLQ_OK) << clq_last_error();
        const Bytes bytes = of_asset(loaded);
        EXPECT_FALSE(bytes.empty());
        const std::vector<uint8_t> file = asset::read_file(path, 1u << 30);
        asset::LoadOptions options;
        options.base_folder = std::filesystem::path(path).parent_path().string();
        model::Model model = asset::load_gltf(file.data(), file.size(), options);
        if (model.name.empty()) model.name = std::filesystem::path(path).stem().string();
        // Arrays of hosts have neither emission nor materials without lighting.
        const bool is_lit = std::all_of(model.materials.begin(), model.materials.end(),
                                        [](const model::Material &one) { return one.lighting == model::Lighting(); });
        EXPECT_EQ(bytes == of_arrays(model), is_lit) << name;
    }

    clq_context *context_ = nullptr;
};

TEST_F(OneWayIn, ABuiltInFigureIsTheSameThroughArrays)
{
    for (const figures::Builtin &figure : figures::builtins()) {
        clq_asset *asset = nullptr;
        ASSERT_EQ(clq_asset_builtin(context_, figure.name, &asset), CLQ_OK) << clq_last_error();
        const Bytes bytes = of_asset(asset);
        EXPECT_FALSE(bytes.empty());
        EXPECT_TRUE(bytes == of_arrays(figure.make())) << figure.name;
    }
}

TEST_F(OneWayIn, ACharacterOfAFileIsTheSameThroughArrays)
{
    if (!std::filesystem::exists(CLAQUE_ASSETS_DIR "/inventory.json")) GTEST_SKIP() << "no ../shared/assets here";
    for (const char *const name : characters) expect_the_same_through_arrays(name);
}

TEST_F(OneWayIn, AWrittenCharacterIsTheSameThroughArrays)
{
    for (const std::string &name : written::characters()) expect_the_same_through_arrays(name);
}

// The model is not looked at where the ids differ: this one is of no kind at all.
TEST_F(OneWayIn, AModelOfAnotherBuildIsRefusedUnread)
{
    const char bytes[sizeof(model::Model)] = {};
    clq_template *tmpl = nullptr;
    const auto *model = reinterpret_cast<const model::Model *>(bytes);
    EXPECT_EQ(clq_private_template_from_model(context_, "another build", model, 0, &tmpl), CLQ_UNSUPPORTED);
    EXPECT_EQ(tmpl, nullptr);
    const std::string text = clq_last_error();
    EXPECT_NE(text.find("clq_asset_build: libclaque-assets (another build) and libclaque ("), std::string::npos)
        << text;
    EXPECT_NE(text.find("compiler"), std::string::npos) << text;
}

TEST_F(OneWayIn, AnEntryWithoutAModelIsRefused)
{
    clq_template *tmpl = nullptr;
    EXPECT_EQ(clq_private_template_from_model(context_, "", nullptr, 0, &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(clq_private_template_from_model(context_, nullptr, nullptr, 0, &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(clq_private_template_from_model(nullptr, "", nullptr, 0, &tmpl), CLQ_ARGUMENT);
}

}  // namespace

}  // namespace claque::test
