// What several crowds and threads share: templates, locomotions, tracks, a log and arrays of a draw list. Each is held,
// read and let go on any thread. To be run under a thread sanitizer as well.
#include <atomic>
#include <new>
#include <thread>

#include "tests/api/stub_gl.h"

namespace
{

using Written = std::vector<unsigned char>;

int take_written(void *user, const void *bytes, size_t size)
{
    auto &all = *static_cast<Written *>(user);
    const auto *first = static_cast<const unsigned char *>(bytes);
    all.insert(all.end(), first, first + size);
    return 0;
}

Written written_template(const clq_template *tmpl)
{
    Written out;
    EXPECT_EQ(clq_template_save(tmpl, take_written, &out), CLQ_OK) << clq_last_error();
    return out;
}

Written written_track(const clq_track *track)
{
    Written out;
    EXPECT_EQ(clq_track_save(track, take_written, &out), CLQ_OK) << clq_last_error();
    return out;
}

// Runs a body for each of four threads, all at once.
template <class Body>
void run_side_by_side(const Body &body)
{
    constexpr uint32_t count = 4;
    std::atomic<uint32_t> ready{0};
    std::vector<std::thread> threads;
    for (uint32_t k = 0; k < count; ++k)
        threads.emplace_back([&, k] {
            ++ready;
            while (ready < count) std::this_thread::yield();
            body(k);
        });
    for (std::thread &thread : threads) thread.join();
}

// An actor that follows the shared track, and one of a template of the thread's own.
void use_in_a_crowd(const TestWorld &world, clq_template *own)
{
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(world.context, nullptr, &crowd), CLQ_OK) << clq_last_error();
    clq_actor_def def = clq_actor_def_init();
    clq_actor actor;
    def.tmpl = own;
    EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK) << clq_last_error();
    def.tmpl = world.templates[0];
    EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_actor_follow_track(crowd, actor, world.tracks[0], 0), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
}

}  // namespace

TEST(SharedThreads, TemplatesAndTracksAreMadeSavedLoadedUsedAndEndedSideBySide)
{
    TestWorld world;
    const Written wanted = written_template(world.templates[1]), piece = written_track(world.tracks[1]);
    run_side_by_side([&](uint32_t k) {
        for (uint32_t round = 0; round < 4; ++round) {
            clq_template *own = nullptr;
            if (k % 2) ASSERT_EQ(clq_template_build(world.context, &world.plain.def, &own), CLQ_OK);
            else ASSERT_EQ(clq_template_load(world.context, wanted.data(), wanted.size(), &own), CLQ_OK);
            EXPECT_EQ(written_template(own), wanted);
            EXPECT_EQ(written_template(world.templates[1]), wanted);
            EXPECT_NE(clq_template_find_zone(world.templates[0], "skin"), CLQ_NONE);
            use_in_a_crowd(world, own);
            clq_template_destroy(own);
            const uint32_t clip = 0;
            const clq_locomotion_def walk = Walker::locomotion(world.templates[0], &clip);
            clq_locomotion *locomotion = nullptr;
            ASSERT_EQ(clq_locomotion_create(world.context, &walk, &locomotion), CLQ_OK) << clq_last_error();
            clq_track *track = nullptr;
            ASSERT_EQ(clq_track_load(k % 2 ? locomotion : world.locomotion, piece.data(), piece.size(), &track), CLQ_OK)
                << clq_last_error();
            clq_locomotion_destroy(locomotion);
            clq_track_state mine, shared;
            EXPECT_EQ(clq_track_evaluate(track, 0.5, &mine), CLQ_OK);
            EXPECT_EQ(clq_track_evaluate(world.tracks[1], 0.5, &shared), CLQ_OK);
            EXPECT_EQ(mine.position[0], shared.position[0]);
            EXPECT_EQ(written_track(world.tracks[1]), piece);
            clq_track_destroy(track);
        }
    });
}

TEST(SharedThreads, HoldsOfATrackAreCountedOnAllThreads)
{
    std::atomic<int64_t> blocks{0};
    clq_context_def def = clq_context_def_init();
    def.allocator.user = &blocks;
    def.allocator.allocate = [](void *user, size_t size, size_t alignment) {
        ++*static_cast<std::atomic<int64_t> *>(user);
        return ::operator new(size, std::align_val_t(alignment));
    };
    def.allocator.release = [](void *user, void *memory, size_t, size_t alignment) {
        --*static_cast<std::atomic<int64_t> *>(user);
        ::operator delete(memory, std::align_val_t(alignment));
    };
    {
        TestWorld world(&def);
        const int64_t before = blocks;
        constexpr uint32_t holds = 1000000;  // so that all threads are at work at one time
        run_side_by_side([&](uint32_t) {
            for (uint32_t i = 0; i < holds; ++i) clq_track_hold(world.tracks[0]);
        });
        run_side_by_side([&](uint32_t) {
            for (uint32_t i = 0; i < holds; ++i) clq_track_destroy(world.tracks[0]);
        });
        ASSERT_EQ(blocks, before) << "this thread's own hold is left";
    }
    EXPECT_EQ(blocks, 0);
}

TEST(SharedThreads, EachHasItsLastErrorAndAllMayWriteToTheLog)
{
    std::atomic<uint32_t> sentences{0};
    clq_context_def def = clq_context_def_init();
    def.log.user = &sentences;
    def.log.write = [](void *user, clq_log_level, const char *) { ++*static_cast<std::atomic<uint32_t> *>(user); };
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    std::atomic<uint32_t> reported{0};
    run_side_by_side([&](uint32_t k) {
        const std::string text = "thread " + std::to_string(k);
        for (uint32_t round = 1; round <= 200; ++round) {
            EXPECT_EQ(clq_report(CLQ_ARGUMENT, text.c_str()), CLQ_ARGUMENT);
            clq_context_log(context, CLQ_LOG_WARNING, text.c_str());
            for (++reported; reported < 4 * round;) std::this_thread::yield();
            EXPECT_EQ(clq_last_error(), text);
        }
    });
    EXPECT_EQ(sentences, 4u * 200);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

TEST(SharedThreads, ContextsAreMadeUsedAndEndedOnThreadsOfTheirOwn)
{
    uint64_t hashes[4] = {};
    run_side_by_side([&](uint32_t k) {
        TestWorld world;
        clq_crowd *crowd = world.new_crowd();
        world.set_up(crowd);
        world.fill(crowd, 20, 5);
        clq_view *view = world.new_view(crowd, 0);
        ASSERT_EQ(clq_crowd_update(crowd, 1, &view, 1), CLQ_OK) << clq_last_error();
        hashes[k] = clq_view_get_hash(view);
    });
    EXPECT_NE(hashes[0], 0u);
    for (const uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

// In turn with updates of another thread, and while a third one asks.
TEST(SharedThreads, TheInstructionSetIsChosenOnAnyThreadBetweenUpdates)
{
    TestWorld world;
    clq_crowd *crowd = world.new_crowd();
    world.set_up(crowd);
    world.fill(crowd, 20, 5);
    clq_view *view = world.new_view(crowd, 0);
    const clq_simd before = clq_simd_get();
    std::atomic<uint32_t> turn{0};
    constexpr uint32_t turns = 40;
    uint64_t hashes[2] = {};
    run_side_by_side([&](uint32_t k) {
        while (turn < turns) {
            if (k < 2 && turn % 2 == k) {
                if (k == 0) EXPECT_EQ(clq_simd_set(turn % 4 == 0 ? CLQ_SIMD_SCALAR : before), CLQ_OK);
                else {
                    EXPECT_EQ(clq_crowd_update(crowd, 1, &view, 1), CLQ_OK) << clq_last_error();
                    hashes[turn / 2 % 2] = clq_view_get_hash(view);
                }
                ++turn;
            }
            const clq_simd now = clq_simd_get();
            EXPECT_TRUE(now == before || now == CLQ_SIMD_SCALAR);
            std::this_thread::yield();
        }
    });
    EXPECT_EQ(clq_simd_set(before), CLQ_OK);
    EXPECT_NE(hashes[0], 0u);
    EXPECT_EQ(hashes[0], hashes[1]);
}

// Draws and other calls leave the arrays of a draw list as they are. A renderer may be abandoned on another thread.
TEST(SharedThreads, ArraysOfADrawListAreReadWhileItIsDrawn)
{
    for (const uint64_t budget : {uint64_t(0), uint64_t(20000)}) {  // with the second, draws skin much of the crowd
        TestWorld world;
        clq_crowd_def def = clq_crowd_def_init();
        def.cache_budget_bytes = budget;
        clq_crowd *crowd = world.new_crowd(&def);
        world.set_up(crowd);
        world.fill(crowd, 100, 5);
        clq_view *views[2] = {world.new_view(crowd, 0), world.new_view(crowd, 3)};
        ASSERT_EQ(clq_crowd_update(crowd, 1, views, 2), CLQ_OK) << clq_last_error();
        clq_view_stats stats = clq_view_stats_init();
        ASSERT_EQ(clq_view_get_stats(views[0], &stats), CLQ_OK);
        struct Item {
            clq_drawn_actor drawn = clq_drawn_actor_init();
            clq_drawn_arrays arrays = clq_drawn_arrays_init();
        };
        std::vector<Item> items(stats.visible);
        for (uint32_t i = 0; i < stats.visible; ++i) {
            ASSERT_EQ(clq_view_get_drawn_actor(views[0], i, &items[i].drawn), CLQ_OK);
            ASSERT_EQ(clq_view_get_arrays(views[0], i, &items[i].arrays), CLQ_OK);
        }
        const auto sum_of_all = [&] {
            double sum = 0;
            for (const Item &item : items) {
                for (uint32_t i = 0; item.arrays.positions && i < 3 * item.drawn.vertex_count; ++i)
                    sum += double(item.arrays.positions[i]);
                for (uint32_t i = 0; item.arrays.palette && i < 12 * item.drawn.joint_count; ++i)
                    sum += double(item.arrays.palette[i]);
                for (uint32_t i = 0; item.arrays.colours && i < 3 * item.drawn.zone_count; ++i)
                    sum += item.arrays.colours[i];
            }
            return sum;
        };
        const double sum = sum_of_all();
        EXPECT_NE(sum, 0);
        clq_renderer *left[2] = {nullptr, nullptr};
        run_side_by_side([&](uint32_t k) {
            if (k < 2) {
                for (uint32_t round = 0; round < 20; ++round) EXPECT_EQ(sum_of_all(), sum);
                return;
            }
            clq_renderer *renderer = left[k - 2] = stub_gl::new_renderer(world);
            for (uint32_t round = 0; round < 20; ++round)
                EXPECT_EQ(clq_renderer_draw(renderer, views[k - 2], nullptr), CLQ_OK) << clq_last_error();
        });
        for (clq_renderer *renderer : left) EXPECT_EQ(clq_renderer_abandon(renderer), CLQ_OK) << clq_last_error();
        EXPECT_EQ(sum_of_all(), sum);
    }
}
