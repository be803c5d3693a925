// claque parity export and capture: a crowd for somebody else's renderer, and what the CPU path made of the same moment.
#include "samples/cli/parity.h"
#include "samples/cli/progress.h"
#include "samples/cli/stage_arguments.h"
#include "samples/parity/write/write.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace cli
{
namespace
{

struct ParityArguments {
    StageArguments stage;
    ClipArguments clips;
    std::string subject, out;
    double time_s = 2;
};

using Writer = size_t (*)(scenes::Stage &, const parity::Moment &, const std::string &);

// A scene's name, or else a character.
void take_subject(ParityArguments &a)
{
    const std::vector<scenes::SceneEntry> &entries = scenes::scene_entries();
    const bool is_scene = std::any_of(entries.begin(), entries.end(),
                                      [&](const scenes::SceneEntry &entry) { return a.subject == entry.name; });
    (is_scene ? a.stage.scene : a.stage.file) = a.subject;
}

std::string words_about(const ParityArguments &a, const scenes::StageOptions &options)
{
    const char *shots[] = {"overview", "close", "path"};
    return a.subject + ", camera " + shots[static_cast<int>(options.shot)] + ", count " +
           std::to_string(options.casting.count) + ", seed " + std::to_string(a.stage.seed) + ", lod " + a.stage.lod;
}

void write(const ParityArguments &a, Writer writer)
{
    Progress progress("claque parity");
    progress.phase("preparing");
    scenes::Library library(thread_count(a.stage));
    LoadedCharacter loaded;
    if (!a.stage.file.empty()) loaded = load_character(library, a.stage.file, a.stage.hidden, a.clips);
    const scenes::StageOptions options = stage_options(a.stage, loaded);
    scenes::Stage stage(library, options);
    const size_t count = writer(stage, {words_about(a, options), a.time_s, options.width, options.height}, a.out);
    progress.conclude(a.out + ": " + std::to_string(count) + " individuals, " + stage.context_name());
}

void check_usage(ParityArguments &a)
{
    take_subject(a);
    if ((!a.clips.files.empty() || a.clips.vary > 0) && a.stage.file.empty())
        throw CLI::ValidationError("--clips", "and --vary need a FILE whose character gets them");
    check_stage_usage(a.stage);
    if (a.stage.format != "rgba8888")
        throw CLI::ValidationError("--format", "parity wants 8 bits a channel, which rgba8888 has");
    if (!std::isfinite(a.time_s)) throw CLI::ValidationError("--time", "has to be finite");
}

void add_writer(CLI::App &parity, Work &chosen, const char *name, const char *about, Writer writer)
{
    auto a = std::make_shared<ParityArguments>();
    CLI::App *c = parity.add_subcommand(name, about);
    c->add_option("SCENE", a->subject,
                  "A scene by name, as claque render --scene has them, or a character that stands on a ground: glTF, "
                  "GLB, prepared .clq, or a built-in figure's name")
        ->required();
    c->add_option("--count", a->stage.count, "Individuals (default 12 of a FILE, else the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    a->stage.flat_triangles = 0;  // lit smoothly, as other renderers do
    add_stage_options(*c, a->stage);
    add_clip_options(*c, a->clips);
    c->add_option(
         "--lod", a->stage.lod,
         "On the plaza and in the odeon: people with levels of detail, or without; finest: the first level, everywhere")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->capture_default_str();
    c->add_option("--time", a->time_s, "Of the picture, in seconds")->capture_default_str();
    c->add_option("--out,-o", a->out, "A folder, which is made where there is none")->required();
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
               "Write what the CPU path made of it into a folder: skinned vertices, ids, depth, colour",
               parity::write_result);
}

}  // namespace cli
