// A scenario file that changes while it runs: it is read again, made beside the run that is shown, brought to the time
// that is shown, and takes its place; or it is refused, and the old run goes on.
#pragma once

#include <filesystem>
#include <future>

#include "samples/stage/staged_scene.h"

namespace staged
{

class Takeover
{
public:
    using Read = std::function<scenes::Scenario()>;
    // Watches the scenario's file, its machines and its timetable. `read`: reads the file again.
    Takeover(scenes::Library &library, const scenes::CrowdOptions &crowd_options, std::string path,
             const scenes::Scenario &scenario, const StageOptions &options, Read read);

    // Looks at the files. If one has changed, a new run is made in a thread of its own.
    void look(double shown_s);
    // The new run and its scenario, once it has come so far; null: there is none.
    struct Made {
        std::unique_ptr<StagedScene> scene;
        scenes::Scenario scenario;
    };
    std::unique_ptr<Made> take();
    // Waits for the thread, for tests and for the end.
    void wait() const;
    // What was wrong with the last file that was refused; "" after the next call.
    std::string refusal();

private:
    using Times = std::vector<std::filesystem::file_time_type>;
    Times times_of(const scenes::Scenario &scenario) const;

    scenes::Library &library_;
    scenes::CrowdOptions crowd_options_;
    std::string path_, refusal_;
    scenes::Scenario known_;
    StageOptions options_;
    Read read_;
    Times times_;
    std::future<std::unique_ptr<Made>> making_;
};

}  // namespace staged
