// Rows of positions as the readers find them, before they are put in order.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/asset/trajectories/ids.h"

namespace claque::asset
{

struct Row {
    double time = 0;  // seconds, or a frame number
    double x = 0, y = 0, z = 0;
    float heading_rad = 0;
    uint32_t person = 0;
    uint32_t flags = 0;
    uint32_t line = 0;  // of the file; also a row of a database or a count of entries
};

// How often something happened, and where first.
struct Tally {
    uint64_t count = 0;
    uint32_t line = 0;
    void add(uint32_t at)
    {
        if (count++ == 0) line = at;
    }
};

class Rows
{
public:
    explicit Rows(Budget &budget) : ids(budget), budget_(&budget) {}

    // Adds a row. One with numbers that are not finite or beyond any walk on Earth is counted and left out.
    void add(const Row &row);

    Ids ids;
    std::vector<Row> all;
    uint64_t read = 0;  // rows of the file: readers count them, as a row may give two samples, or none
    Tally impossible, missing;

private:
    Budget *budget_;
};

float heading_of_degrees(double degrees);  // counter-clockwise from +x; NaN stays NaN

}  // namespace claque::asset
