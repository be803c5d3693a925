// Everything computed before the first frame has the same bits for every number of threads of the host.
#include <claque/levels.h>

#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace
{

using Bytes = std::vector<unsigned char>;

struct Host {
    uint32_t threads = 1;
    std::atomic<uint32_t> loops{0};
};

// Threads take indices from a common counter, the last ones first.
void run_on_many_threads(void *user, uint32_t count, void (*job)(void *, uint32_t), void *data)
{
    Host &host = *static_cast<Host *>(user);
    ++host.loops;
    std::atomic<uint32_t> next{0};
    const auto work = [&] {
        for (uint32_t i = next++; i < count; i = next++) job(data, count - 1 - i);
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 1; i < host.threads; ++i) threads.emplace_back(work);
    work();
    for (std::thread &thread : threads) thread.join();
}

class Context
{
public:
    explicit Context(uint32_t threads)
    {
        host.threads = threads;
        clq_context_def def = clq_context_def_init();
        if (threads > 1) def.tasks = {&host, run_on_many_threads};
        EXPECT_EQ(clq_context_create(&def, &context), CLQ_OK);
    }
    ~Context() { EXPECT_EQ(clq_context_destroy(context), CLQ_OK); }

    Host host;
    clq_context *context = nullptr;
};

// The levels and the template of a built-in character, as bytes.
struct Made {
    Bytes levels, tmpl;
};

Made made(Context &host, const char *figure, bool plain)
{
    Made out;
    clq_asset *asset = nullptr;
    EXPECT_EQ(clq_asset_builtin(host.context, figure, &asset), CLQ_OK) << clq_last_error();
    clq_levels_def def = clq_levels_def_init();
    def.quadric_only = plain;
    uint32_t count = 0;
    EXPECT_EQ(clq_asset_make_levels(host.context, asset, &def, &count), CLQ_OK) << clq_last_error();
    std::vector<clq_level_report> levels(count, clq_level_report_init());
    for (uint32_t i = 0; i < count; ++i)
        EXPECT_EQ(clq_asset_get_level_report(asset, i, &levels[i]), CLQ_OK) << clq_last_error();
    EXPECT_GT(count, 8u);
    out.levels.resize(count * sizeof levels[0]);
    std::memcpy(out.levels.data(), levels.data(), out.levels.size());
    clq_template *tmpl = nullptr;
    EXPECT_EQ(clq_asset_build(host.context, asset, 0, &tmpl), CLQ_OK) << clq_last_error();
    const auto append = [](void *user, const void *more, size_t size) {
        const auto *first = static_cast<const unsigned char *>(more);
        static_cast<Bytes *>(user)->insert(static_cast<Bytes *>(user)->end(), first, first + size);
        return 0;
    };
    EXPECT_EQ(clq_template_save(tmpl, append, &out.tmpl), CLQ_OK);
    clq_template_destroy(tmpl);
    clq_asset_destroy(asset);
    return out;
}

void is_the_same_by_threads(const char *figure, bool plain)
{
    Context alone(1);
    const Made wanted = made(alone, figure, plain);
    EXPECT_EQ(alone.host.loops, 0u);
    for (const uint32_t threads : {2u, 5u}) {
        Context host(threads);
        const Made found = made(host, figure, plain);
        EXPECT_GT(host.host.loops, 10u) << "no work ran in parallel";
        EXPECT_EQ(found.levels, wanted.levels) << figure << " by " << threads;
        EXPECT_EQ(found.tmpl, wanted.tmpl) << figure << " by " << threads;
    }
}

}  // namespace

TEST(StartUp, OfACharacterIsTheSameByTwoAndFiveThreads) { is_the_same_by_threads("citizen", false); }

TEST(StartUp, OfQuadricOnlyLevelsIsTheSameToo) { is_the_same_by_threads("decurion", true); }

// One context, an asset for each thread, and one that all of them read.
TEST(Assets, OfOneContextAreMadeReadAndBuiltOnThreadsOfTheirOwn)
{
    Context host(1);
    clq_asset *shared = nullptr;
    ASSERT_EQ(clq_asset_builtin(host.context, "owl", &shared), CLQ_OK);
    const auto clips_of = [&] {
        clq_asset_info info = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(shared, &info), CLQ_OK) << clq_last_error();
        return info.clip_count;
    };
    const uint32_t clips = clips_of();
    const Made wanted = made(host, "citizen", true);
    std::vector<std::thread> threads;
    for (int k = 0; k < 3; ++k)
        threads.emplace_back([&] {
            EXPECT_EQ(clips_of(), clips);
            const Made found = made(host, "citizen", true);
            EXPECT_EQ(found.levels, wanted.levels);
            EXPECT_EQ(found.tmpl, wanted.tmpl);
            EXPECT_EQ(clips_of(), clips);
        });
    for (std::thread &thread : threads) thread.join();
    clq_asset_destroy(shared);
}

TEST(Tasks, OfAContextAreLentToOthersAndRunEachJobOnce)
{
    for (const uint32_t threads : {1u, 3u}) {
        Context host(threads);
        std::vector<std::atomic<uint32_t>> runs(100);
        clq_context_run(
            host.context, 100, [](void *all, uint32_t i) { ++(*static_cast<decltype(runs) *>(all))[i]; }, &runs);
        for (const auto &one : runs) EXPECT_EQ(one, 1u);
        EXPECT_EQ(host.host.loops, threads > 1 ? 1u : 0u);
    }
}

// A failure in a task becomes the call's failure.
TEST(StartUp, RefusesTheSameWithAndWithoutThreads)
{
    for (const uint32_t threads : {1u, 4u}) {
        Context host(threads);
        clq_asset *asset = nullptr;
        ASSERT_EQ(clq_asset_builtin(host.context, "citizen", &asset), CLQ_OK);
        const uint32_t targets[] = {100, 200};
        clq_levels_def def = clq_levels_def_init();
        def.targets = targets, def.target_count = 2;
        EXPECT_EQ(clq_asset_make_levels(host.context, asset, &def, nullptr), CLQ_ARGUMENT);
        clq_asset_destroy(asset);
    }
}
