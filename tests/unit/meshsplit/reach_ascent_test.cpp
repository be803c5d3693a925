// The Sklsroot Bsphere of characters with degrees of freedom is at most 10 % larger than the reach that hill climbing
// finds (S0 4.1).
#include "reach_ascent.h"

#include <gtest/gtest.h>

#include "reach_rigs.h"

namespace claque::test
{

TEST(ReachAscent, ASphereIsAtMostATenthLargerThanWhatClimbingReaches)
{
    for (const FreeModel &free : free_models()) {
        SCOPED_TRACE(free.name);
        const auto tmpl = built(free.model);
        const double found = found_reach(*tmpl, glm::dvec3(tmpl->sklsroot.centre));
        const double radius = double(tmpl->sklsroot.radius);
        RecordProperty(free.name, std::to_string(radius / found));
        EXPECT_GE(radius, found);
        EXPECT_LE(radius, 1.10 * found);
        // This law must detect a sphere that is too small.
        EXPECT_LT(0.88 * radius, found);
    }
}

}  // namespace claque::test
