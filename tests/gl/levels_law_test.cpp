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
    Target target;
};

std::string name_of(const Case &one) { return one.name + ("In" + std::to_string(one.texture_px)) + one.target.name; }

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
    const uint32_t cameras = hold(GetParam().target, made(GetParam().name), GetParam().texture_px, 9);
    if (IsSkipped()) return;
    EXPECT_GE(cameras, 84u) << "twelve of these make a thousand";
    EXPECT_GE(flat_levels_, 4u) << "of 60, 42, 30, 20 and 14 triangles";
}

// Each size of textures in each context and format.
std::vector<Case> cases()
{
    constexpr uint32_t sizes[] = {1024, 128, 16};
    const char *const names[] = {"citizen", "patrician", "decurion", "plebeian"};
    const std::vector<Target> all = targets_here();
    std::vector<Case> chosen;
    for (size_t k = 0; k < 4; ++k)
        for (size_t size = 0; size < 3; ++size) chosen.push_back({names[k], sizes[size], all[(k + size) % all.size()]});
    return chosen;
}

INSTANTIATE_TEST_SUITE_P(At, LevelsLaw, testing::ValuesIn(cases()), [](const auto &one) { return name_of(one.param); });

}  // namespace
}  // namespace gltest
