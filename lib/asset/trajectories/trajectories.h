// Reads the trajectories of people from bytes that may be anything.
#pragma once

#include <claque/trajectories.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/asset/trajectories/rows.h"

namespace claque::asset
{

struct TrajectoryOptions {
    clq_trajectory_format format = CLQ_TRAJECTORY_AUTO;
    std::string columns;
    double rate_hz = 0, metres_per_unit = 0;
    clq_up_axis up = CLQ_UP_OF_FILE;
    bool vehicles = false;
    std::optional<std::array<double, 9>> picture_to_metres;
    double max_speed_m_s = 12, max_gap_s = 0;
    double start_s = -HUGE_VAL, end_s = HUGE_VAL;
    uint64_t memory_limit_bytes = uint64_t(4) << 30;
};

struct Person {
    const char *id = "";
    uint64_t first = 0, count = 0;
    float height_m = 0;
};

// The ids of people point into `ids`.
struct Trajectories {
    explicit Trajectories(Ids &&kept) : ids(std::move(kept)) {}

    Ids ids;
    std::vector<Person> people;
    std::vector<clq_trajectory_sample> samples;
    std::vector<std::string> warnings;
    clq_trajectories_info facts = clq_trajectories_info_init();
};

// What a reader gets: the file, unpacked where it was packed, except XML.
struct TrajectoryInput {
    const uint8_t *bytes = nullptr;
    size_t size = 0;
    std::string name;  // of the file, for messages and to choose a format
    // Gives the text of H.txt in the file's folder, if there is one; only CLQ_TRAJECTORY_VSP asks. May be empty.
    std::function<std::optional<std::string>()> beside;
    std::string_view text() const { return {reinterpret_cast<const char *>(bytes), size}; }
};

// What a reader found.
struct Reading {
    explicit Reading(Budget &for_all) : budget(for_all), rows(for_all) {}

    Budget &budget;
    Rows rows;
    const char *place = "line";  // what Row::line counts
    bool frames = false;         // Row::time is a frame number
    double rate_hz = 0;          // frame numbers in a second; 0: not in the file
    double smallest_step_s = 0;  // with rate_hz 0: the time that the smallest step of frame numbers takes
    double unit_m = 1;           // metres in a unit; 0: not in the file
    bool asks_up = false;        // three coordinates, and the file does not say which is up
    bool joined = false;         // rows of a person follow each other without gaps, ends are repeated
    bool heights = false;        // z is the height of a head, not of the ground
    std::vector<std::string> warnings;
};

// Throws base::Error and std::bad_alloc.
Trajectories read_trajectories(const TrajectoryInput &input, const TrajectoryOptions &options);

// Puts rows in order, converts them and finds the people. `format` is that of the reader.
Trajectories assemble(Reading &reading, const TrajectoryOptions &options, clq_trajectory_format format);

}  // namespace claque::asset
