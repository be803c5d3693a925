// claque render: its options, and those that it shares with other commands that draw.
#include <cmath>
#include <cstdio>
#include <set>
#include <unistd.h>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/provenance.h"
#include "samples/cli/render_work.h"
#include "samples/cli/work_share.h"
#include "samples/io/ending.h"
#include "samples/processes/ranks.h"

namespace cli
{

namespace
{

bool ends_like_another_format(const std::string &path)
{
    static const std::set<std::string> others = {".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp", ".ppm",
                                                 ".svg", ".mp4",  ".mkv", ".mov", ".avi", ".webm", ".pdf"};
    return others.count(io::ending_of(path)) != 0;
}

}  // namespace

void check_picture_usage(RenderArguments &a)
{
    if (!a.manifest.empty() && a.out == "-")
        throw CLI::ValidationError("--manifest", "needs frames in files, not raw pixels");
    if (a.portable) use_portable_drivers();
    if (a.divide == "frames" && a.frames.empty())
        throw CLI::ValidationError("--divide", "a single picture is divided into tiles");
    check_process_usage(a.processes);
    // Each process would choose the nearest people of its own tile.
    if (process_count(a.processes) > 1 && a.setup.close_mib > 0 &&
        (a.divide == "tiles" || (a.divide.empty() && a.frames.empty())))
        throw CLI::ValidationError("--close-textures", "is for whole pictures; --divide frames goes with it");
    if (process_count(a.processes) > 1 && a.reload)
        throw CLI::ValidationError("--reload", "needs one process: several would not see a change at the same time");
    if ((!a.clips.files.empty() || a.clips.vary > 0) && a.setup.file.empty())
        throw CLI::ValidationError("--clips", "and --vary need a FILE, the character that gets the clips");
    read_scenario(a.setup);
    check_scene_usage(a.setup);
    if (!a.frames.empty()) {
        if (a.setup.camera.empty() && has_path(a.setup)) a.setup.camera = "path";
        a.whole_path = a.frames == "all";
        if (a.whole_path && a.setup.camera != "path")
            throw CLI::ValidationError("--frames", "all needs a camera that follows a path");
        const std::string wrong = a.whole_path ? "" : read_frames(a.frames, a.list);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        if (a.out != "-" && !is_frame_pattern(a.out))
            throw CLI::ValidationError("--out",
                                       "a sequence needs one place for the frame number, as in frame-%05d.png");
    } else if (a.out != "-" && a.out.find('%') != std::string::npos)
        throw CLI::ValidationError("--out", "a place for the frame number needs --frames");
    if (ends_like_another_format(a.out))
        throw CLI::ValidationError("--out", "'" + a.out +
                                                "' would hold a PNG picture, so its name must end in .png; - sends "
                                                "raw frames to an encoder such as ffmpeg");
    if (!std::isfinite(a.time_s)) throw CLI::ValidationError("--time", "must be finite");
    if (!(a.fps > 0 && a.fps <= 1e6)) throw CLI::ValidationError("--fps", "must be above 0");
    if (a.out == "-" && a.json == "-")
        throw CLI::ValidationError("--json", "standard output is used by the pictures already");
    // mpirun gives its ranks terminals of its own, and passes on what they write as it is.
    if (a.out == "-" && isatty(STDOUT_FILENO) == 1 && processes::ranks_started() == 1)
        throw CLI::ValidationError("--out", "raw pixels cannot go to a terminal; send them to a file or an encoder");
}

void add_picture_options(CLI::App &c, const std::shared_ptr<RenderArguments> &a)
{
    add_scene_options(c, a->setup);
    add_reload_option(c, a->reload);
    c.add_option("--strategy", a->setup.strategy,
                 "Draw strategy: how individuals get their colours; all give the same picture")
        ->check(CLI::IsMember(strategy_names()))
        ->capture_default_str();
    c.add_option("--cache", a->setup.cache,
                 "What is cached between frames, which never changes the picture; keypose-*: all individuals show "
                 "key-poses (S3)")
        ->check(cache_choice)
        ->capture_default_str();
    c.add_option("--filter", a->setup.filter,
                 "How textures are sampled; linear filters clean triangles where that mixes no zones, levels shows "
                 "smoothed images where several texels fall on a pixel")
        ->check(CLI::IsMember({"nearest", "linear", "levels"}))
        ->capture_default_str();
    c.add_option("--close-textures", a->setup.close_mib,
                 "Filtered textures of their own for people near the eye, within this memory in MiB (0: none)")
        ->check(CLI::Range(0, 1 << 16))
        ->capture_default_str();
    c.add_option("--close-distance", a->setup.close_distance_m,
                 "With --close-textures: people nearer than this many metres have one (0: as measured)")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    c.add_option("--lod", a->setup.lod,
                 "People with levels of detail (on), without (off, for comparison), or with the first level only "
                 "(finest), where the scene has them. FILE has levels unless this is off")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->each([a](const std::string &lod) { a->setup.file_without_levels = lod == "off"; })
        ->capture_default_str();
    c.add_option(
         "--cull", a->setup.cull,
         "Cull between the steps of behaviour (actor), or compute everything for all and cull last (traditional; S0 4)")
        ->check(CLI::IsMember({"actor", "traditional"}))
        ->capture_default_str();
    c.add_option("--cull-scale", a->setup.cull_scale,
                 "Cull by a frustum of this fraction of the picture's and show its edge (S0 Fig. 10)")
        ->check(CLI::Range(0.01, 1.0));
    c.add_option("--show", a->setup.show,
                 "Overlay spheres: the actors' bounding spheres (S0 Fig. 2); or levels: a colour for each level of "
                 "detail (S0 Fig. 9)")
        ->check(CLI::IsMember({"nothing", "spheres", "levels"}));
    c.add_option("--shadows", a->setup.shadows,
                 "Shadows of people on the ground: as painted, or claque's ellipses (blob) or meshes; -stencil: with "
                 "a stencil bit")
        ->check(CLI::IsMember(shadow_names()));
    CLI::Option *time = c.add_option("--time", a->time_s, "Time of the picture in seconds")->capture_default_str();
    c.add_option("--frames", a->frames,
                 "A sequence: first to last, single frames and strides, as in 0:99,120,200:240/4; or all of a camera "
                 "path. Frame k shows k / fps seconds")
        ->type_name("LIST|all")
        ->excludes(time);
    c.add_option_function<std::string>(
         "--chunk",
         [a](const std::string &text) {
             const std::string wrong = read_share(text, a->chunk, a->chunk_count);
             if (!wrong.empty()) throw CLI::ValidationError("--chunk", wrong);
         },
         "Only share K of N of the frames, from 0/N to N-1/N: one job of an array")
        ->type_name("K/N");
    c.add_option("--manifest", a->manifest,
                 "Keep a list of this job's frames with their SHA-256 and what their pixels depend on, for claque "
                 "frames check; frames that it has are not drawn again")
        ->type_name("FILE.json");
    c.add_flag("--portable", a->portable,
               "Restrict Mesa to what all x86-64 processors do alike, so that jobs on different ones draw the same "
               "pixels");
    c.add_option("--stride", a->range.stride, "Draw only every N-th frame")->check(CLI::Range(1, 1000000));
    c.add_option("--fps", a->fps, "Frames a second of a sequence")->capture_default_str();
    c.add_option("--samples", a->samples,
                 "Anti-aliasing: the mean of this many pictures of the same poses, each moved by a fraction of a pixel")
        ->check(CLI::Range(1, 1024));
    c.add_flag("--again", a->again, "Draw finished frames again");
    c.add_option("--processes", a->processes,
                 "Draw by this many processes (docs/films.md); pixels do not depend on it (default: 1; in a job of a "
                 "scheduler the cores that it got)")
        ->check(CLI::Range(1, 256));
    c.add_option("--divide", a->divide,
                 "With --processes: each draws whole frames, or a tile of every frame (default: frames of a sequence, "
                 "tiles of a single picture)")
        ->check(CLI::IsMember({"frames", "tiles"}));
    c.add_option("--out,-o", a->out,
                 "PNG file; with --frames a pattern like f-%05d.png; - streams raw RGB, rows from the top")
        ->required();
    c.add_option("--json", a->json, "Write counts, rates and times as JSON; - is standard output");
}

void add_render(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<RenderArguments>();
    CLI::App *c = app.add_subcommand("render", "Draw a scene, one picture or a sequence");
    std::string abouts;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        abouts += std::string(abouts.empty() ? "" : "; ") + entry.name + ": " + entry.about;
    CLI::Option *file = c->add_option("FILE", a->setup.file,
                                      "Stand this character on a ground: glTF, GLB, prepared .clq, or the name of a "
                                      "built-in character (citizen, patrician ...)");
    c->add_option("--scene", a->setup.scene, "A scene of built-in characters (default plaza). " + abouts)
        ->check(scene_names())
        ->excludes(file);
    add_scenario_option(*c, a->setup)->excludes(file)->excludes(c->get_option("--scene"));
    c->add_option("--count", a->setup.count, "Individuals (default 12 of a FILE, else the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    add_file_options(*c, a->setup.of_file);
    add_picture_options(*c, a);
    for (const char *of_sequences : {"--stride", "--fps", "--again", "--chunk", "--manifest"})
        c->get_option(of_sequences)->needs("--frames");
    add_clip_options(*c, a->clips);
    c->add_option("--clip", a->clip,
                  "Everyone plays this clip of FILE from its beginning, in step (name or number; default: all in turn)")
        ->type_name("NAME")
        ->needs(file);
    c->callback([a, &chosen] {
        check_picture_usage(*a);
        chosen = [a] { render(*a); };
    });
}

}  // namespace cli
