// A track: the path of one actor as a function of time, with its heading, the phase and gait of its clips, and the
// places where its feet stand. Immutable; any time is evaluated by itself, in constant time.
#pragma once

#include <glm/vec3.hpp>

#include "lib/track/locomotion.h"

namespace claque::track
{

// One sample on the uniform grid.
struct Sample {
    int32_t x = 0, z = 0;  // from the origin, in steps of place_step_m
    uint16_t height = 0;   // from min_height_m, in steps of height_step_m
    uint16_t heading = 0;  // 65536 to a turn
    uint16_t phase = 0;    // 65536 to a cycle
    uint8_t gait = 0;      // gait_unit: walks
    uint8_t flags = 0;     // stands, and the idle clip above it
};
static_assert(sizeof(Sample) == 16, "a sample has 16 bytes");

constexpr double place_step_m = 1.0 / 8192;
constexpr double gait_unit = 127;
constexpr double max_foot_turn_rad = 0.7;  // of a foot against its body
constexpr double landing_s = 0.08;         // in which the ground takes hold of a foot and lets it go
constexpr uint8_t stands_flag = 1;
constexpr uint32_t idle_shift = 1;

// A foot on the ground from begin_s to end_s, seconds from the start of the track. Metres from the track's origin.
struct Plant {
    float begin_s = 0, end_s = 0;
    float x = 0, z = 0;     // of the ball of the foot
    float heading_rad = 0;  // of the body, while the foot is turned as its clip turns it
    // How far the clips' own foot is from there, when the foot comes down and when it is lifted.
    float begin_x = 0, begin_z = 0, end_x = 0, end_z = 0;
};

// The way from where the clips have a foot to where it is shown, in the air.
struct Correction {
    double x = 0, z = 0, turn_rad = 0;
};

// Of a piece whose border cuts the swing of a foot: what the piece before showed besides, fading until it lands.
struct Swing {
    float x = 0, z = 0, turn_rad = 0;
    float until_s = 0;
};

struct Track {
    explicit Track(std::pmr::memory_resource *memory)
        : samples(memory),
          plants{Array<Plant>(memory), Array<Plant>(memory)},
          first_plants{Array<uint32_t>(memory), Array<uint32_t>(memory)}
    {
    }

    const Locomotion *locomotion = nullptr;  // the owner keeps it
    glm::dvec3 origin_m = glm::dvec3(0);     // metres
    double start_s = 0, length_s = 0;
    double rate_hz = 10;
    double min_height_m = 0, height_step_m = 0;
    double metres_per_unit = 1;       // of the world
    double scale = 1;                 // metres per model unit
    double top_speed = 0;             // an upper bound, in world units a second
    Array<Sample> samples;            // [length_s * rate_hz + 1]
    Array<Plant> plants[2];           // by begin_s; they do not overlap
    Array<uint32_t> first_plants[2];  // by whole second: the first plant that ends after it began
    // Of a piece (piece.h). Plants that began before it have negative times, and one may lie behind its end.
    uint64_t previous_hash = 0;  // 0: it continues none
    Swing swings[2];
    uint32_t stand_count = 0;  // times that the person stood, with the pieces before

    // From what it was made of.
    double mean_shift_m = 0, max_shift_m = 0;  // between the given and the shown path, at the given times
    double distance_m = 0, standing_s = 0;
    uint64_t hash = 0;

    uint64_t bytes() const;
};

// What an actor on a track does at a time. Positions in world units.
struct State {
    glm::dvec3 position = glm::dvec3(0);
    double heading_rad = 0;  // about y; 0 looks along +z
    double phase = 0;        // cycles
    float gait = 0;
    bool stands = false;
    uint32_t idle = 0;
};

// Where a track has its actor at a time, and how fast.
struct Motion {
    glm::dvec3 position = glm::dvec3(0);  // world units
    double heading_rad = 0;
    double speed = 0;  // world units a second
    bool present = false;
};

// `time_s` is the track's own; times before its start and after its end give the first and last place.
bool is_present(const Track &track, double time_s) noexcept;
State state_at(const Track &track, double time_s) noexcept;
glm::dvec3 position_at(const Track &track, double time_s) noexcept;
Motion motion_at(const Track &track, double time_s) noexcept;

// Where a foot has to be, in the model space of an actor in `state`.
pose::FootTarget foot_at(const Track &track, const State &state, int foot, double time_s) noexcept;

// Of a foot in the air.
Correction correction_at(const Track &track, const State &state, int foot, double time_s) noexcept;

// From 0 to 1 with no slope at both ends.
inline double eased(double t) { return t <= 0 ? 0 : t >= 1 ? 1 : t * t * (3 - 2 * t); }

inline double end_of(const Track &track) { return track.start_s + track.length_s; }

// Upper bound of the speed in all three dimensions at any time; infinite for a path that jumps.
double top_speed_of(const Track &track);

// Computes first_plants, and the hash of everything above it.
void index_plants(Track &track);
uint64_t hash_of(const Track &track);

}  // namespace claque::track
