#include "samples/cli/view_open.h"

#include <claque/zones.h>

#include <cmath>
#include <filesystem>

#include "samples/cli/files.h"
#include "samples/scenes/colours.h"
#include "samples/scenes/walkers/people.h"
#include "samples/scenes/walkers/replay.h"
#include "samples/view/designer/line_up.h"

namespace cli
{
namespace
{

// What the view keeps as long as its scene.
struct Kept {
    LoadedCharacter character;
    std::vector<LoadedCharacter> people;
};

constexpr uint32_t people_in_line = 30;

// The people of --characters side by side. Files are read now, built-in people when the scene is made.
void line_up(const ViewWhat &what, scenes::Library &library, Kept &kept, view::Opened &opened)
{
    std::vector<std::string> names = names_in(what.tracks.characters);
    std::vector<scenes::Character> loaded(names.size());
    for (size_t k = 0; k < names.size(); ++k) {
        if (names[k].find_first_of("./") == std::string::npos) continue;
        kept.people.push_back(load_character(library, names[k], what.setup.hidden));
        loaded[k] = kept.people.back().character();
    }
    opened.options.make = [names, loaded](scenes::Library &of, const scenes::CrowdOptions &crowd_options) {
        std::vector<scenes::Character> characters = loaded;
        for (size_t k = 0; k < names.size(); ++k)
            if (!characters[k].tmpl) characters[k] = view::builtin_person(of, names[k], crowd_options.lod);
        return view::make_line_up(of, crowd_options, characters);
    };
    opened.options.crowd_options.count = what.setup.count > 0 ? what.setup.count : people_in_line;
    opened.options.crowd_options.seed = what.setup.seed;
}

bool ends_with(const std::string &text, const std::string &end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_image(const std::string &path)
{
    for (const char *end : {".png", ".jpg", ".jpeg", ".PNG", ".JPG"})
        if (ends_with(path, end)) return true;
    return false;
}

// Whether a TOML file has a table of this name.
bool has_table(const std::string &toml, const std::string &name)
{
    return toml.rfind("[[" + name, 0) == 0 || toml.find("\n[[" + name) != std::string::npos;
}

void take_times(const ViewWhat &what, scenes::Library &library, view::Opened &opened)
{
    if (scenes::walkers::is_record(what.tracks.file)) {
        const scenes::walkers::RecordFile file(library, what.tracks.file);
        opened.first_s = file.info.start_s, opened.last_s = file.info.end_s;
        return;
    }
    clq_trajectories *made = nullptr;
    const clq_trajectories_def def = reading_of(what.tracks);
    scenes::check(clq_trajectories_load(library.context(), what.tracks.file.c_str(), &def, &made), what.tracks.file);
    const scenes::walkers::OwnTrajectories trajectories(made);
    clq_trajectories_info info = clq_trajectories_info_init();
    scenes::check(clq_trajectories_get_info(made, &info));
    opened.last_s = std::max(1.0, info.max_s - info.min_s);
}

// One more texture set, in which the image replaces the first of the character's that it can replace.
void add_texture(scenes::Library &library, clq_asset *asset, const std::string &path)
{
    clq_picture picture = clq_picture_init();
    const clq_status size = clq_image_read(library.context(), path.c_str(), &picture);
    if (size != CLQ_OK && picture.width_px == 0) scenes::check(size, path);
    std::vector<uint8_t> rgba(4 * static_cast<size_t>(picture.width_px) * picture.height_px);
    picture.pixels = rgba.data(), picture.capacity_bytes = rgba.size();
    scenes::check(clq_image_read(library.context(), path.c_str(), &picture), path);
    const uint32_t materials = info_of(asset).material_count;
    clq_status added = CLQ_ARGUMENT;
    for (uint32_t k = 0; k < 2 * materials && added != CLQ_OK; ++k) {
        std::vector<clq_image_def> images(materials, clq_image_def_init());
        clq_image_def &image = images[k % materials];
        image.rgba = rgba.data();
        image.width_px = picture.width_px, image.height_px = picture.height_px;
        image.alpha = k < materials ? CLQ_ALPHA_OPACITY : CLQ_ALPHA_ZONE_KEYS;
        added = clq_asset_add_texture_set(library.context(), asset, path.c_str(), images.data(), materials);
    }
    scenes::check(added, path);
}

LoadedCharacter load_textured(scenes::Library &library, const ViewWhat &what)
{
    if (what.textures.empty())
        return load_character(library, what.setup.file, what.setup.hidden, {}, levels_of_file(what.setup));
    if (is_prepared(what.setup.file))
        throw scenes::Failure(what.setup.file + " is prepared, and takes no other texture");
    LoadedCharacter loaded;
    loaded.asset = load_asset(library, what.setup.file, what.setup.hidden);
    for (const std::string &path : what.textures) add_texture(library, loaded.asset.get(), path);
    clq_template *made = nullptr;
    scenes::check(clq_asset_build(library.context(), loaded.asset.get(), 0, &made), what.setup.file);
    loaded.tmpl.reset(made);
    return loaded;
}

void dress(const ViewWhat &what, scenes::Library &library, const scenes::Scene &scene)
{
    if (!what.textures.empty())
        for (const clq_actor actor : scene.actors()) {
            clq_actor_info info = clq_actor_info_init();
            scenes::check(clq_actor_get_info(scene.crowd(), actor, &info));
            const uint32_t last = info_of(info.tmpl).texture_set_count - 1;
            scenes::check(clq_actor_set_texture_set(scene.crowd(), actor, last));
        }
    if (what.colours.empty()) return;
    const scenes::ColourMap map = scenes::read_colours(library, text_of(what.colours), what.colours);
    scenes::colour(scene, map.get(), what.setup.seed);
}

// Everything that is shown by a subject of its own goes.
ViewWhat with_subject(ViewWhat what)
{
    what.setup.file.clear(), what.setup.scene.clear(), what.setup.scenario.clear(), what.setup.path.clear();
    what.setup.described.reset();
    what.tracks.file.clear();
    what.textures.clear(), what.colours.clear();
    return what;
}

ViewWhat with_toml(ViewWhat what, const std::string &path)
{
    const std::string text = text_of(path);
    if (has_table(text, "classes")) what.colours = path;
    else if (has_table(text, "keys")) what.setup.path = path;
    else {
        what = with_subject(what);
        what.setup.scenario = path;
        read_scenario(what.setup);
    }
    return what;
}

ViewWhat with_file(ViewWhat what, const std::string &path)
{
    if (ends_with(path, ".toml")) return with_toml(what, path);
    if (is_image(path)) {
        if (what.setup.file.empty())
            throw scenes::Failure(path + " is a texture, and no character is shown that could have it");
        what.textures.push_back(path);
        return what;
    }
    what = with_subject(what);
    (is_view_character(path) ? what.setup.file : what.tracks.file) = path;
    return what;
}

}  // namespace

bool lines_up(const ViewWhat &what)
{
    return !what.tracks.characters.empty() && what.tracks.file.empty() && what.setup.file.empty() &&
           what.setup.scene.empty() && what.setup.scenario.empty();
}

bool is_view_character(const std::string &file)
{
    if (ends_with(file, ".glb") || ends_with(file, ".gltf") || is_prepared(file)) return true;
    return file.find('.') == std::string::npos && file.find('/') == std::string::npos;  // a built-in character
}

view::Opened open_view(const ViewWhat &what, scenes::Library &library)
{
    view::Opened opened;
    const auto kept = std::make_shared<Kept>();
    SceneArguments setup = what.setup;
    if (!what.tracks.file.empty()) {
        take_times(what, library, opened);
        const scenes::walkers::Options options = walkers_of(what.tracks);
        const scenes::walkers::ReplayOptions replay = {what.tracks.file, names_in(what.tracks.characters),
                                                       options.follow};
        setup.make = [options, replay](scenes::Library &of, const scenes::CrowdOptions &crowd_options) {
            return scenes::walkers::is_record(replay.file) ? scenes::walkers::make_replay(of, crowd_options, replay)
                                                           : scenes::walkers::make(of, crowd_options, options);
        };
    }
    if (!setup.file.empty()) kept->character = load_textured(library, what);
    if (setup.file.find_first_of("./") != std::string::npos)
        opened.character_file = std::filesystem::absolute(setup.file).string();
    opened.options = scene_options(setup, kept->character);
    if (!opened.options.path && has_path(setup) && setup.make == nullptr) {
        setup.camera = "path";
        opened.options = scene_options(setup, kept->character);
    }
    if (lines_up(what)) line_up(what, library, *kept, opened);
    opened.keeps = kept;
    opened.dress = [what](scenes::Library &of, const scenes::Scene &scene) { dress(what, of, scene); };
    opened.asset_of = [what](scenes::Library &of, const std::string &name) {
        scenes::Own<clq_asset> asset =
            load_asset(of, what.setup.file.empty() ? name : what.setup.file, what.setup.hidden);
        if (!what.setup.file.empty())
            for (const std::string &path : what.textures) add_texture(of, asset.get(), path);
        return asset;
    };
    if (opened.options.path) opened.last_s = std::max(60.0, opened.options.path->end_s());
    return opened;
}

std::function<view::Open(const std::string &path)> view_drops(const ViewWhat &what)
{
    // What is shown now; a file that cannot be shown leaves it.
    const auto shown = std::make_shared<ViewWhat>(what);
    return [shown](const std::string &path) -> view::Open {
        const ViewWhat next = with_file(*shown, path);
        return [shown, next](scenes::Library &library) {
            view::Opened opened = open_view(next, library);
            *shown = next;
            return opened;
        };
    };
}

}  // namespace cli
