// Ways that a test describes, and the built-in people that walk on them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lib/track/piece.h"

namespace claque::test
{

// A built-in person with its walk, jog and stand.
const track::Locomotion &locomotion_of(const std::string &figure);

// Points at a rate from a function of time; x and z in metres.
std::vector<track::Point> points_of(double rate_hz, double length_s, const std::function<glm::dvec2(double)> &way);

std::unique_ptr<track::Track> track_of(const std::vector<track::Point> &points, const std::string &figure = "citizen",
                                       const track::BuildSettings &settings = {});

struct Way {
    const char *name;
    std::vector<track::Point> points;
};
// Straight ahead at several speeds, a circle of 1 m radius, a corner, to and fro, with stands, with a swaying head.
std::vector<Way> ways();

}  // namespace claque::test
