#include "samples/stage/takeover.h"

#include <chrono>
#include <utility>

namespace staged
{

using namespace scenes;

Takeover::Takeover(Library &library, const CrowdOptions &crowd_options, std::string path, const Scenario &scenario,
                   const StageOptions &options, Read read)
    : library_(library),
      crowd_options_(crowd_options),
      path_(std::move(path)),
      known_(scenario),
      options_(options),
      read_(std::move(read)),
      times_(times_of(scenario))
{
}

Takeover::Times Takeover::times_of(const Scenario &scenario) const
{
    std::vector<std::string> files = {path_, scenario.stage->timetable};
    if (scenario.stage->ground) files.push_back(scenario.stage->ground->area);
    for (const ScenarioAgents &agents : scenario.stage->agents) files.push_back(agents.machine);
    Times times;
    for (const std::string &file : files) {
        std::error_code absent;
        times.push_back(std::filesystem::last_write_time(file, absent));
    }
    return times;
}

void Takeover::look(double shown_s)
{
    if (making_.valid()) return;
    Times now = times_of(known_);
    if (now == times_) return;
    times_ = std::move(now);
    making_ = std::async(std::launch::async, [this, shown_s] {
        auto made = std::make_unique<Made>();
        made->scenario = read_();
        if (!made->scenario.stage) throw Failure(path_ + ": it has no [stage] any more");
        made->scene = make_staged(library_, crowd_options_, made->scenario, options_);
        made->scene->place(shown_s);
        made->scene->rest();
        return made;
    });
}

std::unique_ptr<Takeover::Made> Takeover::take()
{
    if (!making_.valid() || making_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
    try {
        std::unique_ptr<Made> made = making_.get();
        known_ = made->scenario;
        times_ = times_of(known_);
        return made;
    } catch (const Failure &failure) {
        refusal_ = failure.what();
        return nullptr;
    }
}

void Takeover::wait() const
{
    if (making_.valid()) making_.wait();
}

std::string Takeover::refusal() { return std::exchange(refusal_, {}); }

}  // namespace staged
