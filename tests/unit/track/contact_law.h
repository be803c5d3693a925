// The law of feet at every moment, and the ways on which people are watched.
#pragma once

#include <functional>
#include <string>

#include "tests/unit/track/contacts.h"

namespace claque::test
{

// Where a person is at a time, x and z in metres.
using WayFunction = std::function<glm::dvec2(double)>;

WayFunction ahead(double speed);
// To a corner in four seconds, and on.
WayFunction corner(double speed, double degrees);
WayFunction circle(double speed, double radius);
// Walks for so long and stands for so long.
WayFunction stop_and_go(double speed, double walks_s, double stands_s);
// People that wait go a little to here and there.
WayFunction shuffle(double step_m, double every_s);

// Prints a row of the table of docs/measurements.md, and expects a foot on the ground neither to slip nor to turn, a
// foot that goes to another place to rise, and none to go through the floor.
void expect_law(const std::string &name, const Contacts &contacts);

// The law for characters of files, whose soles bend with shin and toes, or who run before their feet are down: no
// vertex that is down gets far, no foot turns or sinks, and a foot that goes to another place rises.
void expect_law_of_others(const std::string &name, const Contacts &contacts);

// As printf, of two numbers at most.
std::string numbered(const char *form, double a, double b = 0);

}  // namespace claque::test
