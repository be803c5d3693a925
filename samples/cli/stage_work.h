// claque stage: what its options say.
#pragma once

#include <optional>

#include "samples/cli/measure_arguments.h"
#include "samples/cli/render_work.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/sequence.h"
#include "samples/cli/stage_commands.h"
#include "samples/stage/staged_scene.h"

namespace cli
{

struct StageArguments {
    SceneArguments setup;
    MeasureArguments measures;  // of the record
    std::string record, frames, out, json, save, restore, commands;
    FrameRange range;
    double seconds = 0, fps = 25;  // 0: as the scenario says
    double at_s = -1;              // at which `save` is written; below 0: at the end
    bool apart = false, in_turn = false, live = false, draw = false;
    double stall_ms = 0;
};

void run_stage(const StageArguments &arguments);

// A run and, if there are pictures, what draws it.
struct OpenRun {
    OpenRun(scenes::Library &library, const StageArguments &arguments);
    // The same with a scene that is made already.
    OpenRun(scenes::Library &library, const StageArguments &arguments, std::unique_ptr<staged::StagedScene> made);

    // Shows a time, in a picture if there are pictures.
    void show(double time_s);

    std::unique_ptr<scenes::Scene> own;
    std::optional<scenes::SceneRenderer> renderer;
    staged::StagedScene *scene = nullptr;

private:
    void open(scenes::Library &library, const StageArguments &arguments, std::unique_ptr<staged::StagedScene> made);
};

staged::StageOptions stage_options(const StageArguments &arguments);

// The state of a run in a file. Restoring throws Failure with the file's name.
void save_to(const std::string &file, staged::StagedScene &scene);
void restore_from(const std::string &file, staged::StagedScene &scene);

// Shows the run at the pace of the machine's clock, and takes over its file when that changes. The report has the
// times.
Json show_live(scenes::Library &library, const StageArguments &arguments, std::unique_ptr<OpenRun> &run,
               bool is_watched, StageCommands *commands);

}  // namespace cli
