// Where the people of a record are, many times a second.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "samples/scenes/walkers/cast.h"

namespace scenes::walkers
{

// x to the east and y to the north, metres of the recorded scene, to a tenth of a millimetre. Frame k is the time
// k / rate.
struct RecordPosition {
    uint32_t person;
    int frame;
    double x, y;
};

struct RecordPositions {
    double rate_hz = 25;
    // By frames, then by persons. A person has the number of its actor; of several who have had one number after
    // another, the later ones have numbers of their own above all those.
    std::vector<RecordPosition> rows;
};

// Plays a record. `characters`: for templates that no built-in character has the name of. `progress` gets frames done
// and frames in all. Throws Failure, also beyond 2^26 rows.
RecordPositions positions_in(Library &library, const std::string &file, const std::vector<SocialClass> &characters,
                             double rate_hz, const std::function<void(size_t, size_t)> &progress);

}  // namespace scenes::walkers
