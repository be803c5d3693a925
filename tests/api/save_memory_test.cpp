// Saving asks for no memory; restoring that finds none changes nothing.
#include "tests/api/failing_memory.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/stage.h"

namespace fm = failing_memory;

TEST(save_memory, saving_and_the_fingerprint_ask_for_none)
{
    Stage stage;
    clq_crowd *crowd = stage.new_crowd();
    stage.set_up(crowd);
    stage.fill(crowd, 30, 1);
    const auto forget = [](void *, const void *, size_t) { return 0; };
    fm::arm(0, fm::Reach::everything);
    const clq_status status = clq_crowd_save(crowd, forget, nullptr);
    clq_crowd_fingerprint(crowd);
    EXPECT_EQ(fm::disarm(), 0u);
    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
}

TEST(save_memory, restoring_fails_cleanly_at_every_allocation)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = fm::allocator;
    {
        Stage stage(&def);
        clq_crowd *from = stage.new_crowd(), *to = stage.new_crowd();
        stage.set_up(from);
        stage.fill(from, 20, 1);
        const saved::Bytes bytes = saved::save(from);
        stage.set_up(to);
        std::vector<clq_actor> people = stage.fill(to, 12, 2);
        // Hooks that have to be taken over ask for memory as well.
        const clq_actor_hooks hooks = {[](void *, clq_actor) { return 0; }, nullptr, nullptr};
        for (const clq_actor actor : people) ASSERT_EQ(clq_actor_set_hooks(to, actor, &hooks), CLQ_OK);
        clq_view *view = stage.new_view(to, 0);
        ASSERT_EQ(clq_crowd_update(to, 1, &view, 1), CLQ_OK);
        const uint64_t shown = clq_view_hash(view);
        const saved::Bytes before = saved::save(to);
        uint64_t n = 1;
        for (;; ++n) {
            const int64_t held = fm::host_bytes();
            fm::arm(n, fm::Reach::everything);
            const clq_status status = clq_crowd_restore(to, bytes.data(), bytes.size(), stage.templates, 2);
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
        EXPECT_EQ(clq_view_hash(view), shown);
        for (int i = 0; i < 200; ++i)
            ASSERT_EQ(clq_crowd_restore(to, bytes.data(), bytes.size(), stage.templates, 2), CLQ_OK);
        const int64_t held = fm::host_bytes();
        for (int i = 0; i < 200; ++i)
            ASSERT_EQ(clq_crowd_restore(to, bytes.data(), bytes.size(), stage.templates, 2), CLQ_OK);
        EXPECT_EQ(fm::host_bytes(), held) << "going back again and again keeps nothing";
    }
    EXPECT_EQ(fm::host_bytes(), 0);
}
