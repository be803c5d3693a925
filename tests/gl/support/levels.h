// The fixture of tests of the law of zones at every level of detail.
#pragma once

#include <gtest/gtest.h>

#include "tests/gl/support/pictures.h"

namespace gltest
{

class LevelsTest : public testing::Test
{
protected:
    void SetUp() override;

    // Makes the model's levels and tests the law on each, from this many cameras per level, by all three strategies.
    // Returns the number of cameras.
    uint32_t hold(model::Model character, uint32_t texture_px, uint32_t cameras_a_level);

    double most_ties_share_ = 1e-4;  // largest fraction of covered pixels that may tie in depth

private:
    void hold_level(const PosedModel &posed, uint32_t level, uint32_t cameras);

    std::unique_ptr<contexts::Offscreen> context_;
    uint64_t covered_ = 0, ties_ = 0;
};

}  // namespace gltest
