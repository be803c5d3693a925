// Draws one picture of a scene, or a sequence, by one process or by several.
#include <optional>
#include <utility>

#include "samples/cli/files.h"
#include "samples/cli/film_about.h"
#include "samples/cli/filtering.h"
#include "samples/cli/frame_crew.h"
#include "samples/cli/manifest.h"
#include "samples/cli/measured_rates.h"
#include "samples/cli/progress.h"
#include "samples/cli/render_work.h"
#include "samples/cli/work_share.h"

namespace cli
{
namespace
{

std::string camera_of(const RenderArguments &a, const scenes::SceneOptions &options)
{
    if (options.shot == scenes::Shot::path) return "path";
    if (options.shot == scenes::Shot::close) return "close";
    if (!followed_by(a.setup.camera).empty() || !options.viewpoint.empty()) return a.setup.camera;
    const bool follows = a.setup.described && a.setup.camera.empty() && !a.setup.described->follow.empty();
    return follows ? "follow:" + a.setup.described->follow : "overview";
}

Json about(const RenderArguments &a, const scenes::SceneOptions &options, const processes::Ranks *ranks)
{
    Json report;
    report["claque"] = version();
    report["scene"] = options.scene;
    if (!a.setup.file.empty()) report["file"] = a.setup.file;
    report["seed"] = options.crowd_options.seed;
    report["size_px"] = {options.width, options.height};
    report["camera"] = camera_of(a, options);
    if (!a.setup.path.empty()) report["path"] = a.setup.path;
    if (!a.setup.scenario.empty()) report["scenario"] = a.setup.scenario;
    const clq_colours colours = a.setup.of_file.placement.colours;
    if (colours != CLQ_COLOURS_NEAR) report["colours"] = scenes::name_of(colours);
    else if (!a.setup.colours.empty()) report["colours"] = a.setup.colours;
    report["strategy"] = a.setup.strategy;
    report["cache"] = a.setup.cache;
    report["threads"] = threads_each(a.setup, a.processes, ranks);
    if (process_count(a.processes) > 1) report["processes"] = process_count(a.processes);
    return report;
}

// One run of the command: what draws its frames, and what is kept of each.
class Rendering
{
public:
    Rendering(const RenderArguments &a, processes::Ranks *ranks) : a_(a)
    {
        if (ranks || process_count(a.processes) > 1) crew_.emplace(a, ranks);
        else drawer_.emplace(a, threads_each(a.setup, a.processes, nullptr));
        LoadedCharacter none;
        options_ = scene_options(a.setup, none);
        report_ = about(a, options_, ranks);
        if (ranks) report_["ranks"] = ranks->count();
    }

    void run();

private:
    const Subject &subject()
    {
        if (!subject_) {
            progress_.phase("preparing");
            subject_ = crew_ ? crew_->subject() : drawer_->subject();
            report_["count"] = subject_->count, report_["context"] = subject_->context;
        }
        return *subject_;
    }
    void choose_frames();
    void draw_alone();
    void keep(size_t index, Json report, const unsigned char *bytes, size_t size);
    void write_report();

    const RenderArguments &a_;
    Progress progress_{"claque"};
    std::optional<FrameCrew> crew_;  // one of these two
    std::optional<FrameDrawer> drawer_;
    scenes::SceneOptions options_;
    std::optional<Subject> subject_;
    std::optional<Manifest> manifest_;
    std::vector<Frame> frames_;
    std::vector<Json> drawn_;  // by frame
    size_t done_ = 0;
    Json report_;
};

// Leaves out what is there already.
void Rendering::choose_frames()
{
    frames_ = planned_frames(a_, options_);
    if (!a_.manifest.empty()) {
        std::vector<int> numbers;
        for (const Frame &frame : frames_) numbers.push_back(frame.number);
        manifest_.emplace(a_.manifest, film_about(a_, options_, subject().context), numbers, a_.out);
    }
    report_["skipped"] = Json::array();
    for (const Frame &frame : std::exchange(frames_, {})) {
        const bool is_done = manifest_ ? !a_.again && manifest_->has(frame.number, frame.path) : is_finished(a_, frame);
        if (is_done) report_["skipped"].push_back(frame.number);
        else frames_.push_back(frame);
    }
    drawn_.resize(frames_.size());
}

void Rendering::keep(size_t index, Json report, const unsigned char *bytes, size_t size)
{
    write_whole(frames_[index].path, bytes, size);
    if (manifest_) manifest_->add(frames_[index].number, frames_[index].path);
    drawn_[index] = std::move(report);
    progress_.step(++done_, frames_.size());
}

void Rendering::draw_alone()
{
    for (size_t i = 0; i < frames_.size(); ++i) {
        Json report = frame_report(frames_[i]);
        const std::vector<uint8_t> &rgb = drawer_->draw(frames_[i], report);
        drawer_->add_hashes(rgb, report);
        const std::vector<unsigned char> bytes = frame_bytes(a_, frames_[i], rgb.data(), options_, subject());
        keep(i, std::move(report), bytes.data(), bytes.size());
    }
}

void Rendering::write_report()
{
    report_["frames"] = drawn_;
    if (crew_) {
        report_["replaced_processes"] = crew_->replaced();
        report_["warnings"] = crew_->warnings();
    } else {
        progress_.phase("measuring rates");
        const bool has_scene = drawer_->has_scene();
        if (has_scene && options_.linear_clean) report_["filtering"] = filtering(drawer_->scene_renderer());
        if (has_scene && !frames_.empty())
            report_["measured"] = measured_rates(drawer_->scene_renderer(), frames_.back().time_s);
        report_["warnings"] = drawer_->warnings();
    }
    write_whole(a_.json, report_.dump(2) + "\n");
}

void Rendering::run()
{
    choose_frames();
    if (!frames_.empty()) {
        subject();
        if (crew_)
            crew_->draw(frames_, [this](size_t index, Json report, const unsigned char *bytes, size_t size) {
                keep(index, std::move(report), bytes, size);
            });
        else draw_alone();
    }
    a_.drawn();
    if (!a_.json.empty()) write_report();
    std::string by;
    if (subject_) by = ", " + std::to_string(subject_->count) + " individuals, " + subject_->context;
    progress_.conclude(a_.out + ": " + std::to_string(frames_.size()) + " drawn" + by);
}

}  // namespace

void render(const RenderArguments &given)
{
    RenderArguments a = given;
    expect_writable(frame_path(a.out, 0));
    if (!a.json.empty()) expect_writable(a.json);
    if (!a.manifest.empty()) expect_writable(a.manifest);
    const LoadedCharacter none;
    if (!a.frames.empty() && a.out != "-") a.scene = film_scene(a, scene_options(a.setup, none));
    share_work([&a](processes::Ranks *ranks) { Rendering(a, ranks).run(); },
               [&a](processes::Ranks &ranks) { FrameCrew::serve(a, ranks); });
}

}  // namespace cli
