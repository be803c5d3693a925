// The fixture of tests that hold the law of zones on one target each.
#pragma once

#include "tests/gl/support/law.h"

#include <gtest/gtest.h>

namespace gltest
{

class LawTest : public testing::TestWithParam<Target>
{
protected:
    void SetUp() override
    {
        std::string why;
        context_ = contexts::make_offscreen(GetParam().kind, 240, 180, GetParam().format, why);
        if (!context_) GTEST_SKIP() << why;
    }

    // All strategies. `most_ties_share` of the covered pixels may tie in depth.
    void hold(const Figure &figure, double most_ties_share,
              std::initializer_list<passes::ColourFormat> formats = {passes::ColourFormat::ubyte})
    {
        const Law law(*context_, figure);
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
        RecordProperty("ties", std::to_string(ties_) + " of " + std::to_string(covered_) + " pixels");
        EXPECT_LE(double(law.ties()), most_ties_share * double(law.covered()))
            << law.ties() << " of " << law.covered() << " pixels tie in depth";
    }

    std::unique_ptr<contexts::Offscreen> context_;
    uint64_t covered_ = 0, ties_ = 0;
};

inline std::string name_of_target(const testing::TestParamInfo<Target> &target) { return target.param.name; }

}  // namespace gltest
