// The host's settings of updates; those of the caches are in animcache/settings.h.
#pragma once

#include "animcache/evaluate.h"
#include "animcache/settings.h"
#include "lib/base/services.h"

namespace claque::frame
{

// The order of work (S0 4). The picture is the same.
enum class Cull : uint8_t { actor = 0, traditional = 1 };

// Which tick may be shown. With the live clock no individual shows an earlier tick than before.
enum class Clock : uint8_t { reference = 0, live = 1 };

// A host's clock; only budgets in milliseconds need it.
struct HostClock {
    double (*now_s)(void *user) = nullptr;
    void *user = nullptr;
    base::Log log;  // is told if the clock throws
};

struct Settings {
    animcache::Settings caches;
    Cull cull = Cull::actor;
    animcache::RigidMode rigid_mode = animcache::RigidMode::vertices;
    Clock clock = Clock::reference;
    uint32_t update_budget = 0;  // the most poses renewed in an update; 0: all that are due. Needs caches.can_defer
    float update_budget_ms = 0;  // of posing and skinning; 0: no limit. Needs `now`
    HostClock now;
    float motion_tolerance_px = 1;  // by which the Reference Point may move between two poses; 0: no limit
    float lod_scale = 1;            // factor of every effective distance
    float lod_hysteresis = 0;       // [0, 1): with 0, levels are a function of time and distance
};

}  // namespace claque::frame
