// How many people go through doors.
#pragma once

#include <string>
#include <vector>

namespace staged
{

struct DoorCount {
    std::string name;
    double width_m;
    std::vector<double> passed_s;  // a time for each person that came out of it, on either side
};

// People per second and metre while a door is full: from the first tenth of them to the last. 0: fewer than 20 people.
double flow_of(std::vector<double> times_s, double width_m);

}  // namespace staged
