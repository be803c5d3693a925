// Characters in one call: in levels of detail, and kept on disk.
#include <claque/levels.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/written_characters.h"

namespace
{

namespace fs = std::filesystem;
using Bytes = std::vector<char>;

Bytes read(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class OneCall : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("claque_one_call_") + test->name());
        fs::remove_all(folder_);
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
        clq_context_def def = clq_context_def_init();
        def.log.user = this;
        def.log.write = [](void *user, clq_log_level level, const char *text) {
            OneCall *self = static_cast<OneCall *>(user);
            if (level == CLQ_LOG_INFO) self->notes_.emplace_back(text);
            else self->log_ += text;
        };
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_context_destroy(context_);
        fs::remove_all(folder_);
    }

    // The bytes of the template, which is destroyed.
    Bytes saved(clq_template *tmpl)
    {
        Bytes bytes;
        if (!tmpl) return bytes;
        const auto append = [](void *user, const void *more, size_t size) {
            auto *all = static_cast<Bytes *>(user);
            all->insert(all->end(), static_cast<const char *>(more), static_cast<const char *>(more) + size);
            return 0;
        };
        EXPECT_EQ(clq_template_save(tmpl, append, &bytes), CLQ_OK);
        clq_template_destroy(tmpl);
        return bytes;
    }
    Bytes loaded(const Bytes &file, const clq_asset_options *options = nullptr)
    {
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_template_load_gltf(context_, file.data(), file.size(), options, &tmpl), CLQ_OK)
            << clq_last_error();
        return saved(tmpl);
    }
    // The same in several calls. `asset` is destroyed.
    Bytes built(clq_asset *asset, bool levels)
    {
        clq_template *tmpl = nullptr;
        if (levels) EXPECT_EQ(clq_asset_make_levels(context_, asset, nullptr, nullptr), CLQ_OK);
        EXPECT_EQ(clq_asset_build(context_, asset, 0, &tmpl), CLQ_OK);
        clq_asset_destroy(asset);
        return saved(tmpl);
    }
    size_t files() const
    {
        size_t count = 0;
        if (fs::exists(folder_ / "claque"))
            for (const auto &entry : fs::directory_iterator(folder_ / "claque")) count += entry.is_regular_file();
        return count;
    }
    // `count` triangles in one place, whose numbers are in a file beside the returned one.
    Bytes stack(size_t count)
    {
        fs::create_directories(folder_ / "in");
        const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        std::ofstream numbers(folder_ / "in" / "numbers.bin", std::ios::binary);
        numbers.write(reinterpret_cast<const char *>(corners), sizeof corners);
        for (uint16_t i = 0; i < 3 * count; ++i) numbers.put(static_cast<char>(i % 3)).put(0);
        const std::string indices = std::to_string(3 * count), size = std::to_string(6 * count);
        const std::string text =
            R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
            "buffers":[{"uri":"numbers.bin","byteLength":)" +
            std::to_string(36 + 6 * count) + R"(}],"bufferViews":[{"buffer":0,"byteLength":36},
            {"buffer":0,"byteOffset":36,"byteLength":)" +
            size + R"(}],"accessors":[
            {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
            {"bufferView":1,"componentType":5123,"count":)" +
            indices + R"(,"type":"SCALAR"}]})";
        return {text.begin(), text.end()};
    }
    clq_asset_options beside()
    {
        clq_asset_options options = clq_asset_options_init();
        text_ = (folder_ / "in").string();
        options.base_folder = text_.c_str();
        return options;
    }

    fs::path folder_;
    std::string text_, log_;
    std::vector<std::string> notes_;
    clq_context *context_ = nullptr;
};

}  // namespace

TEST_F(OneCall, GivesAFileLevelsOfDetailAndTakesItFromDiskNextTime)
{
    const Bytes file = read(written::path_of("WrittenPerson.glb", ""));
    const Bytes fresh = loaded(file);
    clq_asset *asset = nullptr;
    ASSERT_EQ(clq_asset_load(context_, file.data(), file.size(), nullptr, &asset), CLQ_OK);
    EXPECT_EQ(fresh, built(asset, true));
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(loaded(file), fresh);
    EXPECT_EQ(files(), 1u) << "the template was made anew under another name";
}

TEST_F(OneCall, GivesBuiltInCharactersLevelsOfDetailButThoseThatHaveThem)
{
    for (const char *name : {"citizen", "owl"}) {
        clq_template *tmpl = nullptr;
        clq_asset *asset = nullptr;
        ASSERT_EQ(clq_template_builtin(context_, name, &tmpl), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_asset_builtin(context_, name, &asset), CLQ_OK);
        EXPECT_EQ(saved(tmpl), built(asset, name == std::string("citizen"))) << name;
    }
    EXPECT_EQ(files(), 2u);
    EXPECT_EQ(log_, "");
}

TEST_F(OneCall, SaysInTheLogWhenLevelsBeginAndEndAndNothingWhereTheyComeFromDisk)
{
    const Bytes file = read(written::path_of("WrittenPerson.glb", ""));
    loaded(file);
    ASSERT_EQ(notes_.size(), 2u);
    EXPECT_EQ(notes_[0], "levels of detail of '': making them; triangles: 580");
    EXPECT_EQ(notes_[1].rfind("levels of detail of '': made: ", 0), 0u) << notes_[1];
    EXPECT_GT(std::stoi(notes_[1].substr(notes_[1].rfind(' '))), 3) << notes_[1];
    loaded(file);
    EXPECT_EQ(notes_.size(), 2u);
}

TEST_F(OneCall, MakesWhatItKeepsOfTheFilesBesideAndOfTheOptions)
{
    const Bytes file = stack(2);
    clq_asset_options options = beside();
    loaded(file, &options);
    EXPECT_EQ(files(), 1u);
    stack(3);  // writes other numbers beside the same text
    loaded(file, &options);
    EXPECT_EQ(files(), 2u) << "a file beside has changed";
    options.strict = true;
    loaded(file, &options);
    EXPECT_EQ(files(), 3u) << "the options have changed";
    options.colours = CLQ_COLOURS_WILD;
    loaded(file, &options);
    EXPECT_EQ(files(), 4u) << "the colours have changed";
    options.colours = CLQ_COLOURS_OWN;
    loaded(file, &options);
    EXPECT_EQ(files(), 5u) << "the colours have changed again";
}

TEST_F(OneCall, BuildsWithoutLevelsWhatIsRefusedLevels)
{
    const Bytes file = stack(1200);
    const clq_asset_options options = beside();
    clq_asset *asset = nullptr;
    ASSERT_EQ(clq_asset_load(context_, file.data(), file.size(), &options, &asset), CLQ_OK);
    EXPECT_EQ(loaded(file, &options), built(asset, false));
    EXPECT_NE(log_.find("no levels of detail: "), std::string::npos) << log_;
    ASSERT_EQ(notes_.size(), 2u);
    EXPECT_NE(notes_[1].find("made: 0"), std::string::npos) << notes_[1];
}

TEST_F(OneCall, WritesNothingAndFailsForAFileThatIsCutOff)
{
    const Bytes file = read(written::path_of("WrittenPerson.glb", ""));
    clq_template *tmpl = nullptr;
    EXPECT_EQ(clq_template_load_gltf(context_, file.data(), file.size() / 2, nullptr, &tmpl), CLQ_FORMAT);
    EXPECT_EQ(tmpl, nullptr);
    EXPECT_EQ(clq_template_builtin(context_, "nobody", &tmpl), CLQ_ARGUMENT);
    EXPECT_EQ(files(), 0u);
}

// As clq_template_prepare does, without a folder it makes the template in each call.
TEST_F(OneCall, NeedsNoFolder)
{
    setenv("XDG_CACHE_HOME", "", 1);
    const char *home = std::getenv("HOME");
    const std::string kept = home ? home : "";
    unsetenv("HOME");
    const Bytes file = stack(2);
    const clq_asset_options options = beside();
    EXPECT_FALSE(loaded(file, &options).empty());
    EXPECT_EQ(files(), 0u);
    if (home) setenv("HOME", kept.c_str(), 1);
}
