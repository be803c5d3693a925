#include "samples/cli/view_open.h"

#include <claque/zones.h>

#include <cmath>
#include <filesystem>

#include "samples/cli/view_files.h"
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
        kept.people.push_back(load_character(library, names[k], what.setup.of_file, what.clips));
        loaded[k] = kept.people.back().character();
        if (what.setup.count != 1) scenes::warn_of_likeness(library, loaded[k].tmpl);
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

void take_times(const ViewWhat &what, scenes::Library &library, view::Opened &opened)
{
    if (scenes::walkers::is_record(what.tracks.file)) {
        const scenes::walkers::RecordFile file(library, what.tracks.file);
        opened.first_s = file.info.start_s, opened.last_s = file.info.end_s;
        return;
    }
    clq_trajectories *made = nullptr;
    const clq_trajectories_def def = reading_of(what.tracks);
    scenes::check(clq_trajectories_load(library.context(), what.tracks.file.c_str(), &def, &made));
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
        return load_character(library, what.setup.file, what.setup.of_file, what.clips, levels_of_file(what.setup));
    if (is_prepared(what.setup.file))
        throw scenes::Failure(what.setup.file + " is prepared, and takes no other texture");
    LoadedCharacter loaded;
    const FileArguments of_file = in_own_size(what.setup.of_file, what.setup.file);
    loaded.asset = load_asset(library, what.setup.file, of_file, what.clips, &loaded.first_clip);
    for (const std::string &path : what.textures) add_texture(library, loaded.asset.get(), path);
    clq_template *made = nullptr;
    scenes::check(clq_asset_build(library.context(), loaded.asset.get(), 0, &made), what.setup.file);
    loaded.tmpl.reset(made);
    return loaded;
}

void dress(const ViewWhat &what, const scenes::Scene &scene)
{
    if (what.textures.empty()) return;
    for (const clq_actor actor : scene.actors()) {
        clq_actor_info info = clq_actor_info_init();
        scenes::check(clq_actor_get_info(scene.crowd(), actor, &info));
        const uint32_t last = info_of(info.tmpl).texture_set_count - 1;
        scenes::check(clq_actor_set_texture_set(scene.crowd(), actor, last));
    }
}

}  // namespace

bool lines_up(const ViewWhat &what)
{
    return !what.tracks.characters.empty() && what.tracks.file.empty() && what.setup.file.empty() &&
           what.setup.scene.empty() && what.setup.scenario.empty();
}

view::Opened open_view(const ViewWhat &what, scenes::Library &library)
{
    view::Opened opened;
    const auto kept = std::make_shared<Kept>();
    SceneArguments setup = what.setup;
    if (!what.tracks.file.empty()) {
        take_times(what, library, opened);
        const scenes::walkers::Options options = walkers_of(what.tracks, what.setup.of_file.placement);
        const scenes::walkers::ReplayOptions replay = {what.tracks.file, options.characters, options.follow};
        setup.make = [options, replay](scenes::Library &of, const scenes::CrowdOptions &crowd_options) {
            return scenes::walkers::is_record(replay.file) ? scenes::walkers::make_replay(of, crowd_options, replay)
                                                           : scenes::walkers::make(of, crowd_options, options);
        };
    }
    if (!setup.file.empty()) kept->character = load_textured(library, what);
    if (setup.file.find_first_of("./") != std::string::npos)
        opened.character_file = std::filesystem::absolute(setup.file).string(),
        opened.placement = setup.of_file.placement;
    opened.options = scene_options(setup, kept->character);
    if (!opened.options.path && has_path(setup) && setup.make == nullptr) {
        setup.camera = "path";
        opened.options = scene_options(setup, kept->character);
        // A path of the scene itself is there to be chosen: it need not stay with the people.
        opened.begins_on_path = setup.described || !setup.path.empty();
    }
    if (lines_up(what)) line_up(what, library, *kept, opened);
    opened.keeps = kept;
    opened.dress = [what](scenes::Library &, const scenes::Scene &scene) { dress(what, scene); };
    opened.asset_of = [what](scenes::Library &of, const std::string &name) {
        if (what.setup.file.empty()) return load_asset(of, name);
        const FileArguments of_file = in_own_size(what.setup.of_file, what.setup.file);
        scenes::Own<clq_asset> asset = load_asset(of, what.setup.file, of_file, what.clips);
        for (const std::string &path : what.textures) add_texture(of, asset.get(), path);
        return asset;
    };
    if (opened.options.path) opened.last_s = std::max(60.0, opened.options.path->end_s());
    return opened;
}

view::Drop view_drops(const ViewWhat &what)
{
    // What is shown now; a file that cannot be shown leaves it.
    const auto shown = std::make_shared<ViewWhat>(what);
    return [shown](const std::string &path) -> view::Dropped {
        const ViewWhat next = with_dropped(*shown, path);
        if (is_colour_map(path)) return {nullptr, path};
        return {[shown, next](scenes::Library &library) {
                    view::Opened opened = open_view(next, library);
                    *shown = next;
                    return opened;
                },
                ""};
    };
}

}  // namespace cli
