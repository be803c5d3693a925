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

    // The largest fraction of covered pixels that may tie in depth is `most_ties_share_`.
    void TearDown() override
    {
        RecordProperty("ties", std::to_string(ties_) + " of " + std::to_string(covered_) + " pixels");
        EXPECT_LE(double(ties_), most_ties_share_ * double(covered_))
            << ties_ << " of " << covered_ << " pixels tie in depth";
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
                law.hold(options);
            }
        covered_ += law.covered(), ties_ += law.ties();
    }

    std::unique_ptr<contexts::Offscreen> context_;
    double most_ties_share_ = 0;
    uint64_t covered_ = 0, ties_ = 0;
};

inline std::string name_of_target(const testing::TestParamInfo<Target> &target) { return target.param.name; }

}  // namespace gltest
