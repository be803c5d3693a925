// claque play: pictures of the people in a file of trajectories, as they walked.
#include "samples/cli/command.h"
#include "samples/cli/progress.h"
#include "samples/cli/render_work.h"
#include "samples/cli/track_arguments.h"

namespace cli
{
namespace
{

// The whole file, if neither a time nor frames are given.
void take_all_frames(RenderArguments &a, const TrackArguments &tracks)
{
    scenes::Library library(1);
    clq_trajectories *made = nullptr;
    const clq_trajectories_def def = reading_of(tracks);
    scenes::check(clq_trajectories_load(library.context(), tracks.file.c_str(), &def, &made), tracks.file);
    clq_trajectories_info info = clq_trajectories_info_init();
    scenes::check(clq_trajectories_get_info(made, &info));
    clq_trajectories_destroy(made);
    a.range.first = 0;
    a.range.last = static_cast<int>((info.max_s - info.min_s) * a.fps);
    a.whole_path = false;
}

void take_camera(RenderArguments &a, const TrackArguments &tracks)
{
    if (tracks.camera.rfind("follow:", 0) == 0) a.setup.camera = "overview";
    else a.setup.camera = tracks.camera;
}

std::string check_camera(const std::string &text)
{
    for (const char *name : {"overview", "close", "path"})
        if (text == name) return {};
    if (text.rfind("follow:", 0) == 0 && text.size() > 7) return {};
    return "'" + text + "' is no camera: overview, close, path or follow:ID";
}

}  // namespace

void add_play(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<RenderArguments>();
    auto tracks = std::make_shared<TrackArguments>();
    CLI::App *c = app.add_subcommand("play", "Draw people walking along the trajectories of a file");
    c->add_option("FILE", tracks->file, "Trajectories: docs/trajectories.md lists the formats")->required();
    add_reading_options(*c, *tracks);
    add_walking_options(*c, *tracks);
    add_picture_options(*c, a);
    c->remove_option(c->get_option("--camera"));
    c->add_option("--camera", tracks->camera,
                  "View of the people: overview, close, follow:ID over a person's shoulder, or path (with --path)")
        ->check(CLI::Validator(check_camera, ""))
        ->type_name("VIEW");
    c->callback([a, tracks, c, &chosen] {
        take_camera(*a, *tracks);
        const bool whole = a->frames == "all" || (a->frames.empty() && c->count("--time") == 0);
        if (whole) a->frames = "0:1";  // the file says how many
        const scenes::walkers::Options options = walkers_of(*tracks);
        a->setup.make = [options](scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
            Progress progress("claque");
            scenes::walkers::Options with_progress = options;
            with_progress.progress = [&](size_t done, size_t of) { progress.step(done, of); };
            return scenes::walkers::make(library, crowd_options, with_progress);
        };
        check_picture_usage(*a);
        chosen = [a, tracks, whole] {
            if (whole) take_all_frames(*a, *tracks);
            render(*a);
        };
    });
}

}  // namespace cli
