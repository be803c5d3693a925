// The sections of a scenario file. Each is read by a file of its own: a new one is a reader here and a line in
// sections.cpp. A section's reader takes its key from the top of the file, refuses every key in it that it does not
// know, and may look at what earlier sections said.
#pragma once

#include "samples/scenes/odeon/toml_table.h"
#include "samples/scenes/scenario/scenario.h"

namespace scenes
{

struct ScenarioSection {
    const char *key;
    void (*read)(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
};

// In the order in which they are read.
const std::vector<ScenarioSection> &scenario_sections();

void read_characters(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_theatre(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_tracks(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_staging(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_town(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_flyers(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_places(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_navigation(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_doors(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_people(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_agents(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_camera(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_light(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);
void read_ground(TomlTable &all, const ScenarioFiles &files, Scenario &scenario);

// The path of the file that a key names. Throws Failure, with the key's place, if it cannot be read.
std::string file_of(TomlTable &table, const char *key, const ScenarioFiles &files);

// What a character wears and plays, and its file if it is none of claque's own, with how it is placed: also for
// descriptions of one person.
void read_palette(TomlTable &described, SocialClass &made);
void read_clips_and_file(TomlTable &described, const ScenarioFiles &files, SocialClass &made);

// A rectangle [x0, z0, x1, z1], or x and z of the corners of a convex polygon.
Outline read_outline(TomlTable &table, const char *key);
// What [stage] said; refuses the section `key` without one.
Staging &stage_of(TomlTable &all, const char *key, Scenario &scenario);

}  // namespace scenes
