// Rows of one character: whatever its proportions and wherever its file has it, it stands on the ground, and the camera
// above it.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/library.h"
#include "samples/scenes/scene.h"

namespace
{

using namespace scenes;

Character of_box(clq_template *tmpl, float low, float wide, float high, float deep)
{
    Character character;
    character.tmpl = tmpl, character.has_box = true;
    const float first[3] = {-wide / 2, low, -deep / 2}, last[3] = {wide / 2, low + high, deep / 2};
    std::copy(first, first + 3, character.box_min);
    std::copy(last, last + 3, character.box_max);
    return character;
}

TEST(Parade, IsSeenFromAboveTheGroundWhateverTheCharactersProportions)
{
    Library library(1);
    clq_template *const tmpl = library.builtin("owl");
    CrowdOptions options;
    for (const uint32_t count : {1u, 3u, 12u})
        for (const float low : {-1000.0f, -3.0f, 0.0f, 50.0f})
            for (const float wide : {0.01f, 0.5f, 1.8f})
                for (const float high : {0.001f, 0.2f, 1.8f})
                    for (const float deep : {0.01f, 0.5f, 1.8f}) {
                        options.count = count;
                        const auto scene = make_parade(library, options, of_box(tmpl, low, wide, high, deep));
                        for (const Shot shot : {Shot::overview, Shot::close})
                            for (const double aspect : {0.5, 1.5, 3.0})
                                EXPECT_GT(scene->camera(shot, aspect, 0).eye[1], 0)
                                    << count << " of " << wide << " x " << high << " x " << deep << " from " << low;
                    }
}

TEST(Parade, StandsOnTheGroundHoweverFarBelowItTheFileHasTheCharacter)
{
    Library library(1);
    CrowdOptions options;
    options.count = 5;
    for (const float low : {-1000.0f, -3.0f, 50.0f}) {
        const auto scene = make_parade(library, options, of_box(library.builtin("owl"), low, 0.5f, 1.0f, 0.25f));
        for (const clq_actor actor : scene->actors()) {
            clq_actor_info info = clq_actor_info_init();
            ASSERT_EQ(clq_actor_get_info(scene->crowd(), actor, &info), CLQ_OK) << clq_last_error();
            EXPECT_NEAR(info.transform.position[1] + double(info.transform.scale * low), 0, 1e-3) << low;
        }
    }
}

}  // namespace
