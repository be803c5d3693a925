// A Roman theatre as a scenario describes it: rows of seats on circles, gangways, stage, and the classes of the rows.
// The audience sits on the side of -z and looks towards the stage, which is on the side of +z; the origin is the
// centre of the orchestra's floor. Angles are about the vertical axis, 0 behind the centre of the audience (along -z),
// positive towards +x. Metres and degrees.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/scenes/social_classes.h"

namespace scenes
{

struct SeatRow {
    double radius_m = 0;                 // of the front edge of its seats
    double depth_m = 0;                  // from there to the riser of the next row, or to a walkway's inner edge
    double seat_y_m = 0;                 // height of its seats
    double step_y_m = 0;                 // height under the sitters' feet: seat_y_m less the rise
    double first_deg = 0, last_deg = 0;  // its sweep
    std::string social_class;            // its name; empty: the row stays empty
    std::string at;                      // in its file, for messages, as below
};

// Stairs that cut through rows [first_row, last_row].
struct Gangway {
    double at_deg = 0, width_m = 0;
    size_t first_row = 0, last_row = 0;
    std::string at;
};

// A horizontal walkway (praecinctio) between two blocks of rows.
struct Walkway {
    double inner_m = 0, outer_m = 0, y_m = 0;
    std::string at;
};

struct StageHouse {
    double front_z_m = 0;  // edge of the stage towards the orchestra
    double depth_m = 0, half_width_m = 0, floor_y_m = 0;
    double wall_height_m = 0;  // of the scaenae frons above the stage's floor
};

struct Theatre {
    double orchestra_radius_m = 0;
    double seat_width_m = 0;
    std::vector<SeatRow> rows;  // from the orchestra outwards
    std::vector<Gangway> gangways;
    std::vector<Walkway> walkways;
    StageHouse stage;
    std::vector<SocialClass> classes;
    double facing_noise_deg = 0;  // greatest turn away from the stage
};

// One seat: the centre of its front edge, at the height of the seat, and the direction of a sitter.
struct Seat {
    size_t row = 0;
    double angle_deg = 0;
    double x = 0, y = 0, z = 0;
    double facing_x = 0, facing_z = 0;
    double step_y = 0;
};

// The parts of a row between gangways, by ascending angle.
struct Wedge {
    double first_deg = 0, last_deg = 0;
};
std::vector<Wedge> wedges_of(const Theatre &theatre, size_t row);

// All seats, row by row, by ascending angle; none within a gangway.
std::vector<Seat> seats_of(const Theatre &theatre);

}  // namespace scenes
