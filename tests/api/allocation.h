// A crowd in a context whose allocator fails on demand, and calls that are tried with each allocation failing.
#pragma once

#include <claque/assets.h>
#include <claque/claque.h>

#include <fstream>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/failing_memory.h"
#include "tests/api/small_template.h"

namespace fm = failing_memory;

namespace allocation
{

enum class Memory { given_back, may_be_kept };  // what a failed call has reserved it may use the next time

// Calls `attempt` with its 1st, (1 + stride)th ... allocation failing, until it succeeds untouched; `unchanged` after
// each failure.
inline void fail_each(const char *what, fm::Reach reach, uint64_t stride, const std::function<clq_status()> &attempt,
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
        if (status == CLQ_OK) continue;  // the call could do without
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

inline std::vector<char> bytes_of(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(file), {});
}

class Allocation : public testing::Test
{
protected:
    // A template from the file, which may need others beside it.
    void fail_each_load(const std::string &path, uint64_t stride)
    {
        const std::vector<char> bytes = bytes_of(path);
        const std::string base = path.substr(0, path.find_last_of('/'));
        clq_asset_options options = clq_asset_options_init();
        options.base_folder = base.c_str();
        clq_template *out = nullptr;
        const Seen before = seen();
        fail_each(
            path.c_str(), fm::Reach::everything, stride,
            [&] {
                out = nullptr;
                clq_asset *asset = nullptr;
                clq_status status = clq_asset_load(context_, bytes.data(), bytes.size(), &options, &asset);
                if (status == CLQ_OK) status = clq_asset_build(context_, asset, 0, &out);
                clq_asset_destroy(asset);
                if (status == CLQ_OK) clq_template_destroy(out);
                return status;
            },
            [&] {
                ASSERT_EQ(out, nullptr) << "out is written only on success";
                ASSERT_TRUE(seen() == before) << "another template's crowd has changed";
            });
    }

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

}  // namespace allocation
