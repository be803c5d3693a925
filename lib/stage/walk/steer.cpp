// Direction: the search of Moussaid, Helbing and Theraulaz (How simple rules determine pedestrian behavior and crowd
// disasters, 2011) takes the heading that leads nearest to the goal before the first collision. Among oncoming walkers
// a walker keeps behind those of its own direction, and lanes form. Speed: the collision-free speed model of Tordeux,
// Chraibi and Seyfried (2016) divides the gap ahead by a time. Cost: 17 headings times the bodies and walls around.
#include "lib/stage/walk/steer.h"

#include <algorithm>

namespace claque::walk
{

namespace
{

// Cosine and sine of 0, 11.25, ... 90 degrees to either side.
constexpr float turns[][2] = {{1, 0},
                              {0.98078528f, 0.19509032f},
                              {0.92387953f, 0.38268343f},
                              {0.83146961f, 0.55557023f},
                              {0.70710678f, 0.70710678f},
                              {0.55557023f, 0.83146961f},
                              {0.38268343f, 0.92387953f},
                              {0.19509032f, 0.98078528f},
                              {0, 1}};
constexpr int headings = 17;
bool is_left(int k) { return k > 0 && k % 2 == 0; }

// Chosen by the tests of doors, rings and counterflow together (tests/unit/walk/queues_test.cpp).
constexpr float horizon_m = 4;          // a collision farther away does not count
constexpr float anticipation_s = 0.3f;  // the one ahead is taken to be where it will be by then
constexpr float turn_cost_m2 = 0.15f;   // of turning back; a quarter turn costs half
constexpr float left_cost_m2 = 0.1f;    // so that two who meet pass on the same side
constexpr float oncoming_cost = 5, follow_gain = 2;
constexpr float press_m = 0.2f;  // a walker that gives way is no obstacle if it is so near
// A walker that stands starts at more than the speed at which one that walks stops: it does not tremble.
constexpr float start_m_s = 0.18f, stop_m_s = 0.08f;
constexpr float brisk_m_s = 1;  // a walker that is faster brakes before it goes round
// With one time gap for all gaps the model is slower than people at 1 a square metre, and faster at 3 (Weidmann 1993).
// The part of a gap beyond long_gap_m is divided by long_gap_time_s.
constexpr float long_gap_m = 0.7f, long_gap_time_s = 0.5f;

// How far a walker gets in a direction before it touches the other, if both go on.
float free_way(const Near &other, Flat direction, float speed, float reach)
{
    if (other.gives_way && other.gap() < press_m) return reach;
    if (other.gap() <= 1e-3f) return dot(other.at, direction) > 0.02f ? 0 : reach;
    const Flat closing = {speed * direction.x - other.velocity.x, speed * direction.z - other.velocity.z};
    const float towards = dot(other.at, closing), squared = dot(closing, closing);
    if (!(towards > 0)) return reach;
    const float apart = other.distance * other.distance - other.bodies * other.bodies;
    const float root = towards * towards - squared * apart;
    if (!(root > 0)) return reach;
    return std::min(reach, speed * (towards - std::sqrt(root)) / squared);
}

float free_way(const Wall &wall, Flat direction, float reach)
{
    const Flat along = {wall.to.x - wall.from.x, wall.to.z - wall.from.z};
    const float outwards = cross(along, direction);
    if (!(outwards > 1e-6f)) return reach;  // it would come from behind the wall
    const float way = cross(along, wall.from) / outwards, part = cross(direction, wall.from) / outwards;
    return way >= -0.01f && part >= 0 && part <= 1 ? std::clamp(way, 0.0f, reach) : reach;
}

// The cost of a heading among oncoming walkers.
float lane_cost(const Wish &wish, const Surroundings &around, Flat heading)
{
    float cost = 0;
    for (const Near &other : around) {
        const float ahead = dot(other.at, heading);
        if (!(ahead > 0)) continue;
        const float cosine = ahead / other.distance, squared = cosine * cosine;
        const float weight = squared * squared / (0.5f + other.gap());
        const float follows = dot(other.velocity, wish.direction) / wish.speed;
        if (other.opposes) cost += oncoming_cost * weight;
        else if (follows > 0.1f) cost -= follow_gain * weight * std::min(1.0f, follows);
    }
    return cost;
}

float gap_ahead(const Surroundings &around, Flat heading)
{
    float gap = 1e9f;
    for (const Near &other : around) {
        const float aside = std::fabs(cross(heading, other.at));
        if (!(dot(other.at, heading) > 0) || aside > other.bodies || other.gives_way) continue;
        gap = std::min(gap, other.gap() + anticipation_s * dot(other.velocity, heading));
    }
    return std::max(gap, 0.0f);
}

// At which a walker goes on with a heading; 0: it stands.
float speed_on(const Wish &wish, const Surroundings &around, Flat heading)
{
    float speed = wish.speed;
    if (wish.time_gap_s > 0) {
        const float gap = gap_ahead(around, heading), beyond = std::max(0.0f, gap - long_gap_m);
        speed = std::min(speed, (gap - beyond) / wish.time_gap_s + beyond / std::min(wish.time_gap_s, long_gap_time_s));
    }
    return speed < (wish.speed_now < stop_m_s ? start_m_s : stop_m_s) ? 0 : speed;
}

Flat heading_of(int k, Flat direction)
{
    const float *turn = turns[(k + 1) / 2];
    const float cosine = turn[0], sine = is_left(k) ? -turn[1] : turn[1];
    return {cosine * direction.x - sine * direction.z, sine * direction.x + cosine * direction.z};
}

float cost_of(int k, Flat heading, const Wish &wish, const Surroundings &around)
{
    const float reach = std::min(horizon_m, wish.in_sight_m), cosine = turns[(k + 1) / 2][0];
    float way = reach;
    for (const Near &other : around) way = std::min(way, free_way(other, heading, wish.speed, reach));
    for (int n = 0; n < around.wall_count; ++n)
        way = std::min(way, free_way(around.walls[static_cast<size_t>(n)], heading, reach));
    float cost = reach * reach + way * way - 2 * reach * way * cosine;
    if (wish.speed_now > 0) cost += turn_cost_m2 * (1 - dot(wish.heading, heading));
    if (is_left(k)) cost += left_cost_m2;
    if (around.meets) cost += lane_cost(wish, around, heading);
    return cost;
}

}  // namespace

Flat choose_velocity(const Wish &wish, const Surroundings &around)
{
    std::array<float, headings> costs;
    const auto is_better = [&](int k, int best) { return costs[size_t(k)] < costs[size_t(best)] - 1e-6f; };
    int best = 0;
    for (int k = 0; k < headings; ++k) {
        costs[size_t(k)] = cost_of(k, heading_of(k, wish.direction), wish, around);
        if (is_better(k, best)) best = k;
    }
    const Flat chosen = heading_of(best, wish.direction);
    float speed = speed_on(wish, around, chosen);
    if (speed > 0 || !around.meets || wish.speed_now > brisk_m_s) return times(chosen, speed);
    // Where people meet, one that would stand goes round: queues that stand beside a lane that walks would stand long.
    int moving = -1;
    for (int k = 0; k < headings; ++k) {
        const float on = speed_on(wish, around, heading_of(k, wish.direction));
        if (on > 0 && (moving < 0 || is_better(k, moving))) moving = k, speed = on;
    }
    return moving < 0 ? Flat() : times(heading_of(moving, wish.direction), speed);
}

}  // namespace claque::walk
