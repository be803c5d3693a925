// The list of a template's key-poses is bounded, however long its clips last.
#include <gtest/gtest.h>

#include "animcache/keyposes.h"
#include "lib/figures/figure.h"
#include "meshsplit/build.h"

namespace claque::animcache
{
namespace
{

class KeyPoseTableOf : public ::testing::Test
{
protected:
    KeyPoseTableOf() : tmpl_(std::pmr::get_default_resource())
    {
        meshsplit::BuildOptions options;
        options.max_texture_px = 16;
        meshsplit::build(figures::people()[0].make(), options, tmpl_);
    }
    KeyPoseTable table() const { return {std::pmr::get_default_resource(), tmpl_, 15}; }
    uint32_t clip_count() const { return static_cast<uint32_t>(tmpl_.rig.clips.size()); }

    model::Template tmpl_;
};

}  // namespace

TEST_F(KeyPoseTableOf, ClipsOfSecondsHasTheRateThatIsAskedFor)
{
    double seconds = 0;
    for (const model::Clip &clip : tmpl_.rig.clips) seconds += double(clip.duration_s);
    EXPECT_NEAR(table().count(), 15 * seconds, clip_count());
}

TEST_F(KeyPoseTableOf, ClipsOfHoursAndOfAgesHasFewerASecond)
{
    for (const float length_s : {3600.0f, 1e6f, 3e38f}) {
        SCOPED_TRACE(length_s);
        for (uint32_t clip = 0; clip < 4; ++clip) tmpl_.rig.clips[clip].duration_s = length_s;
        const KeyPoseTable made = table();
        EXPECT_LE(made.count(), KeyPoseTable::max_intervals + 2 * clip_count());
        EXPECT_GE(made.count(), KeyPoseTable::max_intervals - 2 * clip_count());
        const double start_s = double(tmpl_.rig.clips[3].start_s), between_s = 4 * double(length_s) / made.count();
        for (const double share : {0.0, 0.3, 0.9999}) {
            const double time_s = start_s + share * double(length_s);
            const KeyPoseSelection shown = made.select(KeyPoseMode::interpolated, 3, time_s);
            EXPECT_NEAR(shown.time_s[0], time_s, 1.01 * between_s);
            EXPECT_NEAR(shown.time_s[1] - shown.time_s[0], between_s, 0.01 * between_s);
            EXPECT_LT(shown.second, made.count());
        }
    }
}

TEST_F(KeyPoseTableOf, ClipsOfAgesIsKeptInLittleMemory)
{
    for (model::Clip &clip : tmpl_.rig.clips) clip.duration_s = 3e38f;
    KeyPoseSettings settings;
    settings.bands[0].mode = KeyPoseMode::interpolated;
    settings.band_count = 1;
    KeyPoses all(std::pmr::get_default_resource(), settings, VertexFormat::floats);
    const model::Template *templates[] = {&tmpl_};
    all.reserve(10, {templates, 1});
    EXPECT_LE(all.book_bytes(), uint64_t(32) << 20);
}

}  // namespace claque::animcache
