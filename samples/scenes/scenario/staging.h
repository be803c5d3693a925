// What a scenario says of agents that decide (docs/scenarios.md): what they are, where they come from, what they walk
// on, and how long they are watched. Positions are those of the scene: x to the east, y up, z to the south, metres.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenes
{

struct Place {
    std::string name;
    std::array<double, 3> position;
};

// Corners x and z of a convex polygon, in order.
using Outline = std::vector<double>;

struct ScenarioDoor {
    std::string name;
    Outline outline;
    double low_m = -1, high_m = 3;
    bool open = true;
    struct Change {
        double at_s;
        bool open;
    };
    std::vector<Change> changes;  // by time
    std::string at;               // in the scenario, for messages
};

struct ScenarioGround {
    std::string area;  // a file of the walkable area; empty: the rectangle, or what the setting has
    Outline rectangle;
    double radius_m = 0.2, height_m = 1.9, max_slope_deg = 40, max_step_m = 0.25, cell_m = 0;
    std::optional<double> time_gap_s, climbing, descending;
    double body_radius_m = 0.3;  // of the widest body, as others keep away from it
    uint64_t max_cells = 40000000;
    double walls_m = 0.3;  // height of the walls round the area, as they are drawn
    std::string at, area_at;
};

// People of one class that run one machine.
struct ScenarioAgents {
    std::string name;     // by which machines know the class: for events and searches
    size_t member = 0;    // of the scenario's characters
    std::string machine;  // a file
    uint32_t count = 1;
    std::vector<size_t> from;  // places where they appear; empty: within the outline
    Outline outline;
    double within_m = 0.5;              // of the place
    double apart_m = 0.6;               // from each other, where they appear
    double from_s = 0;                  // when the first appears
    double per_minute = 0;              // so many follow; 0: all at once
    std::optional<double> heading_deg;  // none: any
    std::vector<size_t> exits;          // places where they leave
    std::vector<double> exit_widths_m;  // of each; empty: the nearest exit is taken
    std::string at, machine_at;
};

// One that flies round a closed curve over the others, which hear of it.
struct ScenarioFlyer {
    std::string name, character, clip = "fly";
    std::vector<double> path;  // x, y, z of its corners
    double speed_m_s = 6, scale = 1;
    std::string sends;  // an event to those near it; empty: none
    double radius_m = 8, every_s = 0.5;
    std::string at;
};

// The town of the scene `vehicle`: people walk on its square and in the streets round it.
struct ScenarioTown {
    uint64_t seed = 1;
    bool market_day = false;
    double streets_m = 30;  // how far from the square
};

struct Staging {
    double seconds = 60;
    double tick_s = 0.05, lead_s = 1;
    uint32_t budget = 0;   // cost of the tasks of a tick, without live time; 0: no limit
    double budget_us = 0;  // the same in live time, microseconds
    std::string timetable, timetable_at;
    std::vector<Place> places;
    std::optional<ScenarioGround> ground;  // none: no agent walks
    std::vector<ScenarioDoor> doors;
    std::vector<ScenarioAgents> agents;
    std::vector<ScenarioFlyer> flyers;
    std::string at;
};

}  // namespace scenes
