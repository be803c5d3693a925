// People on a floor who all walk at speeds of their own, and how near they come to each other.
#pragma once

#include <cmath>
#include <random>

#include "samples/halls/floor.h"

namespace halls
{

constexpr double pi = 3.14159265358979323846;

struct Trial {
    unsigned seed = 1;
    double tick_s = 0.05;
    double least_m_s = 0, most_m_s = 0;  // range of preferred speeds before a door; 0: Weidmann's
};

struct Person {
    clq_walker id;
    double x, z;
    double moved_x = 0, moved_z = 0;  // in the last tick
};

// All throw scenes::Failure.
class Crowd
{
public:
    // Speeds are spread as Weidmann states (Transporttechnik der Fussgaenger, 1993).
    Crowd(const Floor &floor, const Trial &trial);

    // Returns false where somebody stands. Speed 0 draws one from Weidmann's distribution.
    bool add(double x, double z, float speed_m_s = 0);
    double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
    void go(const Person &one, double x, double z, float near_m, double y = 0);
    void remove(size_t i);
    void step();
    // The shortest distance between two centres in all steps so far.
    double nearest_m() const { return std::sqrt(nearest_m2_); }
    clq_navigation *navigation() const { return navigation_.get(); }

    std::vector<Person> people;

private:
    OwnNavigation navigation_;
    OwnWalkers walkers_;
    std::mt19937 random_;
    double nearest_m2_ = HUGE_VAL;
};

// Speed at a density (Weidmann 1993).
double weidmann_m_s(double people_per_m2);

}  // namespace halls
