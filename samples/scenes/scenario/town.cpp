// [town] and [[flyers]]: a setting for people who decide, and what flies over them.
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits flown_m = {-1e5, 1e5};
constexpr size_t most_flyers = 1000;

ScenarioFlyer read_flyer(TomlTable &described)
{
    ScenarioFlyer made;
    made.at = described.place();
    made.character = described.text("character");
    made.name = described.has("name") ? described.text("name") : made.character;
    if (described.has("clip")) made.clip = described.text("clip");
    made.path = described.numbers("path", flown_m);
    if (made.path.size() < 9 || made.path.size() > 3000 || made.path.size() % 3)
        described.refuse("has a 'path' of " + std::to_string(made.path.size()) +
                             " numbers; it needs x, y and z of 3 to 1000 corners",
                         "path");
    if (described.has("speed_m_s")) made.speed_m_s = described.number("speed_m_s", {0.1, 100});
    if (described.has("scale")) made.scale = described.number("scale", {0.01, 100});
    if (described.has("sends")) made.sends = described.text("sends");
    if (made.sends.empty())
        for (const char *key : {"radius_m", "every_s"})
            described.expect_no(key, "which goes with 'sends', the event for those near it");
    if (described.has("radius_m")) made.radius_m = described.number("radius_m", {0.1, 1000});
    if (described.has("every_s")) made.every_s = described.number("every_s", {0.05, 3600});
    described.done();
    return made;
}

}  // namespace

void read_town(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    stage_of(all, "town", scenario);
    if (scenario.theatre) all.refuse("has a theatre and a town; it needs one of the two", "town");
    TomlTable described = all.table("town", "[town]");
    ScenarioTown made;
    if (described.has("seed")) made.seed = described.whole("seed", {0, 4294967295.0});
    if (described.has("market_day")) made.market_day = described.flag("market_day");
    if (described.has("streets_m")) made.streets_m = described.number("streets_m", {0, 150});
    described.done();
    scenario.town = made;
}

void read_flyers(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    Staging &stage = stage_of(all, "flyers", scenario);
    for (TomlTable &described : all.tables("flyers", "[[flyers]]")) {
        stage.flyers.push_back(read_flyer(described));
        if (stage.flyers.size() > most_flyers)
            described.refuse("is one too many: a scenario has at most " + std::to_string(most_flyers) + " flyers");
    }
}

}  // namespace scenes
