// Flow, density and speed of pedestrians, by the definitions of PedPy (Schrödter et al. 2024, pedpy.readthedocs.io).
#pragma once

#include <claque/trajectories.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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
    double speed_m_s = 0;             // mean inside; NaN: nobody is there
    double nearest_m = 0;             // least distance of two people; NaN: there are fewer
    uint32_t crossed = 0;             // people beyond the line, each counted once
};

struct Measures {
    std::optional<MeasurementLine> line;
    std::optional<MeasurementArea> area;
    std::vector<Moment> moments;          // one for each step of the file
    double first_s = 0, last_s = 0;       // times of the first and the last crossing; NaN: none
    double flow_per_s = 0;                // crossings a second between them; NaN: fewer than two
    double nearest_m = 0, nearest_s = 0;  // least distance of all, and its time; NaN: none
    double most_per_m2 = 0;               // density
};

// Throws scenes::Failure where no person has two samples, and beyond 2 million steps.
Measures measure(const clq_trajectories *trajectories, std::optional<MeasurementLine> line,
                 std::optional<MeasurementArea> area);

std::string csv_of(const Measures &measures);
charts::LineChart crossings_over_time(const Measures &measures, const std::string &file);
nlohmann::ordered_json json_of(const Measures &measures);  // null: what was not asked for, and what nobody did
std::string told(const Measures &measures);                // lines for a terminal

}  // namespace cli
