// The law of the split: loading and building take at most 64 times what was read and 16 MB.
#include "meshsplit/build.h"

#include <gtest/gtest.h>

#include "../asset/heap_meter.h"
#include "attacks.h"
#include "lib/pose/pose.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t mega = 1u << 20;

struct Built {
    uint64_t peak = 0, work = 0, source = 0;
    Outcome outcome;
    std::unique_ptr<model::Template> made = std::make_unique<model::Template>(std::pmr::get_default_resource());
};

Built build(const Bytes &bytes)
{
    Built out;
    out.peak = peak_heap_bytes([&] {
        out.work = blocks_entered([&] {
            out.outcome = outcome_of([&] {
                const model::Model model = load(bytes);
                out.source = model.source_bytes;
                meshsplit::build(model, {}, *out.made);
            });
        });
    });
    return out;
}

void expect_lawful(const Built &built, const Bytes &bytes, const char *what)
{
    const uint64_t read = std::max<uint64_t>(built.source, bytes.size());
    EXPECT_LE(built.peak, 64 * read + 16 * mega) << what << ": " << built.outcome.text;
    // What any file may take, and for each byte as much as evaluating four transforms.
    EXPECT_LE(built.work, (1ull << 30) + 4096 * read) << what;
    ::testing::Test::RecordProperty(what, std::to_string(built.peak) + " bytes, " + std::to_string(built.work));
}

// The farthest that a node's origin is from where the channels put it.
double worst_error(const model::Template &tmpl, uint32_t clip, double time_s)
{
    pose::Workspace exact(tmpl.rig), shown(tmpl.rig, &tmpl.motion);
    const auto a = exact.pose(clip, time_s), b = shown.pose(clip, time_s);
    double most = 0;
    for (uint32_t i = 0; i < a.count; ++i)
        for (size_t k = 0; k < 12; ++k) most = std::max(most, std::fabs(double(a[i].c[k]) - double(b[i].c[k])));
    return most;
}

TEST(BuildWork, HoursOfMotionOfManyNodesKeepTheirChannels)
{
    const Bytes bytes = long_clips(300, 1, 4000);
    const Built built = build(bytes);
    ASSERT_EQ(built.outcome.status, 0) << built.outcome.text;
    expect_lawful(built, bytes, "hours");
    for (const double time : {0.0, 0.0005, 0.001, 0.7, 1999.5, 3999.0, 4000.0})
        EXPECT_LE(worst_error(*built.made, 0, time), 1e-5) << time;
}

TEST(BuildWork, FiveHundredClipsKeepTheirChannels)
{
    const Bytes bytes = long_clips(3, 500, 4000);
    const Built built = build(bytes);
    ASSERT_EQ(built.outcome.status, 0) << built.outcome.text;
    expect_lawful(built, bytes, "clips");
    for (const uint32_t clip : {0u, 250u, 499u})
        for (const double time : {0.0005, 0.7, 1999.5}) EXPECT_LE(worst_error(*built.made, clip, time), 2e-3) << time;
}

// Every pose could move any corner farthest. What is skinned to find out is bounded, and so is the list of poses.
TEST(BuildWork, WheelsThatTurnForMinutesOrForAgesHaveASphere)
{
    for (const float length_s : {400.0f, 1000.0f, 3e38f}) {
        SCOPED_TRACE(length_s);
        const Bytes bytes = turning_wheels(3, 1500, length_s);
        const Built built = build(bytes);
        ASSERT_EQ(built.outcome.status, 0) << built.outcome.text;
        expect_lawful(built, bytes, length_s < 500 ? "minutes" : length_s < 1e4f ? "a quarter of an hour" : "ages");
        EXPECT_EQ(built.work > 1u << 26, length_s < 500) << "searches that would be given up are not begun";
        const model::Sphere &sphere = built.made->sklsroot;
        EXPECT_NEAR(sphere.radius, 5.5, 2);
        for (const float x : {2.0f, 10.0f}) EXPECT_LE(glm::distance(sphere.centre, glm::vec3(x, 0, 0)), sphere.radius);
    }
}

TEST(BuildWork, SpheresThatFollowFromLengthsHoldEveryPose)
{
    const Bytes bytes = long_clips(300, 1, 4000);
    const Built built = build(bytes);
    ASSERT_EQ(built.outcome.status, 0) << built.outcome.text;
    const model::Template &t = *built.made;
    pose::Workspace workspace(t.rig);
    for (int i = 0; i <= 1000; ++i) {
        const auto palette = workspace.pose(0, i < 20 ? i * 1e-4 : i * 4.0);
        for (uint32_t v = 0; v < t.levels[0].source_count; ++v) {
            const float *p = t.levels[0].positions.data() + 3 * size_t(v);
            const glm::vec3 at = math::transform_point(palette[t.levels[0].joints[v]], glm::vec3(p[0], p[1], p[2]));
            ASSERT_LE(glm::distance(at, t.sklsroot.centre), t.sklsroot.radius) << i;
        }
        for (uint32_t n = 0; n < t.rig.node_count(); ++n)
            ASSERT_LE(glm::distance(glm::vec3(workspace.locals()[n].translation), t.sklsroot.centre),
                      t.node_reach[n].distance);
    }
}

TEST(BuildWork, ChannelsThatShareKeysAreRefusedWithNumbers)
{
    const Bytes bytes = shared_keys(3000);
    const Built built = build(bytes);
    expect_lawful(built, bytes, "shared keys");
    EXPECT_EQ(built.outcome.status, CLQ_LIMIT);
    EXPECT_NE(built.outcome.text.find("keys of their own would take"), std::string::npos) << built.outcome.text;
}

TEST(BuildWork, ImagesInManyColoursAreRefusedWithNumbers)
{
    const Bytes bytes = tinted_images(2000, 256);
    const Built built = build(bytes);
    expect_lawful(built, bytes, "tinted images");
    EXPECT_EQ(built.outcome.status, CLQ_LIMIT);
    EXPECT_NE(built.outcome.text.find("the textures would take"), std::string::npos) << built.outcome.text;
}

TEST(BuildWork, RootMotionOfDaysIsRefusedWithNumbers)
{
    const Bytes bytes = long_root_motion(1e6f);
    const Built built = build(bytes);
    expect_lawful(built, bytes, "root motion");
    EXPECT_EQ(built.outcome.status, CLQ_LIMIT);
    EXPECT_NE(built.outcome.text.find("root motion at 60 Hz would take"), std::string::npos) << built.outcome.text;
}

}  // namespace
}  // namespace claque::testing
