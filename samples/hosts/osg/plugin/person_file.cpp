#include "samples/hosts/osg/plugin/person_file.h"

#include "samples/io/files.h"
#include "samples/scenes/check.h"
#include "samples/scenes/scenario/sections.h"

namespace osg_plugin
{
namespace
{

using scenes::TomlTable;

Gait gait_of(TomlTable &all)
{
    if (!all.has("gait")) return Gait::walk;
    const std::string name = all.text("gait");
    if (name != "walk" && name != "run") all.refuse("has the gait '" + name + "': walk or run", "gait");
    return name == "run" ? Gait::run : Gait::walk;
}

void read_colour_map(TomlTable &all, const scenes::ScenarioFiles &files, PersonFile &out)
{
    if (all.has("colours") && all.has("palette"))
        all.refuse("has a colour map, 'colours', and a palette of its own; it needs one of the two", "palette");
    if (all.has("colours")) {
        out.colours = scenes::file_of(all, "colours", files);
        out.colours_at = all.place("colours");
    }
    if (!all.has("class")) return;
    out.colour_class = all.text("class");
    if (out.colours.empty()) all.refuse("names a class, and no colour map, 'colours', that has it", "class");
}

}  // namespace

std::optional<PersonFile> read_person(const std::string &path)
{
    std::string text;
    const std::string wrong = io::read_whole(path, text);
    if (!wrong.empty()) throw scenes::Failure(wrong);
    const toml::table table = scenes::parse_toml(text, path);
    if (!table.contains("character")) return {};
    const scenes::ScenarioFiles files = scenes::files_beside(path);
    TomlTable all(table, path, "the person");
    PersonFile out;
    out.looks.at = all.place();
    out.looks.name = out.looks.character = all.text("character");
    scenes::read_palette(all, out.looks);
    scenes::read_clips_and_file(all, files, out.looks);
    out.gait = gait_of(all);
    read_colour_map(all, files, out);
    all.done();
    return out;
}

}  // namespace osg_plugin
