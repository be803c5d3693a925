#include "samples/cli/view_files.h"

#include <algorithm>

#include "samples/cli/characters.h"
#include "samples/cli/files.h"
#include "samples/io/ending.h"

namespace cli
{
namespace
{

bool ends_with_one_of(const std::string &path, std::initializer_list<const char *> endings)
{
    return std::find(endings.begin(), endings.end(), io::ending_of(path)) != endings.end();
}

bool is_image(const std::string &path) { return ends_with_one_of(path, {".png", ".jpg", ".jpeg"}); }
bool is_motion(const std::string &path) { return ends_with_one_of(path, {".bvh", ".vrma"}); }

// Whether a TOML file has a table of this name.
bool has_table(const std::string &path, const std::string &name)
{
    if (io::ending_of(path) != ".toml") return false;
    const std::string toml = text_of(path);
    return toml.rfind("[[" + name, 0) == 0 || toml.find("\n[[" + name) != std::string::npos;
}

bool is_camera_path(const std::string &path) { return !is_colour_map(path) && has_table(path, "keys"); }

bool is_name(const std::string &text) { return text.find_first_of("./") == std::string::npos; }

bool names_scene(const std::string &text)
{
    const std::vector<scenes::SceneEntry> &all = scenes::scene_entries();
    return std::any_of(all.begin(), all.end(), [&](const scenes::SceneEntry &one) { return one.name == text; });
}

void expect_character(const ViewWhat &what, const std::string &path, const char *does)
{
    if (what.setup.file.empty())
        throw scenes::Failure(path + " " + does + ", and no character is shown that could have it");
}

}  // namespace

bool is_view_character(const std::string &file) { return is_name(file) || is_character_file(file); }

bool is_colour_map(const std::string &path) { return has_table(path, "classes"); }

bool is_subject(const std::string &path)
{
    return !is_image(path) && !is_motion(path) && !is_colour_map(path) && !is_camera_path(path);
}

ViewWhat with_file(ViewWhat what, const std::string &path)
{
    if (is_image(path)) {
        expect_character(what, path, "is a texture");
        what.textures.push_back(path);
    } else if (is_motion(path)) {
        expect_character(what, path, "is a motion");
        what.clips.files.push_back(path);
    } else if (is_colour_map(path)) what.colours = path;
    else if (is_camera_path(path)) what.setup.path = path;
    else if (io::ending_of(path) == ".toml") what.setup.scenario = path;
    else if (names_scene(path)) what.setup.scene = path;
    else (is_view_character(path) ? what.setup.file : what.tracks.file) = path;
    return what;
}

ViewWhat with_dropped(ViewWhat what, const std::string &path)
{
    if (is_motion(path)) {  // first, so that the first person plays it
        what = with_file(std::move(what), path);
        std::rotate(what.clips.files.begin(), what.clips.files.end() - 1, what.clips.files.end());
        return what;
    }
    if (!is_subject(path)) return with_file(std::move(what), path);
    what.setup.file.clear(), what.setup.scene.clear(), what.setup.scenario.clear(), what.setup.path.clear();
    what.setup.described.reset();
    what.setup.mechanisms.clear();  // allowed for what the command line names
    what.tracks.file.clear();
    what.textures.clear(), what.clips.files.clear();
    what = with_file(std::move(what), path);
    read_scenario(what.setup);
    return what;
}

}  // namespace cli
