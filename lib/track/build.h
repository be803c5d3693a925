// Makes a track of the points that a file or a host gives. Everything is computed here, once, so that any time of the
// track can be shown by itself. The steps, in their order:
//   path      resampled to a fine grid, smoothed over about one stride; ends stay where they are
//   stands    the times in which a person stands: position and heading freeze
//   heading   from the file, or along the path; held where a person is slow; limited in its rate
//   gait      the share of each clip by speed, the phase by the distance travelled
//   plants    when each foot stands and where
//   shoulders how the torso turns when others pass
//   pack      the coarsest grid that keeps the path
// A piece of a track goes through the same steps, on the points from a little before it to a little after it, and is
// joined to the piece before (piece.h).
#pragma once

#include <limits>

#include "lib/track/track.h"

namespace claque::track
{

// What was given, in world units.
struct Point {
    double time_s = 0;
    glm::dvec3 position = glm::dvec3(0);
    double heading_rad = 0;  // NaN: unknown
};

// Another person that comes close.
struct Passing {
    double time_s = 0;
    glm::dvec3 position = glm::dvec3(0);  // of the other, world units
};

struct BuildSettings {
    double smooth_s = 1.1;  // about one stride; 0: the path stays as it is
    double metres_per_unit = 1;
    double scale = 1;             // world units per model unit, of the actors that will follow the track
    uint64_t seed = 0;            // chooses clips to stand with, and the foot that starts
    double max_turn_rad_s = 3.1;  // a little less than half a turn a second
    // Of pieces: the piece before, or null, and the time up to which the track is made if the points go on behind it.
    const Track *previous = nullptr;
    double end_s = std::numeric_limits<double>::infinity();
    base::Span<const Passing> passings = {};  // times ascend
    // Of the host, in world units, as clq_height_function; null: the ground is not known.
    double (*ground)(void *user, const double point[3]) = nullptr;
    void *ground_user = nullptr;
};

// Throws base::Error (ARGUMENT: no points, times that do not ascend, numbers that are not finite; LIMIT) or
// std::bad_alloc.
void build(const Locomotion &locomotion, base::Span<const Point> points, const BuildSettings &settings, Track &out);

// The fine grid on which the steps work: about this many samples a second, so that the last one is at the end of the
// track, whichever grid is packed.
constexpr double fine_hz = 50;
constexpr uint32_t fine_multiple = 20;  // of the number of steps
constexpr uint32_t min_stand = 30;      // samples: a stand lasts 0.6 s or longer

struct FinePath {
    explicit FinePath(std::pmr::memory_resource *memory)
        : x(memory),
          y(memory),
          z(memory),
          heading(memory),
          speed(memory),
          turn(memory),
          gait(memory),
          phase(memory),
          turning(memory),
          stands(memory),
          idle(memory),
          pieces(memory)
    {
    }
    double start_s = 0;
    double hz = fine_hz;        // of this path
    Array<double> x, y, z;      // metres from the origin
    Array<double> heading;      // radians, without jumps by whole turns
    Array<double> speed, turn;  // metres and radians a second
    Array<double> gait, phase;  // phase in cycles, rising
    Array<double> turning;      // [0, 1] share of the clip that turns on the spot
    Array<uint8_t> stands;
    Array<uint8_t> idle;  // which clip it stands with
    // Where a person moves between two stands: the first and the last sample, both of them of stands or of the ends.
    struct Piece {
        uint32_t first = 0, last = 0;
    };
    Array<Piece> pieces;
    // The samples that the track gets; the others were seen only. A whole track gets all.
    uint32_t first = 0, last = 0;
    const Track *previous = nullptr;  // ends at `first`

    uint32_t count() const { return static_cast<uint32_t>(x.size()); }
};

void make_grid(base::Span<const Point> points, FinePath &path);
void make_path(base::Span<const Point> points, const BuildSettings &settings, const glm::dvec3 &origin_m,
               FinePath &path);  // on the grid
void find_stands(const BuildSettings &settings, FinePath &path);
void make_heading(base::Span<const Point> points, const BuildSettings &settings, FinePath &path);
// Returns how often the person began to stand up to the end of the track, with the pieces before.
uint32_t make_gait(const Locomotion &locomotion, const BuildSettings &settings, FinePath &path);
void make_plants(const Locomotion &locomotion, const BuildSettings &settings, const FinePath &path, Track &out);
// What a leg wants the hips to sink by: `below_m` is how far its foot stands below the body's place, `flat_m` how far
// from the hip over the ground, `reach_m` how far the straight leg reaches there.
double sink_wanted(double leg_m, double reach_m, double flat_m, double below_m);
constexpr double max_sink = 0.17;  // of a leg's length
// After the plants and the samples.
void make_sinks(const Locomotion &locomotion, const FinePath &path, Track &out);
void make_shoulders(const BuildSettings &settings, const FinePath &path, Track &out);
void make_ahead(const FinePath &path, Track &out);  // where people look at the end of a piece
void pack(const FinePath &path, Track &out);

// What lies beyond the ends for smooth(): the values mirrored through the end point, so that ends keep their values, or
// the value of the end.
enum class Beyond { mirrored, still };

// The mean of the values within `half` of each, over the samples from first to last.
void smooth(Array<double> &values, uint32_t first, uint32_t last, uint32_t half, Beyond beyond);

// Of the path as it is, over the samples beside each.
void measure_speed(FinePath &path);
void measure_turn(FinePath &path);  // what turns does not stand
// The angle nearest to `to` among those that differ from `angle` by whole turns.
double nearest_turn(double angle, double to);

}  // namespace claque::track
