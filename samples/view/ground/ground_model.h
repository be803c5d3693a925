// What people of the testing ground are told to do, and what it shows of them.
#pragma once

#include <claque/claque.h>

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/mind.h"
#include "samples/scenes/roles/role.h"

namespace view
{

// What a drag with the left button in the picture does.
enum class Tool { camera, gaze, path };

// Of the picked individual on its treadmill.
struct OnTreadmill {
    clq_track_state state = {};
    double drift_mean_mm = 0, drift_most_mm = 0;
    size_t steps = 0;
};

// What of a character the panels need to know.
struct Abilities {
    bool looks = false, blinks = false, speaks = false;
    std::vector<std::string> expressions, clips;
};

struct GroundSections {
    bool motion = false, face = false, flight = false, state = false, check = false;
};

struct Ground {
    std::map<uint32_t, scenes::roles::Role> roles;  // by index1; only of individuals that were given one
    GroundSections open;
    Tool tool = Tool::camera;
    std::optional<std::array<float, 2>> touch;  // with a tool, in this frame: a point of the picture, -1 to 1
    size_t layer = 0;                           // of the picked individual, chosen for the widgets
    float walking_m_s = 1.4f;
    std::string phrase = "salve", mechanism, hold_in = "hand_r";
    int object = 0;
    float height_m = 4;  // of the next corner of a path
    bool save_scenario = false, examine = false;
    bool level_row = false;
    std::string mechanisms;  // the folder of shared objects that may be loaded; empty: none

    // Of the picked individual, written by the workbench.
    Abilities can;
    std::optional<OnTreadmill> treadmill;
    std::string mechanism_name;
    std::optional<scenes::Mind> mind;
    struct Entered {
        double at_s;
        std::string state;
    };
    std::deque<Entered> entered;  // of the picked individual since it was picked
    uint32_t entered_of = 0;      // its index1
};

}  // namespace view
