// Bodies keep apart by construction. With n the direction from one walker to another and g the gap between them, each
// moves by at most its share of g along n; the shares are 1 together at most, so the bodies do not touch after the
// move. These limits are half-planes that all hold at 0, so a walker can always stand. The best point in them: the
// incremental linear program of van den Berg, Guy, Lin and Manocha (Reciprocal n-body collision avoidance, 2011).
#include <algorithm>

#include "lib/stage/walk/steer.h"

namespace claque::walk
{

namespace
{

constexpr float off_wall_m = 0.02f;  // that a walker keeps from a wall: it turns round corners, not on them

constexpr float rounding_m = 1e-6f;  // two walls that share an end have the same limit there

struct Limit {
    Flat normal;
    float most;  // of the displacement along it, at least 0
};

struct Limits {
    std::array<Limit, max_near + max_walls> all;
    size_t count = 0;

    void add(Flat normal, float most) { all[count++] = {normal, most}; }
    void add_walls(const Surroundings &around)
    {
        for (int k = 0; k < around.wall_count; ++k) {
            const Wall &wall = around.walls[static_cast<size_t>(k)];
            add(wall.outside, std::max(wall.distance - off_wall_m, wall.distance / 2));
        }
    }
    // The point on the line of limit i that is nearest to `wanted` and within the limits before it.
    bool nearest_on(size_t i, Flat wanted, Flat &out) const
    {
        const Limit &line = all[i];
        const Flat on = times(line.normal, line.most), along = {-line.normal.z, line.normal.x};
        float low = -1e9f, high = 1e9f;
        for (size_t j = 0; j < i; ++j) {
            const float slope = dot(along, all[j].normal), room = all[j].most - dot(on, all[j].normal);
            if (slope > 1e-6f) high = std::min(high, room / slope);
            else if (slope < -1e-6f) low = std::max(low, room / slope);
            else if (room < -rounding_m) return false;
        }
        if (low > high) return false;
        const float t = std::clamp(dot(wanted, along), low, high);
        out = {on.x + t * along.x, on.z + t * along.z};
        return true;
    }
    Flat nearest(Flat wanted) const
    {
        Flat best = wanted;
        for (size_t i = 0; i < count; ++i)
            if (dot(best, all[i].normal) > all[i].most + rounding_m && !nearest_on(i, wanted, best))
                return {};  // rounding alone leads here
        return best;
    }
};

}  // namespace

Flat keep_apart(Flat wanted, const Surroundings &around)
{
    Limits limits;
    for (const Near &other : around)
        if (other.distance > 1e-6f) limits.add(other.direction(), std::max(0.0f, other.gap() * other.share));
    limits.add_walls(around);
    const float length = length_of(wanted), most = around.unseen_gap / 2;
    return limits.nearest(length > most ? times(wanted, most / length) : wanted);
}

Flat keep_off_walls(Flat wanted, const Surroundings &around)
{
    Limits limits;
    limits.add_walls(around);
    return limits.nearest(wanted);
}

}  // namespace claque::walk
