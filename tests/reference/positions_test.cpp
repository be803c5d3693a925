// Every collected and every written character in every clip: the library's positions against the reference's.
#include <claque/assets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "tests/reference/asset_files.h"
#include "tests/reference/comparison.h"
#include "tests/support/written_characters.h"

namespace claque::reference
{
namespace
{

constexpr size_t clips_per_file = 12;

struct Destroy {
    void operator()(clq_context *context) const { clq_context_destroy(context); }
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
};

class PositionsOfFiles : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        if (GetParam().empty())
            GTEST_SKIP() << "no folder " << CLAQUE_ASSETS_DIR << ": collected characters are not compared";
        clq_context *context = nullptr;
        ASSERT_EQ(CLQ_OK, clq_context_create(nullptr, &context)) << clq_last_error();
        context_.reset(context);
    }

    clq_status load()
    {
        clq_asset *asset = nullptr;
        const clq_status status = clq_asset_load_file(context_.get(), path().c_str(), nullptr, &asset);
        asset_.reset(asset);
        return status;
    }

    std::string path() const { return written::path_of(GetParam(), assets_folder()); }

    void expect_same(const Character &character, size_t clip, double time_s, double size) const
    {
        std::vector<float> actual(3 * character.vertex_count() + 1);
        const uint32_t number = clip == rest ? CLQ_NONE : static_cast<uint32_t>(clip);
        const float time = static_cast<float>(time_s);
        ASSERT_EQ(CLQ_OK, clq_asset_get_positions(asset_.get(), number, time, actual.data(), actual.size()))
            << clq_last_error();
        actual.pop_back();
        const Comparison comparison = compare(evaluate(character, clip, time).positions, actual, size);
        EXPECT_TRUE(comparison.same) << GetParam() << " clip " << (clip == rest ? "none" : character.clips[clip].name)
                                     << " at " << time << " s: " << comparison.text;
    }

    std::unique_ptr<clq_context, Destroy> context_;
    std::unique_ptr<clq_asset, Destroy> asset_;
};

// Ends, odd fractions between, and both sides beyond.
std::array<double, 7> times_of(const Clip &clip)
{
    const double span = clip.last_s - clip.first_s;
    return {clip.first_s - 0.35,
            clip.first_s,
            clip.first_s + 0.137 * span,
            clip.first_s + 0.5 * span,
            clip.first_s + 0.7391 * span,
            clip.last_s,
            clip.last_s + 1.7};
}

TEST_P(PositionsOfFiles, AreThoseOfTheReferenceInEveryPose)
{
    ASSERT_EQ(CLQ_OK, load()) << clq_last_error();
    const Character character = load_character(path());
    clq_asset_info info = clq_asset_info_init();
    ASSERT_EQ(CLQ_OK, clq_asset_get_info(asset_.get(), &info));
    ASSERT_EQ(character.parts.size(), info.part_count);
    ASSERT_EQ(character.vertex_count(), info.vertex_count);
    ASSERT_EQ(character.clips.size(), info.clip_count);

    const double size = size_of(character);
    expect_same(character, rest, 0, size);
    const size_t shown = std::min(character.clips.size(), clips_per_file);
    for (size_t i = 0; i < shown; ++i) {
        const size_t clip = i * character.clips.size() / shown;
        for (const double time_s : times_of(character.clips[clip])) expect_same(character, clip, time_s, size);
        if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
}

TEST_P(PositionsOfFiles, ClipsStartAndEndWhereTheReferenceSays)
{
    ASSERT_EQ(CLQ_OK, load()) << clq_last_error();
    const Character character = load_character(path());
    for (size_t i = 0; i < character.clips.size(); ++i) {
        clq_clip_info info = clq_clip_info_init();
        ASSERT_EQ(CLQ_OK, clq_asset_get_clip(asset_.get(), static_cast<uint32_t>(i), &info)) << clq_last_error();
        const Clip &clip = character.clips[i];
        EXPECT_NEAR(clip.first_s, info.start_s, 1e-5) << clip.name;
        EXPECT_NEAR(clip.last_s - clip.first_s, info.duration_s, 1e-5) << clip.name;
        if (!clip.name.empty()) {
            EXPECT_EQ(clip.name, info.name);
        }
    }
}

using RefusedFiles = PositionsOfFiles;

TEST_P(RefusedFiles, AreRefusedForTheReasonThatHoldsForThem)
{
    const Refusal *refusal = refusal_of(GetParam());
    EXPECT_EQ(refusal->status, load()) << clq_last_error();
    EXPECT_EQ(nullptr, asset_.get());
    EXPECT_NE(std::string::npos, std::string(clq_last_error()).find(refusal->named)) << clq_last_error();
}

INSTANTIATE_TEST_SUITE_P(Assets, PositionsOfFiles, testing::ValuesIn(loadable_files()),
                         [](const auto &parameter) { return case_name(parameter.param); });

INSTANTIATE_TEST_SUITE_P(Written, PositionsOfFiles, testing::ValuesIn(written::files()),
                         [](const auto &parameter) { return case_name(parameter.param); });

INSTANTIATE_TEST_SUITE_P(Written, RefusedFiles, testing::ValuesIn(written::refused()),
                         [](const auto &parameter) { return case_name(parameter.param); });

INSTANTIATE_TEST_SUITE_P(Assets, RefusedFiles, testing::ValuesIn(refused_files()),
                         [](const auto &parameter) { return case_name(parameter.param); });

}  // namespace
}  // namespace claque::reference
