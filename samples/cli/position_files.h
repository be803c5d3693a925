// Files of positions that other programs of pedestrian dynamics read.
#pragma once

#include "samples/scenes/walkers/people.h"
#include "samples/scenes/walkers/record_positions.h"

namespace cli
{

// "" for a name that ends in .csv (columns id, frame, x, y), .txt (PedPy's and PeTrack's text) or .sqlite (JuPedSim,
// version 2), else a sentence. "-" is none: the ending says the format.
std::string check_position_file(const std::string &name);

// The bytes of such a file. Throws scenes::Failure, also for a database in a build without libsqlite3.
std::string position_file(const std::string &name, const scenes::walkers::RecordPositions &positions);

// As if the text file had been written and read; `name` is for messages. Throws Failure also where nobody is there.
scenes::walkers::OwnTrajectories trajectories_of(scenes::Library &library,
                                                 const scenes::walkers::RecordPositions &positions,
                                                 const std::string &name, double max_speed_m_s);

}  // namespace cli
