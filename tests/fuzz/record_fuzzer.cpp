// Records, as they are and with corrected checks: what opens can be played, to any step, and leaves a good crowd.
#include <algorithm>

#include "lib/record/format.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"
#include "tests/fuzz/fuzzer.h"

namespace
{

namespace format = claque::record;
using namespace fuzzing;

void play(TestWorld &world, clq_record *record, uint64_t steps)
{
    clq_crowd *crowd = world.new_crowd();
    clq_view *view = world.new_view(crowd, 0);
    const uint64_t wanted[] = {0, steps / 2, steps, steps / 3, steps};
    for (const uint64_t step : wanted) {
        if (!done(clq_record_play_step(record, crowd, step), {CLQ_ARGUMENT, CLQ_FORMAT})) continue;
        double time_s = 3;
        if (step < steps) clq_record_get_time(record, step, &time_s);
        EXPECT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
    }
    const Bytes saved = saved::save(crowd);
    EXPECT_EQ(clq_crowd_restore(crowd, saved.data(), saved.size(), world.templates, 2), CLQ_OK) << clq_last_error();
    EXPECT_EQ(saved::save(crowd), saved);
}

using Opening = decltype(clq_record_load) *;

void open(TestWorld &world, const Bytes &bytes, Opening opening)
{
    clq_record *record = nullptr;
    if (!done(opening(world.context, bytes.data(), bytes.size(), &record), {CLQ_FORMAT})) return;
    clq_record_info info = clq_record_info_init();
    EXPECT_EQ(clq_record_get_info(record, &info), CLQ_OK);
    EXPECT_GE(info.end_s, info.start_s);
    clq_crowd_def def = clq_crowd_def_init();
    EXPECT_EQ(clq_record_get_crowd_def(record, &def), CLQ_OK);
    clq_crowd *like = nullptr;
    if (done(clq_crowd_create(world.context, &def, &like), {CLQ_ARGUMENT})) clq_crowd_destroy(like);
    const clq_host_mechanism_def lent = {world.mechanism(TestWorld::host).host.run, nullptr, false};
    EXPECT_EQ(clq_record_lend_mechanism(record, {TestWorld::host + 1}, &lent), CLQ_OK);
    if (done(clq_record_set_templates(record, world.templates, 2), {CLQ_ARGUMENT, CLQ_FORMAT}))
        play(world, record, info.step_count);
    clq_record_destroy(record);
    for (clq_crowd *crowd : world.crowds) EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
    world.crowds.clear();
}

// Blocks of the sizes that the bytes say, as far as they go, with their numbers and checks.
void correct(Bytes &bytes)
{
    std::copy(std::begin(format::magic), std::end(format::magic), bytes.begin());
    saved::put(bytes, 8, format::version, 4), saved::put(bytes, 12, 0, 4);
    uint64_t number = 0;
    for (size_t at = format::file_header_bytes; bytes.size() - at >= format::block_header_bytes; ++number) {
        size_t size = 0;
        for (size_t i = 0; i < 4; ++i) size |= size_t(bytes[at + i]) << (8 * i);
        size = std::min(size, bytes.size() - at - format::block_header_bytes);
        const uint8_t *contents = bytes.data() + at + format::block_header_bytes;
        const uint64_t checksum = format::checksum_of(contents, static_cast<uint32_t>(size), number);
        saved::put(bytes, at, size, 4);
        saved::put(bytes, at + 4, format::check_of_header(static_cast<uint32_t>(size), checksum, number), 4);
        saved::put(bytes, at + 8, checksum, 8);
        at += format::block_header_bytes + size;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0) return 0;
    static TestWorld &world = *new TestWorld;  // lives as long as the process
    Bytes file(bytes, bytes + size);
    for (const Opening opening : {clq_record_load, clq_record_open}) open(world, file, opening);
    if (size < format::file_header_bytes) return 0;
    const Bytes before = file;
    correct(file);
    if (file == before) return 0;
    for (const Opening opening : {clq_record_load, clq_record_open}) open(world, file, opening);
    return 0;
}
