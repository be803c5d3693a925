// Saved crowds, as they are and with a corrected header: what restores can be saved, updated and drawn.
#include <algorithm>

#include "tests/api/saved_bytes.h"
#include "tests/api/stub_gl.h"
#include "tests/fuzz/fuzzer.h"

namespace
{

using namespace fuzzing;

void restore(TestWorld &world, const Bytes &bytes)
{
    clq_crowd *crowd = world.new_crowd();
    world.set_up(crowd);
    const uint64_t before = clq_crowd_get_hash(crowd);
    if (!done(clq_crowd_restore(crowd, bytes.data(), bytes.size(), world.templates, 2),
              {CLQ_ARGUMENT, CLQ_FORMAT, CLQ_LIMIT})) {
        EXPECT_EQ(clq_crowd_get_hash(crowd), before) << clq_last_error();
        return;
    }
    EXPECT_EQ(saved::save(crowd), bytes);
    clq_view *view = world.new_view(crowd, 0);
    clq_renderer *renderer = stub_gl::new_renderer(world);
    for (const double time_s : {0.0, 2.5, 1e6}) {
        EXPECT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_renderer_draw(renderer, view, nullptr), CLQ_OK) << clq_last_error();
    }
    EXPECT_EQ(clq_renderer_destroy(renderer), CLQ_OK) << clq_last_error();
    stub_gl::expect_balance();
    EXPECT_EQ(saved::save(crowd), bytes) << "an update must not change what a host has set";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0) return 0;
    static TestWorld &world = *new TestWorld;  // lives as long as the process
    Bytes file(bytes, bytes + size);
    const auto try_it = [&] {
        restore(world, file);
        for (clq_crowd *crowd : world.crowds) clq_crowd_destroy(crowd);
        world.crowds.clear();
    };
    try_it();
    if (size < saved::header_bytes) return 0;
    const Bytes before = file;
    static const Bytes &whole = *new Bytes(saved::save(world.new_crowd()));
    std::copy_n(whole.begin(), 16, file.begin());  // the form and its version
    saved::forge(file);
    if (file != before) try_it();
    return 0;
}
