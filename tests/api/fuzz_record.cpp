// What random calls made is made again by the record of them, in sequence and from any step.
#include <claque/record.h>

#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::record()
{
    clq_recording_def def = clq_recording_def_init();
    def.user = &recorded_;
    def.key_bytes = 2000;
    def.write = [](void *user, const void *bytes, size_t size) {
        const uint8_t *first = static_cast<const uint8_t *>(bytes);
        static_cast<saved::Bytes *>(user)->insert(static_cast<saved::Bytes *>(user)->end(), first, first + size);
        return 0;
    };
    EXPECT_EQ(clq_crowd_begin_recording(crowd_, &def), CLQ_OK) << clq_last_error();
}

void World::replay()
{
    clq_recording_info written = clq_recording_info_init();
    EXPECT_EQ(clq_crowd_end_recording(crowd_, &written), CLQ_OK) << clq_last_error();
    EXPECT_EQ(written.steps, step_hashes_.size());
    clq_record *record = nullptr;
    const auto opening = seed_ % 2 ? clq_record_open : clq_record_load;
    ASSERT_EQ(opening(test_world_.context, recorded_.data(), recorded_.size(), &record), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_record_set_templates(record, templates_, 4), CLQ_OK) << clq_last_error();
    const clq_host_mechanism_def lent = {test_world_.mechanism(TestWorld::host).host.run, nullptr, false};
    for (uint32_t number = 1; number < 100; ++number)
        EXPECT_EQ(clq_record_lend_mechanism(record, {number}, &lent), CLQ_OK);
    clq_crowd *crowd = nullptr;
    EXPECT_EQ(clq_crowd_create(test_world_.context, nullptr, &crowd), CLQ_OK);
    const auto show = [&](uint64_t step) {
        ASSERT_EQ(clq_record_play_step(record, crowd, step), CLQ_OK) << "seed " << seed_ << ": " << clq_last_error();
        if (step < step_hashes_.size()) {
            EXPECT_EQ(clq_crowd_get_hash(crowd), step_hashes_[step]) << "seed " << seed_ << ", update " << step;
        }
    };
    for (uint64_t step = 0; step <= step_hashes_.size() && !testing::Test::HasFailure(); ++step) show(step);
    EXPECT_EQ(clq_crowd_get_hash(crowd), clq_crowd_get_hash(crowd_)) << "seed " << seed_;
    for (uint32_t k = 0; k < 20 && !step_hashes_.empty(); ++k) show(mixed(seed_, k) % step_hashes_.size());
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
    clq_record_destroy(record);
}

}  // namespace fuzz
