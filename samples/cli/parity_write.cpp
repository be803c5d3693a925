// claque parity export and capture: a crowd for another renderer, and the result of the CPU path for the same time.
#include <algorithm>
#include <cmath>
#include <memory>

#include "samples/cli/parity.h"
#include "samples/cli/progress.h"
#include "samples/cli/scene_arguments.h"
#include "samples/parity/write/write.h"

namespace cli
{
namespace
{

struct ParityArguments {
    SceneArguments setup;
    ClipArguments clips;
    std::string subject, out;
    double time_s = 2;
};

using Writer = size_t (*)(scenes::SceneRenderer &, const parity::CaptureTime &, const std::string &);

// The subject is a scene's name, or else a character.
void take_subject(ParityArguments &a)
{
    if (a.subject.empty()) return;
    const std::vector<scenes::SceneEntry> &entries = scenes::scene_entries();
    const bool is_scene = std::any_of(entries.begin(), entries.end(),
                                      [&](const scenes::SceneEntry &entry) { return a.subject == entry.name; });
    (is_scene ? a.setup.scene : a.setup.file) = a.subject;
}

std::string words_about(const ParityArguments &a, const scenes::SceneOptions &options)
{
    const char *shots[] = {"overview", "close", "path"};
    return (a.subject.empty() ? scene_of(a.setup) : a.subject) + ", camera " + shots[static_cast<int>(options.shot)] +
           ", count " + std::to_string(options.crowd_options.count) + ", seed " + std::to_string(a.setup.seed) +
           ", lod " + a.setup.lod;
}

void write(const ParityArguments &a, Writer writer)
{
    Progress progress("claque parity");
    progress.phase("preparing");
    scenes::Library library(thread_count(a.setup));
    LoadedCharacter loaded;
    if (!a.setup.file.empty())
        loaded = load_character(library, a.setup.file, a.setup.of_file, a.clips,
                                a.setup.lod == "off" ? scenes::Lod::off : scenes::Lod::on);
    const scenes::SceneOptions options = scene_options(a.setup, loaded);
    scenes::SceneRenderer scene_renderer(library, options);
    const size_t count =
        writer(scene_renderer, {words_about(a, options), a.time_s, options.width, options.height}, a.out);
    progress.conclude(a.out + ": " + std::to_string(count) + " individuals, " + scene_renderer.context_name());
}

void check_usage(ParityArguments &a)
{
    expect_subject(a.subject, a.setup);
    take_subject(a);
    read_scenario(a.setup);
    if ((!a.clips.files.empty() || a.clips.vary > 0) && a.setup.file.empty())
        throw CLI::ValidationError("--clips", "and --vary need a FILE, the character that gets the clips");
    check_scene_usage(a.setup);
    if (a.setup.format != "rgba8888") throw CLI::ValidationError("--format", "parity needs 8 bits a channel: rgba8888");
    if (!std::isfinite(a.time_s)) throw CLI::ValidationError("--time", "must be finite");
}

void add_writer(CLI::App &parity, Work &chosen, const char *name, const char *about, Writer writer)
{
    auto a = std::make_shared<ParityArguments>();
    CLI::App *c = parity.add_subcommand(name, about);
    c->add_option("SCENE", a->subject,
                  "A scene of claque render --scene, or a character to stand on a ground: glTF, GLB, prepared .clq, or "
                  "the name of a built-in character");
    add_scenario_option(*c, a->setup);
    c->add_option("--count", a->setup.count, "Individuals (default 12 of a FILE, else the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    a->setup.flat_triangles = 0;  // lit smoothly, as in other renderers
    a->setup.lod = "off";         // which have no levels to compare
    add_file_options(*c, a->setup.of_file);
    add_scene_options(*c, a->setup);
    add_clip_options(*c, a->clips);
    c->add_option("--lod", a->setup.lod,
                  "On the plaza and in the odeon: people with levels of detail (on), without (off), or only the first "
                  "level (finest)")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->capture_default_str();
    c->add_option("--time", a->time_s, "Time of the picture in seconds")->capture_default_str();
    c->add_option("--out,-o", a->out, "A folder, created if missing")->required();
    c->callback([a, &chosen, writer] {
        check_usage(*a);
        chosen = [a, writer] { write(*a, writer); };
    });
}

}  // namespace

void add_parity_export(CLI::App &parity, Work &chosen)
{
    add_writer(parity, chosen, "export",
               "Write a scene for another renderer into a folder: meshes as glTF, arrays and JSON (docs/parity.md)",
               parity::write_scene);
}

void add_parity_capture(CLI::App &parity, Work &chosen)
{
    add_writer(parity, chosen, "capture",
               "Write the result of the CPU path into a folder: skinned vertices, ids, depth, colour",
               parity::write_result);
}

}  // namespace cli
