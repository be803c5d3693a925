// Files of positions that other programs of pedestrian dynamics read.
#pragma once

#include "samples/scenes/walkers/record_positions.h"

namespace cli
{

// "" for a name that ends in .csv (columns id, frame, x, y), .txt (PedPy's and PeTrack's text) or .sqlite (JuPedSim,
// version 2), else a sentence. "-" is none: the ending says the format.
std::string check_position_file(const std::string &name);

// The bytes of such a file. Throws scenes::Failure, also for a database in a build without libsqlite3.
std::string position_file(const std::string &name, const scenes::walkers::RecordPositions &positions);
// As the text file.
std::string position_text(const scenes::walkers::RecordPositions &positions);

}  // namespace cli
