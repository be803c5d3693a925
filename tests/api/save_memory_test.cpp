// Saving needs no memory; restoring without memory changes nothing.
#include "tests/api/failing_memory.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace fm = failing_memory;

TEST(SaveMemory, SavingAndHashingAllocateNothing)
{
    TestWorld test_world;
    clq_crowd *crowd = test_world.new_crowd();
    test_world.set_up(crowd);
    test_world.fill(crowd, 30, 1);
    const auto forget = [](void *, const void *, size_t) { return 0; };
    fm::arm(0, fm::Reach::everything);
    const clq_status status = clq_crowd_save(crowd, forget, nullptr);
    clq_crowd_get_hash(crowd);
    EXPECT_EQ(fm::disarm(), 0u);
    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
}

TEST(SaveMemory, RestoringFailsCleanlyAtEveryAllocation)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = fm::allocator;
    {
        TestWorld test_world(&def);
        clq_crowd *from = test_world.new_crowd(), *to = test_world.new_crowd();
        test_world.set_up(from);
        test_world.fill(from, 20, 1);
        const saved::Bytes bytes = saved::save(from);
        test_world.set_up(to);
        std::vector<clq_actor> people = test_world.fill(to, 12, 2);
        // Restored hooks need memory as well.
        const clq_actor_hooks hooks = {[](void *, clq_actor) { return false; }, nullptr, nullptr};
        for (const clq_actor actor : people) ASSERT_EQ(clq_actor_set_hooks(to, actor, &hooks), CLQ_OK);
        clq_view *view = test_world.new_view(to, 0);
        ASSERT_EQ(clq_crowd_update(to, 1, &view, 1), CLQ_OK);
        const uint64_t shown = clq_view_get_hash(view);
        const saved::Bytes before = saved::save(to);
        uint64_t n = 1;
        for (;; ++n) {
            const int64_t held = fm::host_bytes();
            fm::arm(n, fm::Reach::everything);
            const clq_status status = clq_crowd_restore(to, bytes.data(), bytes.size(), test_world.templates, 2);
            if (fm::disarm() < n) {
                EXPECT_EQ(status, CLQ_OK) << clq_last_error();
                break;
            }
            ASSERT_EQ(status, CLQ_OUT_OF_MEMORY) << n;
            ASSERT_EQ(saved::save(to), before) << n;
            ASSERT_EQ(fm::host_bytes(), held) << n;
        }
        EXPECT_GT(n, 20u);
        EXPECT_EQ(saved::save(to), bytes);
        EXPECT_EQ(clq_view_get_hash(view), shown);
        for (int i = 0; i < 200; ++i)
            ASSERT_EQ(clq_crowd_restore(to, bytes.data(), bytes.size(), test_world.templates, 2), CLQ_OK);
        const int64_t held = fm::host_bytes();
        for (int i = 0; i < 200; ++i)
            ASSERT_EQ(clq_crowd_restore(to, bytes.data(), bytes.size(), test_world.templates, 2), CLQ_OK);
        EXPECT_EQ(fm::host_bytes(), held) << "repeated restoring keeps no memory";
    }
    EXPECT_EQ(fm::host_bytes(), 0);
}
