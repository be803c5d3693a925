// A picture whose file is missing, through the C API: as a warning, as an error, and for hosts of earlier headers.
#include <claque/prepare.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace
{

namespace fs = std::filesystem;

struct End {
    void operator()(clq_context *context) const { clq_context_destroy(context); }
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
    void operator()(clq_template *tmpl) const { clq_template_destroy(tmpl); }
};

// One triangle in a data URI: three positions, three texture coordinates.
constexpr const char *triangle = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"name":"Shirt","pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,0,0,1]}}],
"textures":[{"source":0}],"images":[{"uri":"shirt.png"}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
{"bufferView":1,"componentType":5126,"type":"VEC2","count":3}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)"
                                 "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
                                 "AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/"
                                 R"("}]})";

class Strict : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("claque_strict_") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(path()) << triangle;
        clq_context *context = nullptr;
        ASSERT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
        context_.reset(context);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path() const { return (folder_ / "triangle.gltf").string(); }

    clq_status load(const clq_asset_options *options)
    {
        clq_asset *asset = nullptr;
        const clq_status status = clq_asset_load_file(context_.get(), path().c_str(), options, &asset);
        asset_.reset(asset);
        return status;
    }

    fs::path folder_;
    std::unique_ptr<clq_context, End> context_;
    std::unique_ptr<clq_asset, End> asset_;
};

TEST_F(Strict, AMissingPictureIsAWarningOrAnErrorAsTheHostSays)
{
    clq_asset_options options = clq_asset_options_init();
    ASSERT_EQ(load(&options), CLQ_OK) << clq_last_error();
    EXPECT_NE(std::string(clq_asset_get_warning(asset_.get(), 0)).find("shirt.png"), std::string::npos);
    options.strict = true;
    EXPECT_EQ(load(&options), CLQ_IO);
    EXPECT_NE(std::string(clq_last_error()).find("shirt.png"), std::string::npos) << clq_last_error();
}

TEST_F(Strict, HostsOfEarlierHeadersPassShorterOptions)
{
    clq_asset_options options = clq_asset_options_init();
    options.strict = true;  // what lies behind a shorter struct does not count
    options.struct_bytes = offsetof(clq_asset_options, strict);
    EXPECT_EQ(load(&options), CLQ_OK) << clq_last_error();
    options.struct_bytes -= 4;
    EXPECT_EQ(load(&options), CLQ_STRUCT_SIZE);
    options.struct_bytes = offsetof(clq_asset_options, turn_deg);
    options.turn_deg = HUGE_VAL;
    EXPECT_EQ(load(&options), CLQ_IO) << "strict counts, and no turn: " << clq_last_error();
}

TEST_F(Strict, APreparedTemplateIsNotTakenWhereItsPictureIsMissing)
{
    const std::string cache = (folder_ / "cache").string();
    clq_asset_options options = clq_asset_options_init();
    clq_prepare_def def = clq_prepare_def_init();
    const std::string file = path();
    def.path = file.c_str();
    def.options = &options;
    def.folder = cache.c_str();
    clq_template *made = nullptr;
    ASSERT_EQ(clq_template_prepare(context_.get(), &def, &made, nullptr), CLQ_OK) << clq_last_error();
    const std::unique_ptr<clq_template, End> owner(made);
    options.strict = true;
    EXPECT_EQ(clq_template_prepare(context_.get(), &def, &made, nullptr), CLQ_IO);
}

}  // namespace
