// People as a scenario's text, which is read again.
#include <gtest/gtest.h>

#include "samples/scenes/roles/person.h"
#include "samples/scenes/scenario/scenario.h"

TEST(SavedPeople, KeepHowTheirFileIsPlacedAndBlended)
{
    scenes::roles::Person person;
    person.character = "./man.glb";
    person.placement.turn_deg = 90, person.placement.scale = 2, person.placement.blend = CLQ_BLEND_OPAQUE;
    const scenes::Scenario read =
        scenes::read_scenario(scenes::roles::text_of("people", {person}, ""), "saved.toml",
                              {"", [](const std::string &, std::string &) { return std::string(); },
                               [](const std::string &) { return std::string(); }});
    ASSERT_EQ(read.characters.size(), 1u);
    const scenes::Placement &placed = read.characters[0].placement;
    EXPECT_EQ(placed.turn_deg, 90);
    EXPECT_EQ(placed.scale, 2);
    EXPECT_EQ(placed.blend, CLQ_BLEND_OPAQUE);
    person.placement.blend = CLQ_BLEND_UNSET;
    EXPECT_EQ(scenes::roles::text_of("people", {person}, "").find("blend"), std::string::npos);
}
