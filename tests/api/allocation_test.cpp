// An allocation that fails gives a status and leaves everything as it was: every n for small calls, a stride for large
// ones.
#include <claque/assets.h>
#include <claque/claque.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <vector>

#include "samples/contexts/offscreen.h"
#include "tests/api/calls.h"
#include "tests/api/failing_memory.h"
#include "tests/api/small_template.h"
#include "tests/gl/support/absent.h"

namespace fm = failing_memory;

namespace
{

enum class Memory { given_back, may_be_kept };  // what a failed call has reserved it may use the next time

// Calls `attempt` with its 1st, (1 + stride)th ... allocation failing, until it succeeds untouched; `unchanged` after
// each failure.
void fail_each(const char *what, fm::Reach reach, uint64_t stride, const std::function<clq_status()> &attempt,
               const std::function<void()> &unchanged, Memory memory = Memory::given_back)
{
    uint64_t failures = 0;
    for (uint64_t n = 1;; n += stride) {
        const int64_t before = fm::host_bytes();
        fm::arm(n, reach);
        const clq_status status = attempt();
        const uint64_t seen = fm::disarm();
        if (seen < n) {
            ASSERT_EQ(status, CLQ_OK) << what << ": " << clq_last_error();
            break;
        }
        if (status == CLQ_OK) continue;  // whoever asked could do without
        ++failures;
        ASSERT_EQ(status, CLQ_OUT_OF_MEMORY) << what << ", allocation " << n << ": " << clq_last_error();
        if (memory == Memory::given_back) {
            ASSERT_EQ(fm::host_bytes(), before) << what << ", allocation " << n << " left memory behind";
        }
        unchanged();
        ASSERT_LT(n, 100000000u);
    }
    EXPECT_GT(failures, 0u) << what << " never allocated: this test saw nothing";
}

class Allocation : public testing::Test
{
protected:
    void SetUp() override
    {
        clq_context_def def = clq_context_def_init();
        def.allocator = fm::allocator;
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
        EXPECT_EQ(fm::host_bytes(), 0);
    }

    void make_crowd(int people, clq_cache_mode cache = CLQ_CACHE_FULL)
    {
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
        clq_crowd_def def = clq_crowd_def_init();
        def.cache = cache;
        ASSERT_EQ(clq_crowd_create(context_, &def, &crowd_), CLQ_OK);
        for (int i = 0; i < people; ++i) add_actor(i);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 12}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.0f, 0.1f, 100.0f), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    }

    void draw_without_memory(clq_renderer *renderer) const
    {
        fm::arm(1, fm::Reach::host_only, true);
        EXPECT_EQ(clq_renderer_draw(renderer, view_, nullptr), CLQ_OK) << clq_last_error();
        EXPECT_EQ(fm::disarm(), 0u);
    }

    clq_status add_actor(int i)
    {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        def.transform.position[0] = 0.5 * (i % 16) - 4;
        def.transform.position[2] = -0.5 * (i / 16);
        def.play.clip = 0;
        def.seed = static_cast<uint64_t>(i);
        clq_actor actor;
        const clq_status status = clq_actor_create(crowd_, &def, &actor);
        if (status == CLQ_OK && first_.index1 == 0) first_ = actor;
        return status != CLQ_OK ? status : clq_actor_randomise_colours(crowd_, actor, nullptr, 0);
    }

    // What the host can tell of its crowd without changing it.
    struct Seen {
        uint64_t crowd, list;
        uint32_t actors, zones;
        bool operator==(const Seen &o) const
        {
            return crowd == o.crowd && list == o.list && actors == o.actors && zones == o.zones;
        }
    };
    Seen seen() const
    {
        clq_template_info info = clq_template_info_init();
        EXPECT_EQ(clq_template_get_info(tmpl_, &info), CLQ_OK);
        return {clq_crowd_get_hash(crowd_), clq_view_get_hash(view_), clq_crowd_get_actor_count(crowd_),
                info.zone_count};
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_actor first_ = {0, 0};
};

template <class Function>
Function screen_function(const contexts::Offscreen &screen, const char *name)
{
    return reinterpret_cast<Function>(screen.get_proc_address()(screen.user(), name));
}

std::vector<char> bytes_of(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

TEST(ContextAllocation, AContextThatFindsNoMemoryIsNotMade)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = fm::allocator;
    clq_context *out = nullptr;
    fail_each(
        "clq_context_create", fm::Reach::everything, 1,
        [&] {
            out = nullptr;
            const clq_status status = clq_context_create(&def, &out);
            if (status == CLQ_OK) clq_context_destroy(out);
            return status;
        },
        [&] { ASSERT_EQ(out, nullptr) << "out is written only on success"; });
}

TEST_F(Allocation, BuildingATemplateFailsCleanlyAtEveryAllocation)
{
    make_crowd(20);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    const Seen before = seen();
    clq_template *out = nullptr;
    fail_each(
        "clq_template_build", fm::Reach::everything, 1,
        [&] {
            out = nullptr;
            const clq_status status = clq_template_build(context_, &small_.def, &out);
            if (status == CLQ_OK) clq_template_destroy(out);
            return status;
        },
        [&] {
            ASSERT_EQ(out, nullptr) << "out is written only on success";
            ASSERT_TRUE(seen() == before) << "another template's crowd has changed";
        });
}

TEST_F(Allocation, CreatingActorsFailsCleanlyAtEveryAllocation)
{
    make_crowd(0);
    // Enough actors that every column has to grow at least twice on the way.
    for (int i = 0; i < 100; ++i) {
        const uint64_t before = clq_crowd_get_hash(crowd_);
        const uint32_t count = clq_crowd_get_actor_count(crowd_);
        uint64_t n = 1;
        for (;; ++n) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = tmpl_;
            clq_actor actor = {0, 0};
            fm::arm(n, fm::Reach::everything);
            const clq_status status = clq_actor_create(crowd_, &def, &actor);
            if (fm::disarm() < n) {
                ASSERT_EQ(status, CLQ_OK);
                break;
            }
            ASSERT_EQ(status, CLQ_OUT_OF_MEMORY);
            ASSERT_EQ(actor.index1, 0u) << "out is written only on success";
            ASSERT_EQ(clq_crowd_get_hash(crowd_), before);
            ASSERT_EQ(clq_crowd_get_actor_count(crowd_), count);
        }
    }
}

TEST_F(Allocation, AnUpdateFailsCleanlyAtEveryAllocationAndTheNextOneIsTheSame)
{
    make_crowd(60);
    const uint64_t crowd_before = clq_crowd_get_hash(crowd_);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.1, &view_, 1), CLQ_OK) << clq_last_error();
    const uint64_t first = clq_view_get_hash(view_);
    ASSERT_EQ(crowd_before, clq_crowd_get_hash(crowd_)) << "an update changes nothing that the host has set";

    for (int i = 60; i < 200; ++i) ASSERT_EQ(add_actor(i), CLQ_OK);  // so that the update must make room
    ASSERT_EQ(first, clq_view_get_hash(view_));
    fail_each(
        "clq_crowd_update", fm::Reach::everything, 1, [&] { return clq_crowd_update(crowd_, 0.3, &view_, 1); },
        [&] { ASSERT_EQ(clq_view_get_hash(view_), first) << "a failed update leaves the list as it was"; },
        Memory::may_be_kept);
    const uint64_t after = clq_view_get_hash(view_);

    clq_crowd *fresh = nullptr;
    std::swap(crowd_, fresh);
    clq_template *old = tmpl_;
    make_crowd(200);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.3, &view_, 1), CLQ_OK);
    EXPECT_EQ(clq_view_get_hash(view_), after) << "failures on the way changed what is shown";
    clq_crowd_destroy(fresh);
    clq_template_destroy(old);
}

TEST_F(Allocation, FramesThatSetTransformsAndUpdateAllocateNothing)
{
    make_crowd(100);
    const std::vector<clq_actor> actors(1, first_);
    const std::vector<clq_transform> places(1, clq_transform{{0, 0, 0}, {0, 0, 0, 1}, 1});
    const auto frame = [&](int number) {
        return clq_crowd_set_transforms(crowd_, actors.data(), places.data(), 1) == CLQ_OK &&
               clq_crowd_update(crowd_, 0.02 * number, &view_, 1) == CLQ_OK;
    };
    for (int number = 0; number < 3; ++number) ASSERT_TRUE(frame(number)) << clq_last_error();
    fm::arm(0, fm::Reach::everything);
    bool good = true;
    for (int number = 3; number < 30; ++number) good = frame(number) && good;
    EXPECT_EQ(fm::disarm(), 0u);
    EXPECT_TRUE(good);
}

TEST_F(Allocation, LoadingTheSmallestAssetFailsCleanlyAtEveryAllocationAndALargerOneAtAStride)
{
    make_crowd(20);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    const Seen before = seen();
    const std::string folder = CLAQUE_ASSETS_DIR;
    const struct {
        const char *path;
        uint64_t stride;
    } files[] = {{"/conformance/khronos/SimpleMorph-Embedded/SimpleMorph.gltf", 1},
                 {"/conformance/khronos/SimpleSkin-external/SimpleSkin.gltf", 7},
                 {"/humanoids/khronos/RiggedFigure.glb", 1009},
                 {"/humanoids/quaternius-ultimate/Casual_Male.gltf", 30011}};
    for (const auto &file : files) {
        const std::string path = folder + file.path;
        const std::vector<char> bytes = bytes_of(path);
        if (bytes.empty()) GTEST_SKIP() << "real characters are not beside this checkout: " << path;
        const std::string base = path.substr(0, path.find_last_of('/'));
        clq_asset_options options = clq_asset_options_init();
        options.base_folder = base.c_str();
        clq_template *out = nullptr;
        fail_each(
            file.path, fm::Reach::everything, file.stride,
            [&] {
                out = nullptr;
                const clq_status status = clq_template_load_gltf(context_, bytes.data(), bytes.size(), &options, &out);
                if (status == CLQ_OK) clq_template_destroy(out);
                return status;
            },
            [&] {
                ASSERT_EQ(out, nullptr) << "out is written only on success";
                ASSERT_TRUE(seen() == before) << "another template's crowd has changed";
            });
    }
}

TEST_F(Allocation, ARendererFailsCleanlyAndDrawingAllocatesNothing)
{
    make_crowd(50);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    std::string why_not;
    const auto screen = contexts::make_offscreen(contexts::Kind::any, 64, 64, contexts::PixelFormat::rgba8888, why_not);
    if (!screen) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    ASSERT_TRUE(screen->make_current());
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = screen->get_proc_address();
    def.user = screen->user();
    clq_renderer *renderer = nullptr;
    ASSERT_EQ(clq_renderer_create(context_, &def, &renderer), CLQ_OK);
    ASSERT_EQ(clq_renderer_prepare(renderer, tmpl_), CLQ_OK);
    const auto clear_colour = screen_function<void (*)(float, float, float, float)>(*screen, "glClearColor");
    const auto clear = screen_function<void (*)(unsigned)>(*screen, "glClear");
    std::vector<uint8_t> empty, drawn, now;
    clear_colour(0.1f, 0.6f, 0.2f, 1);
    clear(0x4100);
    screen->read_rgb(empty);
    ASSERT_EQ(clq_renderer_draw(renderer, view_, nullptr), CLQ_OK) << clq_last_error();
    screen->read_rgb(drawn);
    ASSERT_NE(drawn, empty);
    // Only the host's allocator may fail here: what GL itself allocates is not ours to test.
    clq_renderer *out = nullptr;
    fail_each(
        "clq_renderer_create and prepare", fm::Reach::host_only, 1,
        [&] {
            out = nullptr;
            clq_status status = clq_renderer_create(context_, &def, &out);
            if (status == CLQ_OK) status = clq_renderer_prepare(out, tmpl_);
            clq_renderer_destroy(out);
            return status;
        },
        [&] {
            clear(0x4100);
            ASSERT_EQ(clq_renderer_draw(renderer, view_, nullptr), CLQ_OK) << clq_last_error();
            screen->read_rgb(now);
            ASSERT_EQ(now, drawn) << "another renderer draws another picture";
        });
    draw_without_memory(renderer);
    // The mask of the viewport is made at the first shadows, and kept.
    const clq_shadow_def shadows = clq_shadow_def_init();
    clear(0x4100);
    fail_each(
        "clq_renderer_draw_shadows", fm::Reach::host_only, 1,
        [&] { return clq_renderer_draw_shadows(renderer, view_, &shadows, nullptr); },
        [&] {
            screen->read_rgb(now);
            ASSERT_EQ(now, empty) << "a call that failed has drawn";
        },
        Memory::may_be_kept);
    fm::arm(1, fm::Reach::host_only, true);
    EXPECT_EQ(clq_renderer_draw_shadows(renderer, view_, &shadows, nullptr), CLQ_OK) << clq_last_error();
    EXPECT_EQ(fm::disarm(), 0u);
    // Of a crowd without caches.
    clq_crowd_destroy(crowd_);
    clq_template_destroy(tmpl_);
    crowd_ = nullptr;
    make_crowd(50, CLQ_CACHE_NONE);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    ASSERT_EQ(clq_renderer_prepare(renderer, tmpl_), CLQ_OK);
    draw_without_memory(renderer);
    clq_renderer_destroy(renderer);
}
