// Labels the pictures of a folder that it lacks, by one process or by several.
#include "samples/cli/files.h"
#include "samples/cli/label_crew.h"
#include "samples/cli/label_folder.h"
#include "samples/cli/progress.h"
#include "samples/cli/provenance.h"
#include "samples/cli/scene_about.h"
#include "samples/cli/sequence.h"
#include "samples/cli/work_share.h"
#include "samples/labels/collections.h"

namespace cli
{
namespace
{

class Labelling
{
public:
    Labelling(const LabelArguments &a, processes::Ranks *ranks) : a_(a)
    {
        if (ranks || process_count(a.processes) > 1) crew_.emplace(a, ranks);
        else maker_.emplace(a, threads_each(a.setup, a.processes, nullptr));
        report_["processes"] = process_count(a.processes);
        if (ranks) report_["ranks"] = ranks->count();
    }

    void run();

private:
    Json settings();
    void make(const std::vector<int> &missing);
    void keep(int number, LabelledFiles made);

    const LabelArguments &a_;
    Progress progress_{"claque labels"};
    std::optional<LabelCrew> crew_;  // one of these two
    std::optional<LabelMaker> maker_;
    std::optional<LabelFolder> folder_;
    std::map<int, Json> frames_;   // what each picture says
    std::map<int, Json> reports_;  // of pictures that were made
    size_t of_ = 0;
    Json report_;
};

// What a picture's labels depend on.
Json Labelling::settings()
{
    Json settings = {{"scene", scene_about(a_.setup, label_options(a_))},
                     {"fps", a_.fps},
                     {"keypoints", file_about(a_.keypoints)},
                     {"write", a_.formats}};
    if (!a_.tracks.file.empty()) settings["tracks"] = tracks_about(a_.tracks);
    if (a_.setup.make) settings["record"] = file_about(a_.tracks.file);
    if (a_.rules) {
        settings["vary"] = file_about(a_.vary);
        for (const std::string &file : a_.rules->files) settings["vary_files"].push_back(file_about(file));
    }
    settings.update(provenance(crew_ ? crew_->gl() : maker_->gl()));
    return settings;
}

void Labelling::keep(int number, LabelledFiles made)
{
    if (reports_.empty()) folder_->begin();
    frames_[number] = folder_->take(made.files, std::move(made.about));
    reports_[number] = std::move(made.report);
    progress_.step(frames_.size(), of_);
}

void Labelling::make(const std::vector<int> &missing)
{
    if (crew_)
        return crew_->make(missing, [&](size_t index, LabelledFiles made) { keep(missing[index], std::move(made)); });
    for (const int number : missing) keep(number, maker_->make(number));
}

void Labelling::run()
{
    folder_.emplace(a_.out, settings(), a_.again);
    const std::vector<int> share = chunk_of(a_.list, a_.chunk, a_.chunk_count);
    of_ = share.size();
    std::vector<int> missing;
    for (const int number : share) {
        Json kept = folder_->kept(number);
        if (kept.empty()) missing.push_back(number);
        else frames_[number] = std::move(kept);
    }
    if (!missing.empty()) make(missing);
    // Files about all pictures need all of them.
    if (a_.chunk_count == 1) {
        std::vector<Json> all;
        for (const int number : share) all.push_back(std::move(frames_[number]));
        for (const labels::FrameFile &file : labels::collections(all, a_.formats, a_.keypoint_set))
            folder_->write(file);
    }
    report_["frames"] = Json::array();
    for (const auto &[number, report] : reports_) report_["frames"].push_back(report);
    if (crew_) report_["replaced_processes"] = crew_->replaced();
    if (!a_.json.empty()) write_whole(a_.json, report_.dump(2) + "\n");
    progress_.conclude(std::to_string(share.size()) + " labelled pictures in " + a_.out);
}

}  // namespace

void label(const LabelArguments &a)
{
    if (a.portable) use_portable_drivers();
    share_work([&a](processes::Ranks *ranks) { Labelling(a, ranks).run(); },
               [&a](processes::Ranks &ranks) { LabelCrew::serve(a, ranks); });
}

}  // namespace cli
