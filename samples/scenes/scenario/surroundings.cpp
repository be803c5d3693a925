// [camera], [light] and [ground].
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits any_direction = {-1000, 1000}, of_lights = {0, 2}, of_surfaces = {0, 1};
constexpr double lowest_deg = 5, highest_deg = 85;  // of the sun, so that shadows have an end and a direction

Rgb colour_of(TomlTable &table, const char *key, Limits limits)
{
    const auto rgb = table.triple(key, limits, "[red, green, blue]");
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

void read_path(TomlTable &camera, const ScenarioFiles &files, Scenario &scenario)
{
    if (!camera.has("path")) {
        scenario.path.emplace(camera);
        return;
    }
    const std::string path = file_of(camera, "path", files);
    std::string text;
    const std::string wrong = files.read(path, text);
    if (!wrong.empty()) camera.refuse("names a path that cannot be read: " + wrong, "path");
    camera.done();
    scenario.path.emplace(text, path);
}

}  // namespace

void read_camera(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    TomlTable camera = all.table("camera", "[camera]");
    if (!camera.has("follow")) return read_path(camera, files, scenario);
    if (!all.has("tracks")) camera.refuse("follows a person, who has to walk; it needs [tracks], or a path", "follow");
    scenario.follow = camera.text("follow");
    scenario.follow_at = camera.place("follow");
    if (scenario.follow.empty()) camera.refuse("follows a person without an id", "follow");
    camera.done();
}

void read_light(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    TomlTable light = all.table("light", "[light]");
    Daylight made;
    if (light.has("to_sun")) {
        const auto sun = light.triple("to_sun", any_direction, "[x, y, z]");
        const double level = std::sqrt(sun[0] * sun[0] + sun[2] * sun[2]);
        const double height_deg = std::atan2(sun[1], level) / radians;
        if (!(height_deg >= lowest_deg && height_deg <= highest_deg))
            light.refuse("has its sun " + show(height_deg) + " degrees above the horizon; it needs " +
                             show(lowest_deg) + " to " + show(highest_deg),
                         "to_sun");
        made.to_sun = {static_cast<float>(sun[0]), static_cast<float>(sun[1]), static_cast<float>(sun[2])};
    }
    if (light.has("sun")) made.sun = colour_of(light, "sun", of_lights);
    if (light.has("sky")) made.sky = colour_of(light, "sky", of_lights);
    if (light.has("bounce")) made.bounce = colour_of(light, "bounce", of_lights);
    light.done();
    scenario.light = made;
}

void read_ground(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    TomlTable ground = all.table("ground", "[ground]");
    if (ground.has("paving")) scenario.paving = colour_of(ground, "paving", of_surfaces);
    if (!all.has("tracks"))
        for (const char *key : {"around", "area"})
            if (!scenario.stage || scenario.theatre || std::string(key) == "area")
                ground.expect_no(key, scenario.stage && !scenario.theatre
                                          ? "which goes with [tracks]; people who decide have it in [navigation]"
                                          : "which goes with [tracks]; a theatre stands on its own ground");
    if (ground.has("around")) scenario.around = colour_of(ground, "around", of_surfaces);
    if (ground.has("area")) {
        scenario.area = file_of(ground, "area", files);
        scenario.area_at = ground.place("area");
    }
    ground.done();
}

}  // namespace scenes
