// What scenario files say of the town and of what flies over it, and how a file that breaks a rule is refused.
#include <gtest/gtest.h>

#include "tests/scenes/described.h"

namespace
{

using namespace scenes;

const std::string fair = R"toml(name = "fair"

[stage]
seconds = 30.0

[town]
seed = 7
market_day = true

[navigation]

[[characters]]
name = "guests"
character = "citizen"

[[agents]]
class = "guests"
machine = "guest.toml"
area = [0.0, 0.0, 5.0, 5.0]

[[flyers]]
character = "owl"
scale = 0.5
path = [0.0, 5.0, 0.0, 9.0, 6.0, 0.0, 4.0, 7.0, 9.0]
sends = "startle"
radius_m = 4.0
)toml";

Scenario read_fair(const std::string &text)
{
    return read_scenario(text, "mine.toml",
                         {"", [](const std::string &, std::string &) { return std::string(); },
                          [](const std::string &) { return std::string(); }});
}

std::string refusal(const std::string &was, const std::string &is)
{
    try {
        read_fair(changed_text(fair, "", was, is));
    } catch (const Failure &failure) {
        return failure.what();
    }
    return "taken";
}

void expect_refused(const std::string &was, const std::string &is, const std::string &place, const std::string &why)
{
    const std::string text = refusal(was, is);
    EXPECT_NE(text.find("mine.toml:" + place), std::string::npos) << text;
    EXPECT_NE(text.find(why), std::string::npos) << text;
}

}  // namespace

TEST(TownSection, IsRead)
{
    const Scenario read = read_fair(fair);
    ASSERT_TRUE(read.town);
    EXPECT_EQ(read.town->seed, 7u);
    EXPECT_TRUE(read.town->market_day);
    EXPECT_EQ(read.town->streets_m, 30);
    ASSERT_EQ(read.stage->flyers.size(), 1u);
    const ScenarioFlyer &owl = read.stage->flyers[0];
    EXPECT_EQ(owl.name, "owl");
    EXPECT_EQ(owl.clip, "fly");
    EXPECT_EQ(owl.path.size(), 9u);
    EXPECT_EQ(owl.radius_m, 4);
    EXPECT_EQ(owl.every_s, 0.5);
}

TEST(TownSection, IsRefusedWithItsPlace)
{
    expect_refused("market_day = true", "market_day = 3", "8:", "market_day");
    expect_refused("market_day = true", "streets_m = 500", "8:", "150");
    expect_refused("market_day = true", "stalls = 4", "8:", "stalls");
    expect_refused("[town]\nseed = 7\nmarket_day = true\n", "", "", "rectangle");
}

TEST(Flyer, IsRefusedWithItsPlace)
{
    expect_refused(", 9.0]", "]", "24:", "8 numbers");
    expect_refused("[0.0, 5.0, 0.0, 9.0, 6.0, 0.0, 4.0, 7.0, 9.0]", "[0.0, 5.0, 0.0]", "24:", "3 numbers");
    expect_refused("sends = \"startle\"\n", "", "25:", "sends");
    expect_refused("scale = 0.5", "scale = 0.0", "23:", "scale");
    expect_refused("character = \"owl\"\n", "", "", "character");
}
