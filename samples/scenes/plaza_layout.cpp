#include "samples/scenes/plaza_layout.h"

#include <algorithm>

#include "samples/scenes/angles.h"
#include "samples/scenes/occupancy_grid.h"
#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

class Planner
{
public:
    Planner(uint32_t count, uint64_t seed, double walk_speed, double size)
        : count_(count), seed_(seed), wide_street_(count >= 150)
    {
        plan_.half_x = 13.5 * size;
        plan_.half_z = 16.5 * size;
        const double street = wide_street_ ? 4.4 : 2.55;  // the walkers' lanes, along the edge
        inner_x_ = plan_.half_x - street;
        inner_z_ = plan_.half_z - street;
        lay_lanes(walk_speed);
        plan_.fountain_radius = 2.1;
        plan_.fountain[0] = -0.42 * inner_x_;
        plan_.fountain[1] = -0.45 * inner_z_;
        plan_.rostra[0] = 0.42 * inner_x_;
        plan_.rostra[1] = inner_z_ - 2.5;  // its steps end where walkers pass
        plan_.rostra_half[0] = 1.6;
        plan_.rostra_half[1] = 1.55;
        plan_.rostra_height = 0.9;
        plan_.close_eye[0] = -0.12 * inner_x_;
        plan_.close_eye[1] = inner_z_ - 0.9;
        plan_.close_target[0] = plan_.close_eye[0] - 0.8;
        plan_.close_target[1] = plan_.close_eye[1] - 6.0;
    }

    // Returns false if there was no room for all.
    bool plan(PlazaLayout &out)
    {
        foreground();
        if (left() > 0) speaker();
        walkers();
        listeners();
        talkers();
        out = plan_;
        return left() == 0;
    }

private:
    uint32_t left() const
    {
        return count_ - static_cast<uint32_t>(plan_.standing.size()) - static_cast<uint32_t>(plan_.walking.size());
    }

    void lay_lanes(double walk_speed)
    {
        const double middle = wide_street_ ? 2.2 : 1.25;
        for (uint32_t lane = 0; lane < (wide_street_ ? 4u : 2u); ++lane) {
            const double offset = wide_street_ ? 1.35 - 0.9 * lane : 0.45 - 0.9 * lane;
            const double in = middle - offset;  // of the edge
            const double pace = walk_speed * random_between(seed_, lane, Purpose::lane, 0.96, 1.04);
            const bool back = wide_street_ ? lane >= 2 : lane == 1;
            plan_.lanes.push_back({Circuit(plan_.half_x - in, plan_.half_z - in, 4.6 - in), back ? -pace : pace});
        }
    }

    void add(double x, double y, double z, double to_x, double to_z, Standing::Role role)
    {
        if (left() == 0) return;
        const uint64_t person = plan_.standing.size();
        const double turn = random_between(seed_, person, Purpose::heading, -0.22, 0.22);
        const double dx = to_x - x, dz = to_z - z;
        plan_.standing.push_back({x, y, z, dx + turn * dz, dz - turn * dx, role});
        room_.take(x, z);
    }

    // Two small groups in good view of the close camera, with their open side towards it.
    void foreground()
    {
        const double *eye = plan_.close_eye, *target = plan_.close_target;
        const double length =
            std::sqrt((target[0] - eye[0]) * (target[0] - eye[0]) + (target[1] - eye[1]) * (target[1] - eye[1]));
        const double dx = (target[0] - eye[0]) / length, dz = (target[1] - eye[1]) / length;
        const auto ring = [&](double ahead, double right, double radius, std::initializer_list<double> angles_deg) {
            const double x = eye[0] + dx * ahead - dz * right, z = eye[1] + dz * ahead + dx * right;
            for (double angle : angles_deg) {
                const double s = std::sin(angle * radians), c = std::cos(angle * radians);
                const double px = x + radius * (dx * c - dz * s), pz = z + radius * (dz * c + dx * s);
                // Between the others and the eye, so that faces are visible.
                add(px, 0, pz, x - 1.1 * dx, z - 1.1 * dz, Standing::Role::talker);
            }
        };
        ring(3.7, -0.55, 0.62, {-82, 2, 74});
        ring(5.3, 1.45, 0.55, {-70, 75});
    }

    void speaker()
    {
        // Back from the edge, so that the shadow falls on the platform.
        add(plan_.rostra[0] - 0.2, plan_.rostra_height, plan_.rostra[1] + 0.35, plan_.rostra[0] - 0.5,
            plan_.rostra[1] - 5, Standing::Role::speaker);
    }

    void walkers()
    {
        const uint32_t wanted = std::min(left(), count_ * 23 / 100);
        const uint32_t lanes = static_cast<uint32_t>(plan_.lanes.size());
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const double length = plan_.lanes[lane].way.length();
            const uint32_t share = wanted / lanes + (lane < wanted % lanes ? 1 : 0);
            const uint32_t walkers = std::min(share, static_cast<uint32_t>(length / 2.2));
            const double gap = walkers > 0 ? length / walkers : 0;
            for (uint32_t k = 0; k < walkers; ++k) {
                const double jitter = random_between(seed_, lane * 100000u + k, Purpose::gap, -0.27, 0.27);
                plan_.walking.push_back({lane, gap * (k + jitter)});
            }
        }
    }

    void listeners()
    {
        uint32_t wanted = std::min(left(), count_ * 30 / 100);
        uint64_t draw = 0;
        for (double radius = 3.6; wanted > 0 && radius < 0.9 * inner_z_; radius += 1.02)
            for (double at = -1.05 * radius; at < 1.0 * radius && wanted > 0; at += 0.98, ++draw) {
                const double angle = (at + random_between(seed_, draw, Purpose::place_x, -0.2, 0.2)) / radius - 0.15;
                const double r = radius + random_between(seed_, draw, Purpose::radius, -0.22, 0.22);
                const double x = plan_.rostra[0] + r * std::sin(angle), z = plan_.rostra[1] - r * std::cos(angle);
                if (!may_stand(x, z, 0.86)) continue;
                add(x, 0, z, plan_.rostra[0], plan_.rostra[1], Standing::Role::listener);
                --wanted;
            }
    }

    void talkers()
    {
        uint32_t failures = 0;
        for (uint64_t draw = 0; left() > 0 && failures < 600; ++draw) {
            const double x = random_between(seed_, draw, Purpose::place_x, -inner_x_, inner_x_);
            const double z = random_between(seed_, draw, Purpose::place_z, -inner_z_, inner_z_);
            // When large groups no longer fit, small ones still may.
            if (!gather(x, z, std::min(group_size(draw), failures > 450 ? 1u : failures > 250 ? 2u : 5u), draw))
                ++failures;
            else failures -= std::min(failures, 12u);
        }
    }

    uint32_t group_size(uint64_t draw) const
    {
        const double share = random_unit(seed_, draw, Purpose::group_size);
        return share < 0.10 ? 1 : share < 0.40 ? 2 : share < 0.70 ? 3 : share < 0.90 ? 4 : 5;
    }

    bool gather(double x, double z, uint32_t size, uint64_t draw)
    {
        constexpr double radii[] = {0, 0.0, 0.50, 0.58, 0.68, 0.80};
        const double first = random_between(seed_, draw, Purpose::heading, 0, 360 * radians);
        double px[5], pz[5];
        for (uint32_t k = 0; k < size; ++k) {
            const double angle =
                first + (k + random_between(seed_, draw * 8 + k, Purpose::row, -0.08, 0.08)) * 360 * radians / size;
            px[k] = x + radii[size] * std::sin(angle);
            pz[k] = z + radii[size] * std::cos(angle);
            if (!may_stand(px[k], pz[k], 1.02)) return false;
        }
        const double look_x = x + (size == 1 ? std::sin(first) : 0), look_z = z + (size == 1 ? std::cos(first) : 0);
        for (uint32_t k = 0; k < size; ++k) add(px[k], 0, pz[k], look_x, look_z, Standing::Role::talker);
        return true;
    }

    bool may_stand(double x, double z, double distance) const
    {
        if (std::abs(x) > inner_x_ || std::abs(z) > inner_z_) return false;
        const double fx = x - plan_.fountain[0], fz = z - plan_.fountain[1], basin = plan_.fountain_radius + 0.75;
        if (fx * fx + fz * fz < basin * basin) return false;
        if (std::abs(x - plan_.rostra[0]) < plan_.rostra_half[0] + 0.6 &&
            std::abs(z - plan_.rostra[1]) < plan_.rostra_half[1] + 1.3)
            return false;
        // Keeps the view of the close camera clear: a wedge before it, out to its two groups.
        const double ex = x - plan_.close_eye[0], ez = z - plan_.close_eye[1];
        const double tx = plan_.close_target[0] - plan_.close_eye[0], tz = plan_.close_target[1] - plan_.close_eye[1];
        const double scale = 1 / std::sqrt(tx * tx + tz * tz);
        const double ahead = (ex * tx + ez * tz) * scale, aside = std::abs(ex * tz - ez * tx) * scale;
        if (ahead > -0.8 && ahead < 5.6 && aside < 0.9 + 0.55 * std::max(ahead, 0.0)) return false;
        return room_.free(x, z, distance);
    }

    PlazaLayout plan_;
    uint32_t count_;
    uint64_t seed_;
    bool wide_street_;
    double inner_x_, inner_z_;  // bounds of the standing people
    OccupancyGrid room_;
};

}  // namespace

PlazaLayout lay_out_plaza(uint32_t count, uint64_t seed, double walk_speed)
{
    PlazaLayout layout;
    double size = std::max(0.62, std::sqrt(count / 400.0));
    while (!Planner(count, seed, walk_speed, size).plan(layout)) size *= 1.05;  // a larger square until all fit
    return layout;
}

}  // namespace scenes
