// A context and a renderer, for tests that need one of each.
#pragma once

#include <gtest/gtest.h>

#include "tests/gl/support/absent.h"
#include "tests/gl/support/pictures.h"

namespace gltest
{

using claque::base::Status;

class GlTest : public testing::Test
{
protected:
    static constexpr int width = 320, height = 240;

    void SetUp() override { make_context(width, height); }

    void make_context(int w, int h)
    {
        std::string why;
        context_ = contexts::make_offscreen(contexts::Kind::any, w, h, contexts::PixelFormat::rgba8888, why);
        if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::any, why);
        host_ = std::make_unique<HostGl>(*context_);
    }

    std::unique_ptr<passes::Renderer> make_renderer(const passes::RendererOptions &options = {})
    {
        auto renderer = std::make_unique<passes::Renderer>(std::pmr::get_default_resource(), options);
        const Status status = renderer->open(context_->get_proc_address(), context_->user());
        EXPECT_TRUE(status.ok()) << status.text;
        return renderer;
    }
    std::unique_ptr<passes::Renderer> make_renderer_of(const PosedModel &posed,
                                                       const passes::RendererOptions &options = {})
    {
        auto renderer = make_renderer(options);
        const Status status = renderer->prepare(*posed.tmpl);
        EXPECT_TRUE(status.ok()) << status.text;
        return renderer;
    }

    std::unique_ptr<contexts::Offscreen> context_;
    std::unique_ptr<HostGl> host_;
};

// A small template of eight zones with clean and dirty triangles.
inline PosedModel small_posed() { return make_posed(sheet(9, 0.2f), torture_map(128, 8, 3)); }

inline Camera whole_view(const PosedModel &posed) { return camera_on(posed, 2.6f, -0.5f, 0.4f, 320.0f / 240.0f); }

inline passes::RendererOptions options_of(passes::Strategy strategy, passes::Guard guard = passes::Guard::full)
{
    passes::RendererOptions options;
    options.strategy = strategy;
    options.guard = guard;
    return options;
}

constexpr passes::Strategy all_strategies[] = {passes::Strategy::fused, passes::Strategy::binned,
                                               passes::Strategy::per_zone};

}  // namespace gltest
