#include "samples/cli/label_maker.h"

#include <algorithm>

#include "samples/labels/frame_files.h"
#include "samples/labels/frame_json.h"

namespace cli
{
namespace
{

labels::Wanted wanted_by(const LabelArguments &a)
{
    labels::Wanted wanted;
    const auto any = [&](std::initializer_list<const char *> names) {
        return std::any_of(names.begin(), names.end(), [&](const char *name) { return a.formats.count(name) != 0; });
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

}  // namespace

scenes::SceneOptions label_options(const LabelArguments &a)
{
    const LoadedCharacter none;
    scenes::SceneOptions options = scene_options(a.setup, none);
    options.crowd_options.exact_poses = true;
    return options;
}

LabelMaker::LabelMaker(const LabelArguments &a, int threads)
    : arguments_(a), library_(threads), options_(label_options(a))
{
}

std::string LabelMaker::gl() const
{
    std::string why_not;
    const auto context = contexts::make_offscreen(options_.context, 8, 8, options_.format, why_not);
    if (!context) throw scenes::Failure("no OpenGL context: " + why_not);
    return context->name();
}

LabelledFiles LabelMaker::make(int number)
{
    const LabelArguments &a = arguments_;
    if (!scene_) {
        labels::Wanted wanted = wanted_by(a);
        wanted.drawn = [this] { picture_ms_ = clock_.ms(), picture_cpu_ms_ = spent_.ms(); };
        scene_ = a.rules ? varied_scene(library_, a.setup, options_, wanted, a.fps, *a.rules)
                         : film_scene(library_, options_, wanted, a.fps);
    }
    clock_ = {}, spent_ = Stopwatch(Stopwatch::Clock::processor);
    const LabelledPicture made = scene_->label(number);
    const double label_ms = clock_.ms(), label_cpu_ms = spent_.ms();
    LabelledFiles out;
    out.files = labels::frame_files(made.sample, a.formats);
    out.about = labels::frame_json(made.sample);
    if (!made.choice.is_null()) out.about["choice"] = made.choice;
    out.report = {{"frame", made.sample.frame},
                  {"people", made.sample.people.size()},
                  {"silhouette_pictures", made.silhouette_pictures},
                  {"picture_ms", picture_ms_},
                  {"picture_cpu_ms", picture_cpu_ms_},
                  {"label_ms", label_ms},
                  {"label_cpu_ms", label_cpu_ms},
                  {"files_ms", clock_.ms() - label_ms}};
    return out;
}

}  // namespace cli
