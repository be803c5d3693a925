// The vehicles of a file of trajectories as boxes, and the seats of the people who ride in them.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/walkers/people.h"

namespace scenes::walkers
{

// Files say where the middle of a vehicle's front is, and no size. Sizes are those that SUMO takes for passenger cars
// and, where more than four people ride at once, for buses; a bus is as long as its rows of seats.
class Vehicles
{
public:
    // `trajectories` and `people` must live as long as this.
    Vehicles(const clq_trajectories *trajectories, const Plan &plan, const std::vector<Person> &people);

    // The place of a vehicle's front on the ground, or of the feet of who sits in one, and the direction ahead.
    struct Stand {
        double position[3], ahead_x, ahead_z;
    };
    Stand at(size_t person, double time_s) const;
    // The middle of the rear of a vehicle, or of that in which somebody rides.
    Stand rear(size_t person, double time_s) const;

    // Builds the vehicles that are there at a time.
    void place(double time_s);
    const Geometry &boxes() const { return boxes_; }
    // The dark below them, for Shadows::draw.
    const Geometry &shade() const { return shade_; }

private:
    struct Vehicle {
        size_t person = 0;  // its number among the people of the file
        size_t most = 0;    // riders at once
        bool is_bus() const { return most > 4; }
    };
    struct Ride {
        size_t person = 0, seat = 0;
        size_t vehicle = SIZE_MAX;  // of vehicles_; SIZE_MAX: none is near, and the rider is where the file says
    };
    double length_m(const Vehicle &vehicle) const;
    Stand front(size_t person, double time_s) const;
    void seat(Ride &ride, std::vector<std::vector<double>> &left_at) const;
    void build(const Vehicle &vehicle, const Stand &stand);

    const clq_trajectories *trajectories_;
    Plan plan_;
    const std::vector<Person> &people_;
    std::vector<Vehicle> vehicles_;
    std::vector<Ride> rides_;      // in the order of boarding
    std::vector<size_t> ride_of_;  // by person; SIZE_MAX: walks, or is a vehicle
    Geometry boxes_, shade_;
};

}  // namespace scenes::walkers
