// Times of an update's steps, where the host asked for them. The library never reads them.
#pragma once

#include "lib/frame/host_timer.h"

namespace claque::frame
{

enum class Step : uint8_t { cull, choose, behave, animate, cull_parts, skin, list };
constexpr size_t step_count = 7;

struct StepTimes {
    bool measured = false;
    double seconds[step_count] = {};
};

// Of one update, from its construction on.
class StepTimer
{
public:
    explicit StepTimer(const HostClock &clock)
        : timer_(clock, "the step clock", "the steps of the update have no times"), last_s_(timer_.now())
    {
        times_.measured = clock.now_s != nullptr;
    }

    void done(Step step)
    {
        const double now_s = timer_.now();
        times_.seconds[static_cast<size_t>(step)] = now_s - last_s_;
        last_s_ = now_s;
    }
    // All zero if the clock gave a time that is not finite.
    StepTimes times() const
    {
        for (const double one : times_.seconds)
            if (!std::isfinite(one)) return {};
        return times_;
    }

private:
    HostTimer timer_;
    double last_s_;
    StepTimes times_;
};

}  // namespace claque::frame
