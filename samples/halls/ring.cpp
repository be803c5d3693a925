#include "samples/halls/ring.h"

#include <algorithm>

#include "samples/scenes/check.h"

namespace halls
{
namespace
{

constexpr double lane_m = 0.5;
constexpr int sectors = 16;

class Walk
{
public:
    Walk(double width_m, double people_per_m2, int ways, const Trial &trial)
        : ring_{width_m}, ways_(ways), tick_s_(trial.tick_s), floor_(ring_.floor()), crowd_(floor_, trial)
    {
        const auto count = static_cast<size_t>(people_per_m2 * ring_.area_m2());
        for (size_t tries = 0; crowd_.people.size() < count; ++tries) {
            if (tries == 1000000) throw scenes::Failure("the corridor is too full for so many people");
            const double angle = crowd_.number(-pi, pi),
                         radius_m = crowd_.number(ring_.inner_m + 0.3, ring_.outer_m - 0.3);
            crowd_.add(radius_m * std::cos(angle), radius_m * std::sin(angle));
        }
        goals_.resize(count), stopped_s_.resize(count);
        for (size_t i = 0; i < count; ++i) send(i);
    }

    void step(double time_s)
    {
        crowd_.step();
        for (size_t i = 0; i < goals_.size(); ++i) {
            const Person &one = crowd_.people[i];
            if (std::remainder(goals_[i] - std::atan2(one.z, one.x), 2 * pi) * way(i) < 0.35) send(i);
            const double along = one.moved_z * one.x - one.moved_x * one.z;
            const double made = way(i) * along / std::hypot(one.x, one.z) / tick_s_;
            if (time_s > 40) speeds_.push_back(made);
            stopped_s_[i] = made < 0.05 ? stopped_s_[i] + tick_s_ : 0;
            if (time_s > 10) longest_stop_s_ = std::max(longest_stop_s_, stopped_s_[i]);
        }
    }

    Round result()
    {
        const auto middle = speeds_.begin() + static_cast<ptrdiff_t>(speeds_.size() / 2);
        std::nth_element(speeds_.begin(), middle, speeds_.end());
        return {*middle, order(), longest_stop_s_, crowd_.nearest_m()};
    }

private:
    int way(size_t i) const { return ways_ == 2 && i % 2 ? -1 : 1; }
    void send(size_t i)
    {
        const Person &one = crowd_.people[i];
        const double radius_m = std::clamp(std::hypot(one.x, one.z), ring_.inner_m + 0.3, ring_.outer_m - 0.3);
        goals_[i] = std::atan2(one.z, one.x) + 0.6 * way(i);
        crowd_.go(one, radius_m * std::cos(goals_[i]), radius_m * std::sin(goals_[i]), 0.3f);
    }
    // In parts half a metre wide and a sixteenth of the round long, the square of the difference of the two kinds of
    // people over that of their sum (Rex and Loewen 2007).
    double order() const
    {
        std::vector<std::array<double, 2>> parts(size_t(sectors * std::ceil(ring_.width_m / lane_m)));
        for (size_t i = 0; i < goals_.size(); ++i) {
            const Person &one = crowd_.people[i];
            const double in_m =
                std::clamp(std::hypot(one.x, one.z), ring_.inner_m, ring_.outer_m - 1e-6) - ring_.inner_m;
            const auto sector = static_cast<size_t>((std::atan2(one.z, one.x) + pi) / (2 * pi) * sectors) % sectors;
            parts[static_cast<size_t>(in_m / lane_m) * sectors + sector][way(i) < 0] += 1;
        }
        double sum = 0;
        for (const auto &part : parts)
            if (part[0] + part[1] > 0) sum += (part[0] - part[1]) * (part[0] - part[1]) / (part[0] + part[1]);
        return sum / static_cast<double>(goals_.size());
    }

    Ring ring_;
    int ways_;
    double tick_s_;
    Floor floor_;
    Crowd crowd_;
    std::vector<double> goals_, speeds_, stopped_s_;
    double longest_stop_s_ = 0;
};

}  // namespace

Floor Ring::floor() const
{
    Floor made;
    constexpr int parts = 96;
    for (int i = 0; i < parts; ++i) {
        const auto first = static_cast<uint32_t>(made.vertices.size() / 3);
        for (const double angle : {2 * pi * i / parts, 2 * pi * (i + 1) / parts})
            for (const double radius_m : {inner_m, outer_m})
                for (const double x : {radius_m * std::cos(angle), 0.0, radius_m * std::sin(angle)})
                    made.vertices.push_back(x);
        for (const uint32_t k : {0u, 3u, 1u, 0u, 2u, 3u}) made.triangles.push_back(first + k);
    }
    made.cell_m = 0.08f;
    return made;
}

Round walked_round(double width_m, double people_per_m2, int ways, const Trial &trial)
{
    Walk walk(width_m, people_per_m2, ways, trial);
    for (double time_s = 0; time_s < 60; time_s += trial.tick_s) walk.step(time_s);
    return walk.result();
}

}  // namespace halls
