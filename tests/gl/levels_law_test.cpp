// The law of zones at every level of detail, in every size of the texture, by every strategy, from random cameras: more
// than a thousand on the built-in characters alone.
#include "lib/figures/figure.h"
#include "tests/gl/support/levels.h"

namespace gltest
{
namespace
{

struct Case {
    const char *name;
    uint32_t texture_px;
};

std::string name_of(const Case &one) { return std::string(one.name) + "In" + std::to_string(one.texture_px); }

class LevelsLaw : public LevelsTest, public testing::WithParamInterface<Case>
{
};

model::Model made(const std::string &name)
{
    for (const claque::figures::Builtin &posed : claque::figures::people())
        if (posed.name == name) return posed.make();
    throw std::runtime_error(name);
}

TEST_P(LevelsLaw, HoldsOnTheBuiltInFigures)
{
    const uint32_t cameras = hold(made(GetParam().name), GetParam().texture_px, 9);
    EXPECT_GE(cameras, 84u) << "twelve of these make a thousand";
}

INSTANTIATE_TEST_SUITE_P(At, LevelsLaw,
                         testing::Values(Case{"citizen", 1024}, Case{"citizen", 128}, Case{"citizen", 16},
                                         Case{"patrician", 1024}, Case{"patrician", 128}, Case{"patrician", 16},
                                         Case{"decurion", 1024}, Case{"decurion", 128}, Case{"decurion", 16},
                                         Case{"plebeian", 1024}, Case{"plebeian", 128}, Case{"plebeian", 16}),
                         [](const auto &one) { return name_of(one.param); });

}  // namespace
}  // namespace gltest
