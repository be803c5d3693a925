// Small files of each format: two people, two seconds. The first walks 1 m/s along x from (0, 1), the second -0.5 m/s
// along y from (2, 3), both with 5 frames a second and 11 frames from frame 10.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lib/asset/trajectories/trajectories.h"

namespace claque::testing
{

using Bytes = std::vector<uint8_t>;

struct Written {
    const char *name;  // of a file
    clq_trajectory_format format;
    Bytes bytes;
    asset::TrajectoryOptions options;  // what the file does not say
    double first_s;                    // time of the first sample
    double step_s;
    bool headings;
    size_t samples;  // of each person
};

// Text formats, and with their libraries the others.
std::vector<Written> written_files();

Bytes packed(const Bytes &bytes);                               // gzip
Bytes database_of(const std::vector<std::string> &statements);  // SQLite
std::vector<std::string> jupedsim_statements(int version);

}  // namespace claque::testing
