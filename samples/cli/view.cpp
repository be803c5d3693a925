// claque view: a window on a scene, a character, a scenario, trajectories or a record.
#include "samples/view/view.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/progress.h"
#include "samples/cli/view_open.h"
#include "samples/io/png.h"
#include "samples/processes/machine_share.h"
#include "samples/scenes/library.h"

namespace cli
{
namespace
{

struct ViewArguments {
    ViewWhat what;
    std::vector<std::string> files;
    std::string script, rates, folder = ".";
    double scale = 1;
    int processes = 1;
    CLI::Option *serve = nullptr;
    std::string place, password_file;
    view::serve::Options served;
};

int strategy_number(const std::string &name) { return static_cast<int>(strategy_named(name)); }

view::Request request_of(const ViewArguments &a, const std::shared_ptr<Progress> &progress)
{
    view::Request request;
    request.title = "claque: " + (lines_up(a.what)            ? a.what.tracks.characters
                                  : a.what.setup.file.empty() ? scene_of(a.what.setup)
                                                              : a.what.setup.file);
    request.open = [what = a.what](scenes::Library &library) { return open_view(what, library); };
    request.drop = view_drops(a.what);
    request.switches.strategy = strategy_number(a.what.setup.strategy);
    request.switches.levels = a.what.setup.lod == "off" ? 0 : 1;
    request.processes = a.processes;
    request.cores_each = processes::cores_of_worker(a.processes, core_count());
    const bool shared = a.processes > 1 && a.what.setup.threads == 0;
    request.switches.threads = shared ? std::min(request.cores_each, 4) : thread_count(a.what.setup);
    request.width = a.what.setup.width, request.height = a.what.setup.height;
    request.scale = static_cast<float>(a.scale);
    request.context = contexts::kind_named(a.what.setup.context).value();
    if (a.serve->count() > 0) request.serve = a.served;
    request.say = [](const std::string &line) { std::cout << line << std::endl; };
    request.folder = {a.folder, request.serve.has_value()};
    request.colours = a.what.colours;
    request.mechanisms = a.what.setup.mechanisms;
    request.script_file = a.script;
    request.rates = a.rates;
    if (!a.script.empty()) request.script = text_of(a.script);
    request.save_picture = [](const std::string &path, const std::vector<uint8_t> &rgb, int width, int height) {
        const std::vector<unsigned char> file =
            io::png(rgb.data(), width, height, {{"Software", "claque " + version()}, {"Description", "claque view"}});
        write_whole(path, file.data(), file.size());
    };
    request.save_text = [](const std::string &path, const std::string &text) { write_whole(path, text); };
    request.progress = [progress](const std::string &what) { progress->phase(what); };
    request.conclude = [progress](const std::string &sentence) { progress->conclude(sentence); };
    return request;
}

void add_view_options(CLI::App &c, const std::shared_ptr<ViewArguments> &a)
{
    c.add_option(
        "FILE", a->files,
        "A character (glTF, GLB, a prepared file, or the name of a built-in one), a scene's name, a scenario, a "
        "file of trajectories (docs/trajectories.md), or a record (docs/records.md); besides these, what could "
        "be dropped on the window: textures and clips (BVH) of the character, a colour map, a camera path");
    c.add_option("--scene", a->what.setup.scene, "Scene to show (default plaza)")->check(scene_names());
    add_scenario_option(c, a->what.setup);
    add_mechanisms_option(c, a->what.setup.mechanisms);
    c.add_option("--count", a->what.setup.count, "Number of people (default: the scene's own)")
        ->check(CLI::Range(1, 1000000));
    add_clip_files(c, a->what.clips);
    add_reading_options(c, a->what.tracks);
    add_walking_options(c, a->what.tracks);
    c.get_option("--characters")
        ->description(
            "Who walks on the tracks of a file, or stands side by side without one: built-in people and "
            "glTF files, with commas");
    c.add_option("--path", a->what.setup.path, "Camera path to follow instead of the scene's own (TOML)")
        ->type_name("FILE");
    add_size_option(c, a->what.setup.width, a->what.setup.height);
    c.add_option("--scale", a->scale, "Size of letters and buttons; 2 for screens of high density")
        ->check(CLI::Range(1.0, 4.0))
        ->capture_default_str();
    add_file_options(c, a->what.setup.of_file);
    c.add_option("--lod", a->what.setup.lod,
                 "People with levels of detail (on) or without (off), where the scene has both")
        ->check(CLI::IsMember({"off", "on"}))
        ->each([a](const std::string &lod) { a->what.setup.file_without_levels = lod == "off"; });
    c.add_option("--seed", a->what.setup.seed, "Seed of everything random")->capture_default_str();
    c.add_option("--threads", a->what.setup.threads, "Threads of the update, through oneTBB (default: the cores)")
        ->check(CLI::Range(1, 4));
    c.add_option("--processes", a->processes,
                 "Draw the picture by this many processes, each a part of it (docs/films.md); pixels do not depend on "
                 "it")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    c.add_option("--script", a->script, "Play a script without a window (docs/view.md)")->type_name("FILE.toml");
    a->serve =
        c.add_option("--serve", a->place,
                     "Serve the window over VNC in place of a screen, at 127.0.0.1:5900 if no other place is given "
                     "(docs/view.md)")
            ->expected(0, 1)
            ->type_name("[ADDRESS:PORT]")
            ->excludes("--script")
            ->excludes("--allow-mechanisms");
    c.add_option("--password-file", a->password_file,
                 "Password of --serve: the first line of a file, exactly 8 letters (default: a new one)")
        ->type_name("FILE")
        ->needs("--serve");
    c.add_option("--origin", a->served.origins,
                 "Pages of this origin may open the window of --serve, besides those of the same host (may repeat)")
        ->expected(1)
        ->take_all()
        ->type_name("SCHEME://HOST[:PORT]")
        ->needs("--serve");
    c.add_option("--rates", a->rates, "What the frames of a measured script cost, as JSON")
        ->type_name("FILE")
        ->needs("--script");
    add_colours_option(c, a->what.colours, a->what.setup.of_file.placement,
                       "Colour map to wear and to design (TOML, docs/colours.md)");
    c.add_option("--shots", a->folder,
                 "Folder of saved pictures, films, camera paths and colour maps (default: the current one)")
        ->type_name("DIR");
    c.add_option("--context", a->what.setup.context,
                 "Source of OpenGL for scripts; any: OSMesa if it is there, else EGL")
        ->check(CLI::IsMember({"any", "osmesa", "egl"}))
        ->capture_default_str();
}

// What follows --serve is a place, or else a file to show.
void read_serving(ViewArguments &a)
{
    if (!a.place.empty() && !view::serve::read_place(a.place, a.served)) {
        if (!a.files.empty())
            throw CLI::ValidationError("--serve", "'" + a.place + "' is no ADDRESS:PORT, as 127.0.0.1:5900 is");
        a.files.push_back(a.place);
    }
    if (a.password_file.empty()) return;
    const std::string text = text_of(a.password_file);
    a.served.password = text.substr(0, text.find_first_of("\r\n"));
    const std::string wrong = view::serve::wrong_password(a.served.password);
    if (!wrong.empty())
        throw CLI::ValidationError("--password-file", "the first line of " + a.password_file + " " + wrong);
}

int subjects_of(const ViewWhat &what)
{
    return !what.setup.file.empty() + !what.setup.scene.empty() + !what.setup.scenario.empty() +
           !what.tracks.file.empty();
}

// A name without an ending is a scene's or a character's.
void expect_known(const std::string &name)
{
    if (name.find_first_of("./") != std::string::npos || scene_names()(name).empty() || scenes::is_builtin(name) ||
        std::filesystem::exists(name))
        return;
    throw CLI::ValidationError("FILE", name + " is no scene (" + list_of_scenes() +
                                           "), no built-in character (citizen, patrician, decurion, plebeian, herald, "
                                           "owl), and no file of that name exists");
}

// First what is shown, then what changes it.
void take_files(ViewArguments &a)
{
    for (const std::string &file : a.files) expect_known(file);
    std::stable_partition(a.files.begin(), a.files.end(), is_subject);
    int subjects = subjects_of(a.what);
    for (const std::string &file : a.files) {
        if (is_subject(file) && ++subjects > 1)
            throw CLI::ValidationError("FILE",
                                       "one scene, scenario, character, record or file of people on tracks can "
                                       "be shown, and '" +
                                           file + "' is one more");
        a.what = with_file(a.what, file);
    }
    const std::vector<std::string> people = names_in(a.what.tracks.characters);
    const bool has_file = !a.what.setup.file.empty() || std::any_of(people.begin(), people.end(), scenes::is_file);
    if (!a.what.clips.files.empty() && !has_file)
        throw CLI::ValidationError("--clips", "no character of a file is shown that could have them: name one as FILE");
}

void check_view_usage(const CLI::App &command, ViewArguments &a)
{
    read_serving(a);
    take_files(a);
    if (a.what.tracks.file.empty()) refuse_walking_options(command);
    if (!std::filesystem::is_directory(a.folder))
        throw scenes::Failure("--shots: there is no folder " + a.folder + ", in which pictures could be saved");
    if (subjects_of(a.what) > 0 && a.what.tracks.file.empty() && !a.what.tracks.characters.empty())
        throw CLI::ValidationError("--characters", "line up by themselves, or walk on the tracks of a file");
    if (subjects_of(a.what) > 1) throw CLI::ValidationError("--scene", "--scene and --scenario exclude each other");
    read_scenario(a.what.setup);
    if (a.what.tracks.file.empty() && !lines_up(a.what)) check_scene_usage(a.what.setup);
}

}  // namespace

void add_view(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<ViewArguments>();
    a->what.setup.width = 1280, a->what.setup.height = 800;
    a->what.setup.lod = "on";
    a->what.setup.threads = 0;
    CLI::App *c = app.add_subcommand("view",
                                     "Open a window on a crowd: watch it, pick people, test a character, "
                                     "see what a frame costs");
    add_view_options(*c, a);
    c->callback([a, c, &chosen] {
        check_view_usage(*c, *a);
        chosen = [a] {
            if (a->folder != ".") expect_writable(a->folder + "/view-1.png");
            const auto progress = std::make_shared<Progress>("claque");
            view::run(request_of(*a, progress));
        };
    });
}

}  // namespace cli
