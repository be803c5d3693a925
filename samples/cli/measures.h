// Flow, density and speed of pedestrians, by the definitions of PedPy (Schrödter et al. 2024, pedpy.readthedocs.io).
#pragma once

#include <claque/trajectories.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "samples/charts/lines.h"

namespace cli
{

using Point2 = std::array<double, 2>;

struct MeasurementLine {
    Point2 from, to;
};

// Triangles of a plane, which do not overlap.
struct MeasurementArea {
    double area_m2 = 0;
    std::vector<std::array<Point2, 3>> triangles;
    bool holds(Point2 point) const;
};

struct Moment {
    double time_s = 0;
    uint32_t people = 0, inside = 0;  // in all, and in the area
    double speed_m_s = 0;             // mean of those inside; NaN: there are none
    double nearest_m = 0;             // between two people; NaN: there are fewer
    uint32_t crossed = 0;             // people who have crossed the line, each once
};

struct Measures {
    std::optional<MeasurementLine> line;
    std::optional<MeasurementArea> area;
    std::vector<Moment> moments;  // one for each step of the file
    // Of the crossings; NaN with fewer than two: people a second from the first to the last one.
    double first_s = 0, last_s = 0, flow_per_s = 0;
    double nearest_m = 0, nearest_s = 0;  // least of all; NaN
    double most_per_m2 = 0;               // density
};

// Throws scenes::Failure: of a file in which no person has two samples, or with more than 10^7 steps.
Measures measure(const clq_trajectories *trajectories, std::optional<MeasurementLine> line,
                 std::optional<MeasurementArea> area);

std::string csv_of(const Measures &measures);
charts::LineChart crossings_over_time(const Measures &measures, const std::string &file);
std::string told(const Measures &measures);  // lines for a terminal

}  // namespace cli
