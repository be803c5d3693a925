// What decisions tell the drawing flow: one call on the crowd, or on the host, at a time.
#pragma once

#include <claque/agents.h>

#include "lib/stage/machine/machine.h"

namespace claque::stage
{

enum class CommandKind : uint8_t { play, fade, gesture, end_gesture, walk_on, look, look_away, follow, leave, call };

struct HostAction {
    std::string name;
    clq_action_def def{};
};

struct Command {
    double at_s = 0;
    uint32_t order = 0;  // within its tick
    uint32_t agent = 0;
    CommandKind kind = CommandKind::play;
    bool adds = false;
    uint8_t curve = 0;
    clq_actor actor{};
    uint32_t clip = CLQ_NONE;  // the template's
    float speed = 1, phase_s = 0, weight = 1, loops = 0;
    float fade_s = 0, fade_out_s = 0;
    clq_mechanism gaze{};
    const Machine *machine = nullptr;  // gesture: of the mask
    uint32_t cast = 0, mask = none;
    const HostAction *action = nullptr;
    double value = 0, start_s = 0;
    double point[3] = {};
    clq_track *track = nullptr;  // follow: a hold of the command
};

uint64_t sum(uint64_t h, const Command &command);

}  // namespace claque::stage
