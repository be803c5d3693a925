// The law of zones on the built-in figure, at rest and in its clips.
#include "lib/figures/figure.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

using FigureLaw = LawTest;

TEST_P(FigureLaw, HoldsOnTheBuiltInFigure)
{
    const model::Model citizen = claque::figures::citizen();
    for (const uint32_t clip : {model::none, 1u, 2u}) {
        SCOPED_TRACE(testing::Message() << "clip " << int(clip));
        hold(split_figure(citizen, clip, 0.4));
    }
}

INSTANTIATE_TEST_SUITE_P(On, FigureLaw, testing::ValuesIn(two_targets), name_of_target);

}  // namespace
}  // namespace gltest
