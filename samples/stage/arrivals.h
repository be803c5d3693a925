// When people come, and where: a function of the scenario and the seed, and of which places are free.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "samples/scenes/scenario/scenario.h"

namespace staged
{

struct Arrival {
    uint32_t person = 0;
    double due_s = 0;
};

struct Spot {
    std::array<double, 3> position;
    double heading_rad;
};

// Decisions begin so long before time 0: people who are there from the beginning stand when they are first seen.
constexpr double begin_s = -1;

// Of a point, within the outline or on it.
bool is_within(const scenes::Outline &outline, double x, double z);

// All people of a scenario in the order in which they are due.
std::vector<Arrival> arrivals_of(const scenes::Staging &stage, uint64_t seed);

// Finds a place on the ground near a point, and moves the point there. False: there is none.
using OnGround = std::function<bool(std::array<double, 3> &point)>;
// Whether no person is within a distance of a point.
using IsFree = std::function<bool(const std::array<double, 3> &point, double apart_m)>;

// One place of many for a person of these agents; `attempt` chooses which. False: it is not free, or no ground.
bool find_spot(const scenes::Staging &stage, const scenes::ScenarioAgents &agents, uint64_t seed, uint32_t attempt,
               const OnGround &on_ground, const IsFree &is_free, Spot &out);

}  // namespace staged
