// Resampled clips take no more memory and no more poses than they were given; the others keep their channels.
#include "meshsplit/motion.h"

#include <gtest/gtest.h>

#include "../asset/heap_meter.h"
#include "attacks.h"
#include "meshsplit/build.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

// What resampling under these limits takes of a character whose clips have no rows yet.
struct Resampled {
    uint64_t work = 0, peak = 0;
    size_t clips = 0, rows = 0;
};

Resampled resample(const Bytes &bytes, const meshsplit::MotionLimits &limits)
{
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::BuildOptions options;
    options.motion.metres = 0;
    meshsplit::build(load(bytes), options, tmpl);
    EXPECT_EQ(tmpl.motion.clips.size(), 0u);
    Resampled out;
    out.peak = peak_heap_bytes([&] { out.work = blocks_entered([&] { meshsplit::make_motion({}, tmpl, limits); }); });
    out.clips = tmpl.motion.clips.size();
    for (const model::MotionClip &clip : tmpl.motion.clips) out.rows += clip.intervals;
    return out;
}

constexpr uint64_t plenty = 1ull << 40;

TEST(MotionWork, IsBoundedByThePosesThatMayBeMeasured)
{
    const Bytes bytes = long_clips(3, 40, 100);
    for (const uint64_t transforms : {1u << 16, 1u << 18, 1u << 20}) {
        const Resampled made = resample(bytes, {plenty, transforms});
        EXPECT_EQ(made.clips, 40u);
        EXPECT_LE(made.work, (1u << 20) + 100 * transforms) << transforms;
        RecordProperty("work of " + std::to_string(transforms), std::to_string(made.work));
    }
}

TEST(MotionWork, TakesNoMoreMemoryThanItsRowsMay)
{
    const Bytes bytes = long_clips(30, 4, 100);
    for (const uint64_t limit : {1u << 18, 1u << 20, 4u << 20}) {
        const Resampled made = resample(bytes, {limit, plenty});
        EXPECT_LE(made.peak, limit + (1u << 18)) << limit;
        RecordProperty("peak of " + std::to_string(limit), std::to_string(made.peak));
    }
}

// A place of each clip for each moved node, without any row.
TEST(MotionWork, HasNoPlacesForMoreClipsThanItsMemoryHolds)
{
    const Bytes bytes = clips_of_a_node_each(400);
    const Resampled all = resample(bytes, {plenty, plenty}), none = resample(bytes, {1u << 20, plenty});
    EXPECT_EQ(all.clips, 400u);
    EXPECT_GT(all.peak, 2u << 20);
    EXPECT_EQ(none.clips, 0u);
    EXPECT_LE(none.peak, 1u << 20);
}

}  // namespace
}  // namespace claque::testing
