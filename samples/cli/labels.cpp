// claque labels: pictures with exact labels, for training and testing what looks at pictures.
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/label_folder.h"
#include "samples/cli/label_scene.h"
#include "samples/cli/progress.h"
#include "samples/cli/provenance.h"
#include "samples/cli/scene_about.h"
#include "samples/cli/sequence.h"
#include "samples/cli/stopwatch.h"
#include "samples/labels/collections.h"
#include "samples/labels/frame_files.h"

namespace cli
{
namespace
{

struct LabelArguments {
    SceneArguments setup;
    std::string frames = "0", out, write = "coco", keypoints = "coco", json, vary;
    labels::KeypointSet keypoint_set;
    std::optional<labels::Rules> rules;  // of the file `vary`
    std::vector<int> list;
    int chunk = 0, chunk_count = 1;
    double fps = 25;
    bool again = false, portable = false;
};

labels::Wanted wanted_by(const LabelArguments &a, const std::set<std::string> &formats)
{
    labels::Wanted wanted;
    const auto any = [&](std::initializer_list<const char *> names) {
        for (const char *name : names)
            if (formats.count(name) != 0) return true;
        return false;
    };
    wanted.zones = any({"npz", "sheet"});
    wanted.normals = any({"normals", "npz", "sheet"});
    wanted.positions = any({"npz"});
    wanted.flow = any({"flo", "kitti-flow", "npz", "sheet"});
    wanted.silhouettes = any({"mot", "sheet"});
    wanted.step_s = 1 / a.fps;
    wanted.keypoint_set = &a.keypoint_set;
    return wanted;
}

std::string gl_of(const scenes::SceneOptions &options)
{
    std::string why_not;
    const auto context = contexts::make_offscreen(options.context, 8, 8, options.format, why_not);
    if (!context) throw scenes::Failure("no OpenGL context: " + why_not);
    return context->name();
}

// What a picture's labels depend on.
labels::Json settings_of(const LabelArguments &a, const scenes::SceneOptions &options)
{
    labels::Json settings = {{"scene", scene_about(a.setup, options)},
                             {"fps", a.fps},
                             {"keypoints", file_about(a.keypoints)},
                             {"write", labels::read_formats(a.write)}};
    if (a.rules) {
        settings["vary"] = file_about(a.vary);
        for (const std::string &file : a.rules->files) settings["vary_files"].push_back(file_about(file));
    }
    settings.update(provenance(gl_of(options)));
    return settings;
}

void label(const LabelArguments &a)
{
    if (a.portable) use_portable_drivers();
    Progress progress("claque labels");
    const std::set<std::string> formats = labels::read_formats(a.write);
    scenes::Library library(thread_count(a.setup));
    const LoadedCharacter none;
    scenes::SceneOptions options = scene_options(a.setup, none);
    options.crowd_options.exact_poses = true;
    const LabelFolder folder(a.out, settings_of(a, options), a.again);
    std::vector<labels::Json> frames;
    std::unique_ptr<LabelScene> scene;
    labels::Json report = labels::Json::array();
    const std::vector<int> share = chunk_of(a.list, a.chunk, a.chunk_count);
    for (size_t i = 0; i < share.size(); ++i) {
        progress.step(i, share.size());
        labels::Json kept = folder.kept(share[i]);
        if (!kept.empty()) {
            frames.push_back(std::move(kept));
            continue;
        }
        const labels::Wanted wanted = wanted_by(a, formats);
        if (!scene) {
            scene = a.rules ? varied_scene(library, a.setup, options, wanted, a.fps, *a.rules)
                            : film_scene(library, options, wanted, a.fps);
            folder.begin();
        }
        const Stopwatch labelling;
        const LabelledPicture made = scene->label(share[i]);
        const double label_ms = labelling.ms();
        for (const labels::FrameFile &file : labels::frame_files(made.sample, formats)) folder.write(file);
        labels::Json about = labels::frame_json(made.sample);
        if (!made.choice.is_null()) about["choice"] = made.choice;
        frames.push_back(folder.conclude(std::move(about)));
        report.push_back({{"frame", made.sample.frame},
                          {"people", made.sample.people.size()},
                          {"silhouette_pictures", made.silhouette_pictures},
                          {"label_ms", label_ms},
                          {"files_ms", labelling.ms() - label_ms}});
    }
    // Files about all pictures need all of them.
    if (a.chunk_count == 1)
        for (const labels::FrameFile &file : labels::collections(frames, formats, a.keypoint_set)) folder.write(file);
    if (!a.json.empty()) write_whole(a.json, report.dump(2) + "\n");
    progress.conclude(std::to_string(frames.size()) + " labelled pictures in " + a.out);
}

}  // namespace

void add_labels(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<LabelArguments>();
    CLI::App *c = app.add_subcommand(
        "labels", "Pictures with exact labels: what every pixel is, where it moves, and where people's joints are");
    c->add_option("--scene", a->setup.scene, "A scene of built-in characters (default plaza)")->check(scene_names());
    add_scenario_option(*c, a->setup)->excludes(c->get_option("--scene"));
    c->add_option("--count", a->setup.count, "Individuals (default: the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    add_scene_options(*c, a->setup);
    c->add_option("--lod", a->setup.lod, "People with levels of detail (on) or without (off)")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->capture_default_str();
    c->add_option("--frames", a->frames, "First to last, single frames and strides, as in 0:99,120,200:240/4")
        ->type_name("LIST")
        ->capture_default_str();
    c->add_option("--vary", a->vary,
                  "Rules by which each picture is another sample: cameras, people, light, haze and sensors (TOML, "
                  "docs/labels.md). Frame k is sample k, a function of the rules, --seed and k")
        ->type_name("RULES");
    c->add_option("--fps", a->fps, "Frames a second: frame k shows k / fps seconds, and flow reaches one frame")
        ->capture_default_str();
    std::string names;
    for (const std::string &name : labels::format_names()) names += (names.empty() ? "" : ", ") + name;
    c->add_option("--write", a->write, "Formats, separated by commas: " + names)->capture_default_str();
    c->add_option("--keypoints", a->keypoints, "coco (17 joints), smpl (24), or a file of your own (TOML)")
        ->type_name("NAME|FILE")
        ->capture_default_str();
    c->add_option_function<std::string>(
         "--chunk",
         [a](const std::string &text) {
             const std::string wrong = read_share(text, a->chunk, a->chunk_count);
             if (!wrong.empty()) throw CLI::ValidationError("--chunk", wrong);
         },
         "Only share K of N of the pictures, from 0/N to N-1/N: one job of an array. A run without it makes the files "
         "about all pictures")
        ->type_name("K/N");
    c->add_flag("--again", a->again, "Label finished pictures again");
    c->add_flag("--portable", a->portable,
                "Restrict Mesa to what every x86-64 processor can do, so that all of them draw the same pixels");
    c->add_option("--out,-o", a->out, "Folder; pictures that it has already are kept")->required();
    c->add_option("--json", a->json, "Write times as JSON; - is standard output");
    c->callback([a, &chosen] {
        read_scenario(a->setup);
        check_scene_usage(a->setup);
        a->keypoint_set = labels::keypoint_set(a->keypoints);
        if (!a->vary.empty()) a->rules = labels::load_rules(a->vary);
        const bool is_ruled = a->rules && a->rules->camera;
        if (a->setup.camera.empty() && has_path(a->setup) && !is_ruled) a->setup.camera = "path";
        const std::string wrong = read_frames(a->frames, a->list);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        if (!(a->fps > 0 && a->fps <= 1e6)) throw CLI::ValidationError("--fps", "must be above 0");
        try {
            labels::read_formats(a->write);
        } catch (const scenes::Failure &failure) {
            throw CLI::ValidationError("--write", failure.what());
        }
        if (a->rules && labels::read_formats(a->write).count("mot") != 0)
            throw CLI::ValidationError("--write", "mot is about the frames of a film, and --vary makes samples");
        chosen = [a] { label(*a); };
    });
}

}  // namespace cli
