// The law of zones in every texture set: other zones on the same triangles, in images of other sizes (S1 1, S2 2.1).
#include "lib/figures/figure.h"
#include "tests/gl/support/driver.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

std::vector<uint8_t> keys_from(uint32_t count, int first)
{
    std::vector<uint8_t> keys;
    for (uint32_t i = 0; i < count; ++i) keys.push_back(static_cast<uint8_t>(first + int(i)));
    return keys;
}

// A sheet whose further sets have zone maps of their own: finer, coarser, of another size, and one with two zones
// swapped.
model::Model sheet_in_sets()
{
    const std::vector<uint8_t> keys = keys_from(8, 3);
    model::Model made = model_of(sheet(9, 0.2f), torture_map(64, 8, 3), keys, model::Wrap::repeat);
    const auto add = [&](const char *name, const ZoneMap &map) {
        const model::Model other = model_of(sheet(1, 0), map, keys, model::Wrap::repeat);
        made.texture_sets.push_back({name, {static_cast<uint32_t>(made.images.size())}});
        made.images.push_back(other.images[0]);
    };
    add("finer", torture_map(128, 8, 2));
    add("coarser", torture_map(32, 5, 4));
    ZoneMap swapped = torture_map(64, 8, 3);
    for (uint16_t &zone : swapped.zones) zone = zone == 0 ? 7 : zone == 7 ? 0 : zone;
    add("swapped", swapped);
    add("resized", torture_map(50, 8, 3));
    return made;
}

using TextureSetsLaw = LawTest;

TEST_P(TextureSetsLaw, HoldsInEverySetOfASheet)
{
    const model::Model source = sheet_in_sets();
    PosedModel posed = split_posed(source);
    ASSERT_EQ(posed.tmpl->texture_set_count(), 5u);
    for (uint32_t set = 0; set < 5; ++set) {
        SCOPED_TRACE(testing::Message() << "set " << set);
        posed.texture_set = set;
        hold(posed, source);
    }
}

TEST_P(TextureSetsLaw, HoldsOnThePeopleInTheirSecondSets)
{
    verdict_.most_ties_share = 1e-4;  // layers of cloth, as on the odeon
    for (const claque::figures::Builtin &person : claque::figures::people()) {
        SCOPED_TRACE(person.name);
        const model::Model source = person.make();
        PosedModel posed = split_posed(source);
        ASSERT_EQ(posed.tmpl->texture_set_count(), 2u);
        posed.texture_set = 1;
        hold(posed, source);
    }
}

INSTANTIATE_TEST_SUITE_P(On, TextureSetsLaw, testing::ValuesIn(on_softpipe() ? targets_here(2) : targets()),
                         name_of_target);

}  // namespace
}  // namespace gltest
