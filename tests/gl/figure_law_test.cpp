// The law of zones on the built-in characters, at rest and in their clips.
#include "lib/figures/figure.h"
#include "tests/gl/support/driver.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

using FigureLaw = LawTest;

// Clips that bend a character's surface most: arms forward, arms up, cloth over the lap.
constexpr const char *clips[] = {"applaud", "cheer", "sit_applaud"};

TEST_P(FigureLaw, HoldsOnTheBuiltInFigures)
{
    verdict_.most_ties_share = 1e-5;  // where a strip of cloth goes into the dress
    for (const claque::figures::Builtin &posed : claque::figures::people()) {
        SCOPED_TRACE(posed.name);
        const model::Model made = posed.make();
        hold(split_posed(made), made);
        for (const char *clip : clips) {
            SCOPED_TRACE(clip);
            uint32_t at = 0;
            while (at < made.rig.clips.size() && made.rig.clip_names[at] != clip) ++at;
            ASSERT_LT(at, made.rig.clips.size());
            hold(split_posed(made, at, 0.4), made);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(On, FigureLaw, testing::ValuesIn(on_softpipe() ? targets_here(2) : targets()), name_of_target);

}  // namespace
}  // namespace gltest
