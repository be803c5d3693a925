// The host's clock during one update.
#pragma once

#include <cmath>
#include <cstdio>

#include "lib/base/host_call.h"
#include "lib/frame/settings.h"

namespace claque::frame
{

// Without a clock all times are 0. A clock that throws is not read again, and its times are not numbers.
class HostTimer
{
public:
    // `name` of the clock and `loss`, what is lost if it throws: for the log.
    HostTimer(const HostClock &clock, const char *name, const char *loss) : clock_(clock), name_(name), loss_(loss) {}

    double now()
    {
        if (!clock_.now_s) return 0;
        double time_s = std::nan("");
        if (!running_) return time_s;
        const base::Status status = base::call_host(name_, [&] { time_s = clock_.now_s(clock_.user); });
        running_ = status.ok();
        if (running_) return time_s;
        char text[360];
        std::snprintf(text, sizeof text, "%s; %s", status.text, loss_);
        clock_.log.warn(text);
        return std::nan("");
    }

private:
    HostClock clock_;
    const char *name_, *loss_;
    bool running_ = true;
};

}  // namespace claque::frame
