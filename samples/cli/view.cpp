// claque view: a window on a scene, a character, a scenario, trajectories or a record.
#include "samples/view/view.h"

#include <cmath>

#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/png.h"
#include "samples/cli/progress.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/track_arguments.h"
#include "samples/scenes/walkers/replay.h"
#include "samples/view/designer/line_up.h"

namespace cli
{
namespace
{

struct ViewArguments {
    SceneArguments setup;
    TrackArguments tracks;
    std::string script, colours, folder = ".";
    double scale = 1;
};

// What the view keeps as long as its scene.
struct Kept {
    LoadedCharacter character;
    std::vector<LoadedCharacter> people;
};

constexpr uint32_t people_in_line = 30;

bool lines_up(const ViewArguments &a) { return a.tracks.file.empty() && !a.tracks.characters.empty(); }

// The people of --characters side by side. Files are read now, built-in people when the scene is made.
void line_up(const ViewArguments &a, scenes::Library &library, Kept &kept, view::Opened &opened)
{
    std::vector<std::string> names = names_in(a.tracks.characters);
    std::vector<scenes::Character> loaded(names.size());
    for (size_t k = 0; k < names.size(); ++k) {
        if (names[k].find_first_of("./") == std::string::npos) continue;
        kept.people.push_back(load_character(library, names[k], a.setup.hidden));
        loaded[k] = kept.people.back().character();
    }
    opened.options.make = [names, loaded](scenes::Library &of, const scenes::CrowdOptions &crowd_options) {
        std::vector<scenes::Character> characters = loaded;
        for (size_t k = 0; k < names.size(); ++k)
            if (!characters[k].tmpl) characters[k] = view::builtin_person(of, names[k], crowd_options.lod);
        return view::make_line_up(of, crowd_options, characters);
    };
    opened.options.crowd_options.count = a.setup.count > 0 ? a.setup.count : people_in_line;
    opened.options.crowd_options.seed = a.setup.seed;
}

bool ends_with(const std::string &text, const std::string &end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Files that are no character are trajectories, or a record.
bool is_character(const std::string &file)
{
    for (const char *end : {".glb", ".gltf", ".clq"})
        if (ends_with(file, end)) return true;
    return file.find('.') == std::string::npos && file.find('/') == std::string::npos;  // a built-in character
}

void take_times(const ViewArguments &a, scenes::Library &library, view::Opened &opened)
{
    if (scenes::walkers::is_record(a.tracks.file)) {
        const scenes::walkers::RecordFile file(library, a.tracks.file);
        opened.first_s = file.info.start_s, opened.last_s = file.info.end_s;
        return;
    }
    clq_trajectories *made = nullptr;
    const clq_trajectories_def def = reading_of(a.tracks);
    scenes::check(clq_trajectories_load(library.context(), a.tracks.file.c_str(), &def, &made), a.tracks.file);
    clq_trajectories_info info = clq_trajectories_info_init();
    const clq_status status = clq_trajectories_get_info(made, &info);
    clq_trajectories_destroy(made);
    scenes::check(status);
    opened.last_s = std::max(1.0, info.max_s - info.min_s);
}

view::Opened open(const ViewArguments &a, scenes::Library &library)
{
    view::Opened opened;
    const auto kept = std::make_shared<Kept>();
    SceneArguments setup = a.setup;
    if (!a.tracks.file.empty()) {
        take_times(a, library, opened);
        const scenes::walkers::Options options = walkers_of(a.tracks);
        const scenes::walkers::ReplayOptions replay = {a.tracks.file, names_in(a.tracks.characters), options.follow};
        setup.make = [options, replay](scenes::Library &of, const scenes::CrowdOptions &crowd_options) {
            return scenes::walkers::is_record(replay.file) ? scenes::walkers::make_replay(of, crowd_options, replay)
                                                           : scenes::walkers::make(of, crowd_options, options);
        };
    }
    if (!setup.file.empty()) kept->character = load_character(library, setup.file, setup.hidden);
    opened.options = scene_options(setup, kept->character);
    if (!opened.options.path && has_path(setup) && setup.make == nullptr) {
        setup.camera = "path";
        opened.options = scene_options(setup, kept->character);
    }
    if (lines_up(a)) line_up(a, library, *kept, opened);
    opened.keeps = kept;
    if (opened.options.path) opened.last_s = std::max(60.0, opened.options.path->end_s());
    return opened;
}

int strategy_number(const std::string &name) { return static_cast<int>(strategy_named(name)); }

view::Request request_of(const ViewArguments &a, const std::shared_ptr<Progress> &progress)
{
    view::Request request;
    request.title = "claque: " + (lines_up(a)            ? a.tracks.characters
                                  : a.setup.file.empty() ? scene_of(a.setup)
                                                         : a.setup.file);
    request.open = [a](scenes::Library &library) { return open(a, library); };
    request.switches.strategy = strategy_number(a.setup.strategy);
    request.switches.levels = a.setup.lod == "off" ? 0 : 1;
    request.switches.threads = thread_count(a.setup);
    request.width = a.setup.width, request.height = a.setup.height;
    request.scale = static_cast<float>(a.scale);
    request.context = a.setup.context == "osmesa" ? contexts::Kind::osmesa
                      : a.setup.context == "egl"  ? contexts::Kind::egl
                                                  : contexts::Kind::any;
    request.folder = a.folder;
    request.colours = a.colours;
    request.script_file = a.script;
    if (!a.script.empty()) request.script = text_of(a.script);
    request.save_picture = [](const std::string &path, const std::vector<uint8_t> &rgb, int width, int height) {
        const std::vector<unsigned char> file =
            png(rgb.data(), width, height, {{"Software", "claque " + version()}, {"Description", "claque view"}});
        write_whole(path, file.data(), file.size());
    };
    request.save_text = [](const std::string &path, const std::string &text) { write_whole(path, text); };
    request.progress = [progress](const std::string &what) { progress->phase(what); };
    request.conclude = [progress](const std::string &sentence) { progress->conclude(sentence); };
    return request;
}

void add_view_options(CLI::App &c, const std::shared_ptr<ViewArguments> &a)
{
    c.add_option("FILE", a->setup.file,
                 "A character (glTF, GLB, a prepared file, or the name of a built-in one), a file of trajectories "
                 "(docs/trajectories.md), or a record (docs/records.md)");
    c.add_option("--scene", a->setup.scene, "Scene to show (default plaza)")->check(scene_names());
    add_scenario_option(c, a->setup);
    c.add_option("--count", a->setup.count, "Number of people (default: the scene's own)")
        ->check(CLI::Range(1, 1000000));
    add_hide_option(c, a->setup);
    add_reading_options(c, a->tracks);
    add_walking_options(c, a->tracks);
    c.add_option("--path", a->setup.path, "Camera path to follow instead of the scene's own (TOML)")->type_name("FILE");
    add_size_option(c, a->setup.width, a->setup.height);
    c.add_option("--scale", a->scale, "Size of letters and buttons; 2 for screens of high density")
        ->check(CLI::Range(1.0, 4.0))
        ->capture_default_str();
    c.add_option("--lod", a->setup.lod, "People with levels of detail (on) or without (off), where the scene has both")
        ->check(CLI::IsMember({"off", "on"}));
    c.add_option("--seed", a->setup.seed, "Seed of everything random")->capture_default_str();
    c.add_option("--threads", a->setup.threads, "Threads of the update, through oneTBB (default: the cores)")
        ->check(CLI::Range(1, 4));
    c.add_option("--script", a->script, "Play a script without a window (docs/view.md)")->type_name("FILE.toml");
    c.add_option("--colours", a->colours, "Colour map to wear and to design (TOML, docs/colours.md)")
        ->type_name("FILE");
    c.add_option("--shots", a->folder,
                 "Folder of saved pictures, camera paths and colour maps (default: the current one)")
        ->type_name("DIR");
    c.add_option("--context", a->setup.context, "Source of OpenGL for scripts; any: OSMesa if it is there, else EGL")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
}

void check_view_usage(ViewArguments &a)
{
    const int subjects = !a.setup.file.empty() + !a.setup.scene.empty() + !a.setup.scenario.empty();
    if (subjects > 0 && lines_up(a) && (a.setup.file.empty() || is_character(a.setup.file)))
        throw CLI::ValidationError("--characters", "line up by themselves, or walk on the tracks of a file");
    if (subjects > 1) throw CLI::ValidationError("FILE", "--scene and --scenario exclude each other");
    if (!a.setup.file.empty() && !is_character(a.setup.file)) std::swap(a.tracks.file, a.setup.file);
    read_scenario(a.setup);
    if (a.tracks.file.empty()) check_scene_usage(a.setup);
}

}  // namespace

void add_view(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<ViewArguments>();
    a->setup.width = 1280, a->setup.height = 800;
    a->setup.lod = "on";
    a->setup.threads = 0;
    CLI::App *c = app.add_subcommand("view",
                                     "Open a window on a crowd: watch it, pick people, test a character, "
                                     "see what a frame costs");
    add_view_options(*c, a);
    c->callback([a, &chosen] {
        check_view_usage(*a);
        chosen = [a] {
            const auto progress = std::make_shared<Progress>("claque");
            view::run(request_of(*a, progress));
        };
    });
}

}  // namespace cli
