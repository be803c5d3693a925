#include "samples/halls/door.h"

#include <algorithm>

namespace halls
{

const Door doors[5] = {
    {0.8, 80, 0.9, 1.7, 10}, {1.0, 150, 0.9, 1.7, 10}, {1.2, 150, 1.1, 1.9, 3},
    {2.0, 150, 1.1, 1.9, 3}, {4.0, 300, 1.1, 1.9, 3},
};

const Opening openings[6] = {{0.8, 30}, {1.0, 30}, {1.2, 30}, {2.0, 30}, {3.0, 30}, {2.0, 60}};

Floor hall_with_opening(double width_m)
{
    Floor hall;
    hall.add(-8, -16, 8, 13);
    hall.wall(-8.5, 0, -width_m / 2, 0.3);
    hall.wall(width_m / 2, 0, 8.5, 0.3);
    return hall;
}

Passage through_a_door(double width_m, size_t count, const Trial &trial)
{
    const Floor hall = hall_with_opening(width_m);
    Crowd crowd(hall, trial);
    const double tick_s = trial.tick_s;
    const auto speed = [&] {
        return trial.most_m_s > 0 ? static_cast<float>(crowd.number(trial.least_m_s, trial.most_m_s)) : 0;
    };
    while (crowd.people.size() < count) {
        const double z = crowd.number(-15.5, -1), x = crowd.number(-7.5, 7.5);
        crowd.add(x, z, speed());
    }
    for (const Person &one : crowd.people) crowd.go(one, 0, 11.5, 0.5f);
    Passage passage;
    double full_s = 0, last_s = NAN;
    size_t passed = 0;
    const double waiting_m2 = 2 * width_m + pi * 2;
    for (double time_s = 0; time_s < 300 && !crowd.people.empty(); time_s += tick_s) {
        crowd.step();
        size_t waiting = 0, passing = 0;
        for (const Person &one : crowd.people) {
            waiting += one.z < 0 && std::hypot(std::max(0.0, std::fabs(one.x) - width_m / 2), one.z) < 2;
            if (one.z < 0.15 || one.z - one.moved_z >= 0.15) continue;
            ++passing;
            if (!std::isnan(last_s)) passage.longest_pause_s = std::max(passage.longest_pause_s, time_s - last_s);
            last_s = time_s;
        }
        if (static_cast<double>(waiting) > 2 * waiting_m2) full_s += tick_s, passed += passing;
        for (size_t i = crowd.people.size(); i-- > 0;)
            if (crowd.people[i].z > 8) crowd.remove(i);
    }
    passage.flow = static_cast<double>(passed) / full_s / width_m;
    passage.nearest_m = crowd.nearest_m();
    passage.left = crowd.people.size();
    return passage;
}

Meeting meet_at_a_door(double width_m, size_t count, const Trial &trial)
{
    const Floor hall = hall_with_opening(width_m);
    Crowd crowd(hall, trial);
    while (crowd.people.size() < 2 * count) {
        const double side = crowd.people.size() % 2 ? 1 : -1;
        const double z = 0.15 + side * crowd.number(1, 4), x = crowd.number(-3, 3);
        crowd.add(x, z);
    }
    for (const Person &one : crowd.people) crowd.go(one, 0, one.z > 0 ? -11.5 : 11.5, 0.5f);
    Meeting meeting;
    for (; meeting.last_s < 300 && !crowd.people.empty(); meeting.last_s += trial.tick_s) {
        crowd.step();
        for (size_t i = crowd.people.size(); i-- > 0;)
            if (std::fabs(crowd.people[i].z) > 8) crowd.remove(i);
    }
    meeting.nearest_m = crowd.nearest_m();
    meeting.left = crowd.people.size();
    return meeting;
}

}  // namespace halls
