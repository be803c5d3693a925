// Each call of the C API under each floating-point setting that a host may have: it leaves settings and flags as they
// were (tests/support/between.h), GL meets those of the host, and the world is what it is under the usual ones.
#include "tests/faults/calls.h"
#include "tests/faults/child.h"

namespace faults
{
namespace
{

World &world()
{
    static const std::unique_ptr<World> one = std::make_unique<World>();
    return *one;
}

// What a host sees after the call, and how it ended.
std::string seen_after(const Call &call, const host_floats::Setting *setting)
{
    World &w = world();
    if (call.before) call.before(w);
    w.made = World::untouched, w.found = 0;
    between::hostile = setting;
    std::string text = clq_status_name(call.run(w));
    between::hostile = nullptr;
    if (host_floats::met_others > 0) text += " GL met other settings than the host's;";
    if (call.traits & ends) return text;
    if (call.after) call.after(w);
    return text + " " + std::to_string(w.found) + "\n" + w.see() + w.see_future();
}

class EachCallUnderFloats : public testing::TestWithParam<size_t>
{
};

TEST_P(EachCallUnderFloats, LeavesThemAloneAndGivesTheSame)
{
    const Call &call = calls()[GetParam()];
    world().sees_assets = call.name.rfind("clq_asset_", 0) == 0;
    const Told usual = in_child([&] { return seen_after(call, nullptr); });
    ASSERT_EQ(usual.end, "");
    for (const host_floats::Setting &setting : host_floats::settings()) {
        const Told told = in_child([&] { return seen_after(call, &setting); });
        EXPECT_EQ(told.end, "") << setting.name;
        EXPECT_EQ(difference(usual.text, told.text), "") << setting.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Floats, EachCallUnderFloats, testing::Range(size_t(0), calls().size()), [](const auto &named) {
    return calls()[named.param].name + "_" + std::to_string(named.param);
});

}  // namespace
}  // namespace faults
