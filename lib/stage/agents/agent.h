// One agent: what it is, and what it remembers.
#pragma once

#include <claque/agents.h>

#include <array>

#include "lib/stage/machine/machine.h"

namespace claque::stage
{

// A state that the agent is in.
struct Level {
    uint32_t state = none;
    uint32_t serial = 0;     // of this entry; tasks of the state hold as long as it
    uint32_t armed_for = 0;  // the clip for whose ends and markers its transitions wait
    double entered_s = 0;
};

struct Agent {
    // What it is.
    clq_actor actor{};
    uint32_t machine = 0, cast = 0, agent_class = 0;
    uint64_t seed = 0;
    clq_mechanism gaze{};
    float scale = 1;
    double heading_rad = 0;
    bool is_walker = false;
    // What it remembers.
    bool is_removed = false, in_view = true, walking = false, has_origin = false;
    uint32_t depth = 0;
    std::array<Level, max_depth> path{};
    uint32_t next_serial = 1, draws = 0, request = 0, sender = none;
    uint32_t play_serial = 0, clip = none;  // the machine's clip
    double play_start_s = 0, play_phase_s = 0, play_speed = 1;
    double now_s = 0;  // of its last task
    double value = 0, origin[3] = {}, position[3] = {};
    uint64_t transitions = 0;
    std::vector<double> variables;
    std::vector<uint32_t> last;  // by state: the child that was left last

    const Level *innermost() const { return depth ? &path[depth - 1] : nullptr; }
};

}  // namespace claque::stage
