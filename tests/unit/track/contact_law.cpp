#include "tests/unit/track/contact_law.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace claque::test
{

WayFunction ahead(double speed)
{
    return [speed](double t) { return glm::dvec2(0, speed * t); };
}

WayFunction corner(double speed, double degrees)
{
    const double turn = degrees * M_PI / 180;
    return [=](double t) {
        const double before = speed * std::min(t, 4.0), after = speed * std::max(0.0, t - 4);
        return glm::dvec2(after * std::sin(turn), before + after * std::cos(turn));
    };
}

WayFunction circle(double speed, double radius)
{
    return [=](double t) { return radius * glm::dvec2(std::cos(speed * t / radius), std::sin(speed * t / radius)); };
}

WayFunction stop_and_go(double speed, double walks_s, double stands_s)
{
    return [=](double t) {
        const double each = walks_s + stands_s, rounds = std::floor(t / each);
        return glm::dvec2(0, speed * (rounds * walks_s + std::min(walks_s, t - rounds * each)));
    };
}

WayFunction shuffle(double step_m, double every_s)
{
    return [=](double t) {
        const double number = std::floor(t / every_s), part = std::min(1.0, t / every_s - number);
        const auto place = [=](double k) { return step_m * glm::dvec2(std::cos(2.4 * k), std::sin(2.4 * k)); };
        const double gone = part * part * (3 - 2 * part);
        return place(number) + (place(number + 1) - place(number)) * gone;
    };
}

void expect_law_of_others(const std::string &name, const Contacts &contacts)
{
    std::printf("%-34s | %s\n", name.c_str(), contacts.row().c_str());
    EXPECT_LE(contacts.holds.max(), 0.021) << name << ": viewers notice 21 mm";
    EXPECT_LE(contacts.turns.max(), 10) << name;
    EXPECT_LE(contacts.depths.max(), 0.003) << name;
    if (contacts.lifts.each.empty()) return;
    EXPECT_GT(contacts.lifts.min(), 0.010) << name;
}

void expect_law(const std::string &name, const Contacts &contacts)
{
    expect_law_of_others(name, contacts);
    EXPECT_GT(contacts.slips.each.size(), 3u) << name;
    EXPECT_LE(contacts.slips.mean(), 0.005) << name;
    EXPECT_LE(contacts.slips.at_share(0.95), 0.010) << name;
    EXPECT_LE(contacts.slips.max(), 0.021) << name;
    EXPECT_LE(contacts.flats.max(), 0.002) << name;
    EXPECT_EQ(contacts.dragged, 0) << name;
}

std::string numbered(const char *form, double a, double b)
{
    char text[80];
    std::snprintf(text, sizeof text, form, a, b);
    return text;
}

}  // namespace claque::test
