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
// NO_01: articulation matrices of Skeleton nodes; NO_02, NO_03: transforms of Reference Points and Skeleton Roots;
// NO_04a: Internal Bspheres recalculated; NO_04b: spheres of any kind tested against a frustum; NO_05: distances to an
// eye. Counts are means of a frame, at least 0. Shares are from 0 to 1, as defined in S0 6.2.2. "traditional" has the
// counts of the same frames in traditional mode; without it the scene of Table 2 is counted. Other members are ignored.
#pragma once

#include <optional>
#include <string>

#include "samples/cost/fmult.h"

namespace cost
{

struct Measured {
    std::string note;
    Counts actor = {};
    std::optional<Counts> traditional;
    Shares shares = {1, 1};
};

// `name` names the text in error messages. Throws scenes::Failure.
Measured measured_of(const std::string &json, const std::string &name);
std::string json_of(const Measured &measured);

}  // namespace cost
