// Reads a scenario: what stands at its top, its sections, and what must hold between them.
#include "samples/io/files.h"
#include "samples/scenes/check.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

// Theatres had no sections, and their people were part of them.
void refuse_former_keys(TomlTable &all)
{
    for (const char *former : {"orchestra", "seats", "rows", "walkways", "gangways"})
        all.renamed(former, "theatre." + std::string(former));
    if (!all.has("agents")) all.renamed("stage", "theatre.stage");
    all.renamed("audience", "characters");
}

void expect_people(TomlTable &all, const Scenario &scenario)
{
    if (scenario.theatre && scenario.tracks)
        all.refuse("has people who sit, [theatre], and people who walk, [tracks]; it needs one of the two", "tracks");
    if (scenario.stage && scenario.tracks)
        all.refuse(
            "has people who decide, [stage], and people on tracks, [tracks], which they would not see and walk "
            "through; it needs one of the two",
            "tracks");
    const bool others = scenario.theatre || scenario.tracks || scenario.stage;
    if (others && !scenario.people.empty())
        all.refuse("has [[people]] with roles and others, in [theatre], [tracks] or [stage]; it needs one of the two",
                   "people");
    if (!others && scenario.people.empty())
        all.refuse("does not say where its people are: it needs [theatre] or [tracks], [stage] or [[people]]");
}

std::string why_not_there(const std::string &path) { return io::RegularFile(path, io::most_file_bytes).wrong(); }

}  // namespace

Scenario read_scenario(const std::string &text, const std::string &where, const ScenarioFiles &files)
{
    const toml::table table = parse_toml(text, where);
    TomlTable all(table, where, "the scenario");
    refuse_former_keys(all);
    Scenario scenario;
    scenario.name = all.text("name");
    if (scenario.name.empty()) all.refuse("has the name \"\"", "name");
    const clq_colours colours = all.has("colours") ? colours_of(all.text("colours")) : CLQ_COLOURS_NEAR;
    if (all.has("colours") && colours == CLQ_COLOURS_NEAR) {
        scenario.colours = file_of(all, "colours", files);
        scenario.colours_at = all.place("colours");
    }
    for (const ScenarioSection &section : scenario_sections())
        if (all.has(section.key)) section.read(all, files, scenario);
    all.done();
    for (SocialClass &one : scenario.characters) one.placement.colours = colours;
    expect_people(all, scenario);
    return scenario;
}

ScenarioFiles files_beside(const std::string &path)
{
    const size_t slash = path.rfind('/');
    return {slash == std::string::npos ? "" : path.substr(0, slash + 1),
            [](const std::string &file, std::string &text) { return io::read_whole(file, text); }, why_not_there};
}

Scenario load_scenario(const std::string &path, const std::string &mechanisms)
{
    std::string text;
    const std::string wrong = io::read_whole(path, text);
    if (!wrong.empty()) throw Failure(wrong);
    std::vector<std::string> found;
    ScenarioFiles files = files_beside(path);
    files.mechanisms = mechanisms;
    files.find = [&](const std::string &file) {
        found.push_back(file);
        return why_not_there(file);
    };
    Scenario scenario = read_scenario(text, path, files);
    scenario.files = found;
    return scenario;
}

const Scenario &odeon_scenario()
{
    // The camera path is embedded like the scenario itself.
    static const Scenario odeon = read_scenario(odeon_description(), "odeon.toml",
                                                {"",
                                                 [](const std::string &, std::string &path) {
                                                     path = *recorded_path("odeon");
                                                     return std::string();
                                                 },
                                                 [](const std::string &) { return std::string(); }});
    return odeon;
}

}  // namespace scenes
