// Where the people of a record are, many times a second.
#pragma once

#include <claque/scene.h>

#include <functional>
#include <string>
#include <vector>

#include "samples/scenes/walkers/record_file.h"

namespace scenes::walkers
{

// Plays a record without drawing it. Throws Failure.
class RecordPlaces
{
public:
    // The file has its templates already (RecordCast), and lives as long.
    RecordPlaces(Library &library, const RecordFile &file);

    // The actors present at a time, in the order of their numbers, and their places in the scene.
    void at(double time_s, const std::function<void(clq_actor, const double *position)> &take);

private:
    const RecordFile &file_;
    Own<clq_crowd> crowd_;
    clq_scene *scene_ = nullptr;  // the crowd's
    std::vector<clq_actor> actors_;
};

// x to the east and y to the north, metres of the recorded scene, to a tenth of a millimetre. Frame k is the time
// k / rate.
struct RecordPosition {
    uint32_t person;
    int frame;
    double x, y;
};

struct RecordPositions {
    double rate_hz = 25;
    // By frames, then by persons. A person has the number of its actor. A later actor with the same number is a person
    // of its own, with a number above all those.
    std::vector<RecordPosition> rows;
};

// Plays a record. `characters`: for templates that no built-in character has the name of. `progress` gets frames done
// and frames in all. Throws Failure, also beyond 2^26 rows and 10^7 frames.
RecordPositions positions_in(Library &library, const std::string &file, const std::vector<SocialClass> &characters,
                             double rate_hz, const std::function<void(size_t, size_t)> &progress);

}  // namespace scenes::walkers
