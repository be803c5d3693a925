// The fixture of tests of the law of zones on one target each.
#pragma once

#include <gtest/gtest.h>

#include "tests/gl/support/absent.h"
#include "tests/gl/support/law.h"

namespace gltest
{

class LawTest : public testing::TestWithParam<Target>
{
protected:
    void SetUp() override
    {
        std::string why;
        context_ = contexts::make_offscreen(GetParam().kind, 240, 180, GetParam().format, why);
        if (!context_) END_WITHOUT_CONTEXT(GetParam().kind, why);
    }

    // All strategies and formats of colours, against the source.
    void hold(const PosedModel &posed, const model::Model &source)
    {
        hold(posed, {passes::ColourFormat::ubyte, passes::ColourFormat::real}, &source);
    }

    // All strategies.
    void hold(const PosedModel &posed,
              std::initializer_list<passes::ColourFormat> formats = {passes::ColourFormat::ubyte},
              const model::Model *source = nullptr)
    {
        const Law law(*context_, posed, source);
        for (const passes::Strategy strategy :
             {passes::Strategy::fused, passes::Strategy::binned, passes::Strategy::per_zone})
            for (const passes::ColourFormat format : formats) {
                SCOPED_TRACE(testing::Message() << "strategy " << int(strategy) << ", format " << int(format));
                passes::RendererOptions options;
                options.strategy = strategy;
                options.colours = format;
                law.hold(options, verdict_);
            }
    }

    // A single picture by a renderer of its own.
    void hold(const PosedModel &posed, const Camera &camera, const passes::RendererOptions &options,
              const Wanted &wanted)
    {
        passes::Renderer renderer(std::pmr::get_default_resource(), options);
        ASSERT_TRUE(renderer.open(context_->get_proc_address(), context_->user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
        verdict_.hold(wanted, draw(*context_, renderer, list_of(posed, camera, colours.data())), 0.1);
        renderer.destroy();
    }

    std::unique_ptr<contexts::Offscreen> context_;
    Verdict verdict_;
};

inline std::string name_of_target(const testing::TestParamInfo<Target> &target) { return target.param.name; }

}  // namespace gltest
