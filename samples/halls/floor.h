// Grounds that a program describes: rectangles, walls, doors.
#pragma once

#include <claque/navigation.h>

#include <array>
#include <deque>
#include <memory>
#include <vector>

namespace halls
{

struct Destroy {
    void operator()(clq_navigation *p) const { clq_navigation_destroy(p); }
    void operator()(clq_walkers *p) const { clq_walkers_destroy(p); }
};
using OwnNavigation = std::unique_ptr<clq_navigation, Destroy>;
using OwnWalkers = std::unique_ptr<clq_walkers, Destroy>;

struct Floor {
    std::vector<double> vertices;
    std::vector<uint32_t> triangles;
    std::deque<std::vector<double>> outlines;  // of holes, doors and byways, which point here
    std::vector<clq_prism> holes, doors;
    std::vector<clq_byway> byways;
    float radius_m = clq_navigation_def_init().radius_m, cell_m = 0;

    // A rectangle, seen from above; its heights at the two ends in x.
    void add(double x0, double z0, double x1, double z1, double y0 = 0, double y1 = 0);
    // An upright wall as a hole.
    void wall(double x0, double z0, double x1, double z1);
    void byway(double x0, double z0, double x1, double z1, uint32_t group);
    void door(double x0, double z0, double x1, double z1);
    clq_navigation_def def() const;
    // Throws scenes::Failure.
    OwnNavigation make() const;

private:
    clq_prism box(double x0, double z0, double x1, double z1);
};

}  // namespace halls
