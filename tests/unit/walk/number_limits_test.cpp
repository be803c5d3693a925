// Each number of grounds and walkers is taken up to its limit and refused by name beyond it, at either end.
#include <limits>
#include <string>
#include <type_traits>

#include "tests/unit/walk/floors.h"

using floors::Held;

namespace
{

template <class Number>
Number beside(Number x, bool above)
{
    if constexpr (std::is_floating_point_v<Number>)
        return std::nextafter(
            x, above ? std::numeric_limits<Number>::infinity() : -std::numeric_limits<Number>::infinity());
    else return above ? x + 1 : x - 1;
}

// The last number on this side of a limit.
template <class Number>
Number within(double limit, bool from_below)
{
    Number x = static_cast<Number>(limit);
    if (from_below ? double(x) > limit : double(x) < limit) x = beside(x, !from_below);
    return x;
}

// `make` gives the status of a def. A def at a limit may be refused for something else.
template <class Def, class Number, class Make>
void expect_limits(const Def &usual, const char *name, Number Def::*member, double low, double high, const Make &make)
{
    const auto is_named = [&](Number value) {
        Def def = usual;
        def.*member = value;
        if (make(def) != CLQ_ARGUMENT) return false;
        return std::string(clq_last_error()).find(std::string(name) + " is ") != std::string::npos;
    };
    const Number least = within<Number>(low, false), most = within<Number>(high, true);
    EXPECT_FALSE(is_named(least)) << clq_last_error();
    EXPECT_FALSE(is_named(most)) << clq_last_error();
    EXPECT_TRUE(is_named(beside(least, false))) << name << " just below its least";
    EXPECT_TRUE(is_named(beside(most, true))) << name << " just above its most";
    if constexpr (std::is_floating_point_v<Number>) EXPECT_TRUE(is_named(std::numeric_limits<Number>::quiet_NaN()));
}

}  // namespace

TEST(NumberLimits, OfGrounds)
{
    using Def = clq_navigation_def;
    floors::Floor floor;
    floor.add(0, 0, 6, 6);
    const auto make = [](const Def &def) {
        clq_navigation *made = nullptr;
        const clq_status status = clq_navigation_create(&def, &made);
        clq_navigation_destroy(made);
        return status;
    };
    Def usual = floor.def();
    usual.max_cells = 100000;
    expect_limits(usual, "metres_per_unit", &Def::metres_per_unit, 1e-6, 1e6, make);
    expect_limits(usual, "radius_m", &Def::radius_m, 0.05, 5, make);
    expect_limits(usual, "height_m", &Def::height_m, 0.2, 10, make);
    expect_limits(usual, "max_slope_deg", &Def::max_slope_deg, 0, 85, make);
    expect_limits(usual, "max_step_m", &Def::max_step_m, 0, 2, make);
    expect_limits(usual, "cell_m", &Def::cell_m, 0.02, 2, make);
}

TEST(NumberLimits, OfWalkers)
{
    using Def = clq_walkers_def;
    const Held held(floors::two_rooms(false));
    const auto make = [&](const Def &def) {
        clq_walkers *made = nullptr;
        const clq_status status = clq_walkers_create(held.navigation, &def, &made);
        clq_walkers_destroy(made);
        return status;
    };
    const Def usual = clq_walkers_def_init();
    expect_limits(usual, "max_count", &Def::max_count, 1, 16000, make);
    expect_limits(usual, "max_radius_m", &Def::max_radius_m, 0.05, 2, make);
    expect_limits(usual, "start_s", &Def::start_s, -1e9, 1e9, make);
    expect_limits(usual, "tick_s", &Def::tick_s, 0.01, 0.2, make);
    expect_limits(usual, "piece_ticks", &Def::piece_ticks, 2, 200, make);
    expect_limits(usual, "plans", &Def::plans, 1, 16000, make);
    expect_limits(usual, "smooth_s", &Def::smooth_s, 0, 2, make);
    expect_limits(usual, "time_gap_s", &Def::time_gap_s, 0, 5, make);
    expect_limits(usual, "climbing", &Def::climbing, 0.01, 1, make);
    expect_limits(usual, "descending", &Def::descending, 0.01, 1, make);
    for (const auto &[ticks, tick_s, good] :
         {std::tuple<uint32_t, double, bool>{10, 0.01, true}, {9, 0.01, false}, {50, 0.2, true}, {51, 0.2, false}}) {
        Def def = usual;
        def.piece_ticks = ticks, def.tick_s = tick_s;
        EXPECT_EQ(make(def), good ? CLQ_OK : CLQ_ARGUMENT) << ticks << ", " << tick_s;
    }
}

TEST(NumberLimits, OfAWalker)
{
    using Def = clq_walker_def;
    const Held held(floors::two_rooms(false));
    const auto make = [&](const Def &def) {
        clq_walker made = {0, 0};
        const clq_status status = clq_walkers_add(held.walkers, &def, &made);
        if (status == CLQ_OK) EXPECT_EQ(clq_walkers_remove(held.walkers, made), CLQ_OK);
        return status;
    };
    Def usual = clq_walker_def_init();
    usual.position[0] = 2, usual.position[2] = 3;
    expect_limits(usual, "heading_rad", &Def::heading_rad, -1e6, 1e6, make);
    expect_limits(usual, "radius_m", &Def::radius_m, 0.05, double(clq_walkers_def_init().max_radius_m), make);
    expect_limits(usual, "speed_m_s", &Def::speed_m_s, 0.01, 8, make);
    expect_limits(usual, "acceleration_m_s2", &Def::acceleration_m_s2, 0.1, 50, make);
    expect_limits(usual, "scale", &Def::scale, 1e-3, 1e3, make);

    struct Go {
        float near_m = 1, speed_m_s = 1;
    };
    const clq_walker walker = held.add(2, 3);
    const auto go = [&](const Go &how) {
        const double goal[3] = {5, 0, 3};
        return clq_walker_go(held.walkers, walker, goal, how.near_m, how.speed_m_s);
    };
    expect_limits(Go(), "near_m", &Go::near_m, 0.05, 100, go);
    expect_limits(Go(), "speed_m_s", &Go::speed_m_s, 0, 8, go);
}
