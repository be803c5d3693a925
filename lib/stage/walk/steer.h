// How a walker among others chooses where it goes, and how bodies keep apart. Neither mesh nor crowd: places in a
// plane, from the walker, in metres.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace claque::walk
{

struct Flat {
    float x = 0, z = 0;
};

inline float dot(Flat a, Flat b) { return a.x * b.x + a.z * b.z; }
inline float cross(Flat a, Flat b) { return a.x * b.z - a.z * b.x; }
inline float length_of(Flat a) { return std::sqrt(dot(a, a)); }
inline Flat times(Flat a, float s) { return {a.x * s, a.z * s}; }
// The vector of length 1 in the same direction; 0 stays 0.
inline Flat unit(Flat a)
{
    const float length = length_of(a);
    return length > 0 ? Flat{a.x / length, a.z / length} : Flat{};
}

// Another body.
struct Near {
    uint32_t index = 0;
    Flat at, velocity;
    float distance = 0;      // of the centres
    float bodies = 0;        // the distance at which the bodies touch: the two radii
    float share = 0.5f;      // of the gap between, for this walker: the shares of two walkers are 1 together at most
    bool stays = false;      // it stands where it is
    bool opposes = false;    // it goes the other way
    bool gives_way = false;  // it goes the same way, and has farther to go

    float gap() const { return distance - bodies; }
    Flat direction() const { return {at.x / distance, at.z / distance}; }
};

// A border of the ground.
struct Wall {
    Flat from, to;
    Flat outside;  // of length 1: to its nearest point, or away from the ground
    float distance = 0;
};

constexpr int max_near = 16, max_walls = 8;

struct Surroundings {
    std::array<Near, max_near> near;  // by the gap
    std::array<Wall, max_walls> walls;
    int near_count = 0, wall_count = 0;
    float unseen_gap = 0;  // at least: to each body that is not among these
    bool meets = false;    // one of them opposes

    const Near *begin() const { return near.data(); }
    const Near *end() const { return near.data() + near_count; }
};

// A turn of a way, in the plane of the mesh, and how far it is along the way.
struct Corner {
    Flat at;
    float left_m = 0;
};
constexpr int max_shared = 8;

// What a walker would do alone.
struct Wish {
    Flat direction;                          // of length 1: of its way
    Flat onward;                             // of length 1: to a place some steps ahead on its way
    float speed = 0;                         // 0: it goes nowhere
    float time_gap_s = 0;                    // to the one before it
    float in_sight_m = 0;                    // of its way, up to its goal
    float left_m = 0;                        // of its way, as far as it is known
    std::array<Corner, max_shared> corners;  // the next ones and the last one
    int corner_count = 0;
    Flat heading;  // of length 1: of its movement now; 0: it stands
    float speed_now = 0;
};

// The velocity that a walker takes if the others go on as they do.
Flat choose_velocity(const Wish &wish, const Surroundings &around);

// The displacement nearest to `wanted` that leaves each other body its share of the gap, and crosses no wall.
Flat keep_apart(Flat wanted, const Surroundings &around);
// The same for walls alone.
Flat keep_off_walls(Flat wanted, const Surroundings &around);

}  // namespace claque::walk
