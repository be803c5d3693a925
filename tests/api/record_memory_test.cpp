// Writers and memory that fail: the recording ends, and the crowd is as without it.
#include <algorithm>

#include "tests/api/failing_memory.h"
#include "tests/api/record_fixture.h"

namespace fm = failing_memory;

namespace
{

using records::Bytes;
using records::Player;
using records::Recording;
using records::Shown;

class RecordsThatFail : public testing::Test
{
protected:
    TestWorld world_;
};

TEST_F(RecordsThatFail, AWriterThatRefusesEndsTheRecordingOnly)
{
    const Recording good = records::run(world_, 12, 14, 1000);
    struct Writer {
        Bytes bytes;
        int left;
        static int take(void *user, const void *bytes, size_t size)
        {
            Writer &writer = *static_cast<Writer *>(user);
            return --writer.left < 0 ? 1 : records::keep(&writer.bytes, bytes, size);
        }
    };
    for (int left = 0; left < 16; ++left) {
        clq_crowd *crowd = world_.new_crowd();
        world_.set_up(crowd);
        std::vector<clq_actor> actors = world_.fill(crowd, 10, 14);
        Writer writer{{}, left};
        clq_recording_def def = clq_recording_def_init();
        def.write = Writer::take, def.user = &writer;
        const clq_status begun = clq_crowd_begin_recording(crowd, &def);
        EXPECT_EQ(begun, left < 2 ? CLQ_IO : CLQ_OK) << clq_last_error();
        if (begun != CLQ_OK) continue;
        for (uint32_t step = 0; step < 12; ++step) {
            world_.happen(crowd, actors, 14, step);
            ASSERT_EQ(clq_crowd_update(crowd, step, nullptr, 0), CLQ_OK) << clq_last_error();
        }
        clq_recording_info info = clq_recording_info_init();
        ASSERT_EQ(clq_crowd_get_recording(crowd, &info), CLQ_OK);
        const bool ended = left < 14;
        EXPECT_EQ(info.status, ended ? CLQ_IO : CLQ_OK) << left;
        EXPECT_EQ(std::string(info.text).find("the writer refused") != std::string::npos, ended) << info.text;
        EXPECT_EQ(clq_crowd_end_recording(crowd, &info), left < 15 ? CLQ_IO : CLQ_OK) << left;
        EXPECT_EQ(info.bytes, writer.bytes.size());
        EXPECT_GE(writer.left, -1) << "it is not asked again";
        clq_record *record = nullptr;
        ASSERT_EQ(clq_record_load(world_.context, writer.bytes.data(), writer.bytes.size(), &record), CLQ_OK);
        clq_record_info played = clq_record_info_init();
        EXPECT_EQ(clq_record_get_info(record, &played), CLQ_OK);
        EXPECT_EQ(played.step_count, std::min(12u, static_cast<unsigned>(left) - 2));
        EXPECT_EQ(played.whole, left == 15);
        clq_record_destroy(record);
    }
}

TEST_F(RecordsThatFail, AWriterThatThrowsOrCallsClaqueEndsTheRecordingOnly)
{
    clq_crowd *crowd = world_.new_crowd();
    clq_recording_def def = clq_recording_def_init();
    def.user = crowd;
    def.write = [](void *user, const void *, size_t) {
        return clq_crowd_update(static_cast<clq_crowd *>(user), 0, nullptr, 0) == CLQ_BUSY ? 0 : 1;
    };
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK);
    EXPECT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK) << clq_last_error();
    int pieces = 2;
    def.user = &pieces;
    def.write = [](void *user, const void *, size_t) -> int {
        if (--*static_cast<int *>(user) < 0) throw 7;
        return 0;
    };
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_update(crowd, 2, nullptr, 0), CLQ_OK) << clq_last_error();
    clq_recording_info info = clq_recording_info_init();
    EXPECT_EQ(clq_crowd_end_recording(crowd, &info), CLQ_CALLBACK);
    EXPECT_NE(std::string(info.text).find("threw an exception"), std::string::npos) << info.text;
}

TEST(RecordsWhereMemoryFails, EndOrAreWhole)
{
    clq_context_def context = clq_context_def_init();
    context.allocator = fm::allocator;
    {
        TestWorld world(&context);
        const Recording good = records::run(world, 12, 15, 1000);
        uint32_t ended = 0, refused = 0;
        for (uint64_t nth = 1; nth < 60; ++nth) {
            clq_crowd *crowd = nullptr;
            ASSERT_EQ(clq_crowd_create(world.context, nullptr, &crowd), CLQ_OK);
            world.set_up(crowd);
            std::vector<clq_actor> actors = world.fill(crowd, 10, 15);
            Bytes bytes;
            bytes.reserve(1000000);
            const clq_recording_def def = records::recording_to(bytes, 1000);
            fm::arm(nth, fm::Reach::everything, false);
            const clq_status begun = clq_crowd_begin_recording(crowd, &def);
            if (begun == CLQ_OK)
                for (uint32_t step = 0; step < 4; ++step) {
                    const clq_status followed = clq_actor_follow_track(crowd, actors[0], world.tracks[step % 2], step);
                    EXPECT_TRUE(followed != CLQ_BUSY) << clq_last_error();
                    clq_crowd_update(crowd, step, nullptr, 0);
                }
            fm::disarm();
            EXPECT_TRUE(begun == CLQ_OK || begun == CLQ_OUT_OF_MEMORY) << clq_last_error();
            refused += begun != CLQ_OK;
            clq_recording_info info = clq_recording_info_init();
            if (begun == CLQ_OK) {
                const clq_status status = clq_crowd_end_recording(crowd, &info);
                EXPECT_TRUE(status == CLQ_OK || status == CLQ_OUT_OF_MEMORY) << clq_last_error();
                ended += status != CLQ_OK;
                clq_record *record = nullptr;
                EXPECT_EQ(clq_record_load(world.context, bytes.data(), bytes.size(), &record), CLQ_OK)
                    << clq_last_error();
                clq_record_destroy(record);
            }
            EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
        }
        EXPECT_GT(refused, 3u);
        EXPECT_GE(ended, 1u);
    }
    EXPECT_EQ(fm::host_bytes(), 0);
}

TEST(RecordsWhereMemoryFails, ArePlayedAsSoonAsThereIsMemory)
{
    clq_context_def context = clq_context_def_init();
    context.allocator = fm::allocator;
    {
        TestWorld world(&context);
        const Recording run = records::run(world, 20, 16, 1000);
        uint32_t refused = 0;
        for (uint64_t nth = 1; nth < 400; nth += 1 + nth / 20) {
            Player player(world, run.bytes);
            Shown seen;
            player.show(2, seen);
            fm::arm(nth, fm::Reach::everything, nth % 2 == 0);
            const clq_status status = clq_record_play_step(player.record, player.crowd, nth % 3 ? 18 : 4);
            fm::disarm();
            EXPECT_TRUE(status == CLQ_OK || status == CLQ_OUT_OF_MEMORY) << clq_last_error();
            refused += status != CLQ_OK;
            player.show(18, seen);
            EXPECT_EQ(seen.lists[1], run.shown.lists[18]) << nth;
        }
        EXPECT_GT(refused, 10u);
        for (uint64_t nth = 1; nth < 300; nth += 1 + nth / 20) {
            clq_record *record = nullptr;
            fm::arm(nth, fm::Reach::everything, false);
            clq_status status = clq_record_load(world.context, run.bytes.data(), run.bytes.size(), &record);
            if (status == CLQ_OK) status = clq_record_set_templates(record, world.templates, 2);
            fm::disarm();
            EXPECT_TRUE(status == CLQ_OK || status == CLQ_OUT_OF_MEMORY) << clq_last_error();
            clq_record_destroy(record);
        }
    }
    EXPECT_EQ(fm::host_bytes(), 0);
}

}  // namespace
