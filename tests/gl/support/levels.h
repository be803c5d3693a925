// The fixture of tests of the law of zones at every level of detail.
#pragma once

#include <gtest/gtest.h>

#include "tests/gl/support/law.h"
#include "tests/gl/support/source_zones.h"
#include "tests/gl/support/spy.h"

namespace gltest
{

class LevelsTest : public testing::Test
{
protected:
    // Makes the model's levels and tests the law on each, from this many cameras per level, by all three strategies,
    // in all texture sets by turns. What a level has to show is drawn from the images that the model with levels has:
    // a far level's own image is made of the model's, and lod_test holds its zones. Returns the number of cameras, 0
    // where the context is absent.
    uint32_t hold(const Target &target, model::Model character, uint32_t texture_px, uint32_t cameras_a_level);

    uint32_t flat_levels_ = 0;  // levels that each draw of them drew GL_FLAT

private:
    void make_context(const Target &target);
    void hold_level(PosedModel &posed, SourceImages &images, uint32_t level, uint32_t cameras);

    std::unique_ptr<contexts::Offscreen> context_;
    std::unique_ptr<Spy> spy_;
    uint32_t flat_calls_ = 0;  // glShadeModel(GL_FLAT) since it was last set to 0
    Verdict verdict_;
};

}  // namespace gltest
