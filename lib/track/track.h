// A track: the path of one actor as a function of time, with its heading, the phase and gait of its clips, and the
// places where its feet stand. Immutable; any time is evaluated by itself, in constant time.
#pragma once

#include <cmath>
#include <cstddef>

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
    uint8_t flags = 0;     // stands; the idle clip; the share of the clip that turns on the spot
};
static_assert(sizeof(Sample) == 16, "a sample has 16 bytes");

constexpr double place_step_m = 1.0 / 8192;
constexpr double sink_step_m = 1.0 / 65536;
constexpr double gait_unit = 127;
constexpr double max_foot_turn_rad = 0.7;  // of a foot against its body
constexpr double landing_s = 0.08;         // in which the ground takes hold of a foot and lets it go
// The height over the ground that a sole keeps in the air, and how much more it rises to, in so many seconds.
constexpr double clear_m = 0.012, mid_swing_m = 0.012, rise_s = 0.15;
constexpr double max_slope = 0.3;  // to which feet tilt
constexpr float max_shoulder_turn_rad = 0.6f;
constexpr uint8_t stands_flag = 1;
constexpr uint32_t idle_shift = 1, idle_mask = 3, turn_shift = 3;
constexpr double turn_unit = 31;  // of the share
inline uint32_t idle_of(uint8_t flags) { return flags >> idle_shift & idle_mask; }
inline uint32_t turn_of(uint8_t flags) { return flags >> turn_shift; }

// A foot on the ground from begin_s to end_s, seconds from the start of the track. Metres from the track's origin.
struct Plant {
    float begin_s = 0, end_s = 0;
    float x = 0, z = 0;     // of the ball of the foot
    float heading_rad = 0;  // to which the foot points
    // How far the clips' own foot is from there, when the foot comes down and when it is lifted.
    float begin_x = 0, begin_z = 0, end_x = 0, end_z = 0;
    float y = NAN;    // of the ground; NaN: unknown, the foot stands at the height of the body's own place
    float slope = 0;  // of the ground, in the direction of the foot
};
constexpr size_t level_plant_bytes = offsetof(Plant, y);  // without the height

// The way from where the clips have a foot to where it is shown, in the air.
struct Correction {
    double x = 0, z = 0, turn_rad = 0;
    double y = 0, slope = 0;
};

// Of a piece whose border cuts the swing of a foot: what the piece before showed besides, fading until it lands.
struct Swing {
    float x = 0, z = 0, turn_rad = 0;
    float until_s = 0;
    float y = 0;
};
constexpr size_t level_swing_bytes = offsetof(Swing, y);

// The torso turns while another person passes closely: from at_s - half_s to at_s + half_s.
struct ShoulderTurn {
    float at_s = 0, half_s = 0;
    float turn_rad = 0;  // at at_s, positive to the left
};

struct Box {
    glm::dvec3 low = glm::dvec3(-HUGE_VAL), high = glm::dvec3(HUGE_VAL);
};

struct Track {
    explicit Track(std::pmr::memory_resource *memory)
        : samples(memory),
          plants{Array<Plant>(memory), Array<Plant>(memory)},
          first_plants{Array<uint32_t>(memory), Array<uint32_t>(memory)},
          shoulders(memory),
          first_shoulders(memory),
          sinks(memory),
          ahead(memory)
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
    Box reach;                        // holds all positions, world units
    Array<Sample> samples;            // [length_s * rate_hz + 1]
    Array<Plant> plants[2];           // by begin_s; they do not overlap
    Array<uint32_t> first_plants[2];  // by whole second: the first plant that ends after it began
    // Of a piece (piece.h). Plants that began before it have negative times, and one may lie behind its end.
    uint64_t previous_hash = 0;  // 0: it continues none
    Swing swings[2];
    bool climbs = false;              // feet stand at heights of their own; from plants and swings
    uint32_t stand_count = 0;         // times that the person stood, with the pieces before
    Array<ShoulderTurn> shoulders;    // by at_s; they do not overlap
    Array<uint32_t> first_shoulders;  // likewise; empty if there are none
    Array<uint16_t> sinks;            // of the hips, by sample, in steps of sink_step_m; empty: they never sink
    // Of a piece: headings behind its end, on the grid of its samples, and what the piece before showed besides,
    // fading.
    Array<uint16_t> ahead;
    struct {
        float gaze_rad = 0, torso_rad = 0;
    } upper_swing;

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
    float turn = 0;  // [0, 1] share of the clip that turns on the spot
    bool stands = false;
    uint32_t idle = 0;
};

// Where a track has its actor at a time, and how fast.
struct Motion {
    glm::dvec3 position = glm::dvec3(0);  // world units
    double heading_rad = 0;
    double speed = 0;       // world units a second
    double limb_speed = 0;  // of feet and arms: they move too while a body turns that gets nowhere
    bool present = false;
};

// `time_s` is the track's own; times before its start and after its end give the first and last place.
bool is_present(const Track &track, double time_s) noexcept;
State state_at(const Track &track, double time_s) noexcept;
glm::dvec3 position_at(const Track &track, double time_s) noexcept;
Motion motion_at(const Track &track, double time_s) noexcept;

// Where a foot has to be, in the model space of an actor in `state`.
pose::FootTarget foot_at(const Track &track, const State &state, int foot, double time_s) noexcept;

// How far the hips sink, metres.
double sink_at(const Track &track, double time_s) noexcept;

// Of a foot in the air.
Correction correction_at(const Track &track, const State &state, int foot, double time_s) noexcept;
// Where an actor in `state` looks, and how it holds its shoulders: the gaze goes where the heading will be half a
// second later.
pose::UpperTarget upper_at(const Track &track, const State &state, double time_s) noexcept;

// Calls each(seconds since the start, foot) where a foot comes down, and each(seconds, idle clip) where a person begins
// to stand, after from_s and up to to_s, give or take rounding. What holds at the start is not reported.
template <class Each>
void for_steps(const Track &track, double from_s, double to_s, const Each &each)
{
    for (int f = 0; f < 2; ++f) {
        const Array<uint32_t> &index = track.first_plants[f];
        const double second = from_s > 0 ? std::floor(from_s) : 0;
        if (!(second < double(index.size()))) continue;
        for (uint32_t i = index[static_cast<size_t>(second)]; i < track.plants[f].size(); ++i) {
            const double begin_s = double(track.plants[f][i].begin_s);
            if (begin_s > to_s || begin_s > track.length_s) break;
            if (begin_s > 0 && begin_s >= from_s) each(begin_s, f);
        }
    }
}

template <class Each>
void for_stands(const Track &track, double from_s, double to_s, const Each &each)
{
    const double last = double(track.samples.size()) - 1;
    const double first = from_s > 0 ? std::floor(from_s * track.rate_hz) : 0;
    for (double i = first < 1 ? 1 : first; i <= last && i / track.rate_hz <= to_s; ++i) {
        const Sample &before = track.samples[static_cast<size_t>(i) - 1], &now = track.samples[static_cast<size_t>(i)];
        if (!(before.flags & stands_flag) && now.flags & stands_flag) each(i / track.rate_hz, idle_of(now.flags));
    }
}

// From 0 to 1 with no slope at both ends.
inline double eased(double t) { return t <= 0 ? 0 : t >= 1 ? 1 : t * t * (3 - 2 * t); }

inline double end_of(const Track &track) { return track.start_s + track.length_s; }

// Upper bound of the speed in all three dimensions at any time; infinite for a path that jumps.
double top_speed_of(const Track &track);
Box reach_of(const Track &track);

// Computes first_plants and first_shoulders, whether the track climbs, and the hash of everything above it.
void index_plants(Track &track);
uint64_t hash_of(const Track &track);

}  // namespace claque::track
