// The operations of S0 Table 1 as a run of the library counted them, in a file that benches write and `claque cost
// --measured` reads:
//
//   {
//     "note": "what ran: scene, number of actors, frames, machine",
//     "NO_01": 1180.5, "NO_02": 100, "NO_03": 80, "NO_04a": 800, "NO_04b": 231, "NO_05": 60,
//     "fTrack": 0.12, "fCoh": 0.97,
//     "traditional": { "NO_01": 4000, ... all six ... }
//   }
//
// NO_01: articulations of Skeleton nodes made into matrices; NO_02, NO_03: Reference Points and Skeleton Roots placed;
// NO_04a: Internal Bspheres recalculated; NO_04b: spheres of any kind tested against a frustum; NO_05: distances to an eye.
// Counts are means of a frame, from 0 up; shares are from 0 to 1 and mean what S0 6.2.2 says. "traditional" is what the
// same frames take in traditional mode; without it the scene of Table 2 is counted. Other members are passed over.
#pragma once

#include "samples/cost/fmult.h"

#include <optional>
#include <string>

namespace cost
{

struct Measured {
    std::string note;
    Counts actor = {};
    std::optional<Counts> traditional;
    Shares shares = {1, 1};
};

// `name` is what refusals call the text. Throws scenes::Failure.
Measured measured_of(const std::string &json, const std::string &name);
std::string json_of(const Measured &measured);

}  // namespace cost
