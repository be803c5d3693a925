// Pieces of tracks: a track that is made bit by bit, while it is decided where the person goes. A piece is immutable
// from the moment that it is made, as every track is. It depends on the points and on the piece before alone, whose end
// is its border: place, heading, phase, gait, idle clip and the feet on the ground go on there.
//
// A piece is built on a window: the points from `sight_s` before its border to `sight_s` after its end. Near the border
// the steps of build.h see nearly what they saw for the piece before. The little by which they now differ is added, and
// fades within a second: not while the person stands, because a foot on the ground would slide.
#pragma once

#include "lib/track/build.h"

namespace claque::track
{

constexpr double sight_s = 2;
constexpr double min_piece_s = 0.1;

// The fine grid of a piece has samples at both its ends. Throws base::Error (ARGUMENT).
void make_piece_grid(base::Span<const Point> points, const BuildSettings &settings, FinePath &path);
// The points of the window.
base::Span<const Point> in_sight(base::Span<const Point> points, const FinePath &path);
// Throws base::Error (ARGUMENT: a piece before of another person).
void check_piece(const Locomotion &locomotion, base::Span<const Point> points, const BuildSettings &settings);

// After the steps of their names.
void join_path(FinePath &path);
void join_heading(double max_turn_rad_s, FinePath &path);
void join_gait(double max_gait, FinePath &path);
void join_idle(FinePath &path);

// What is left of an offset with a slope (for the whole fade) when a part of the fade is over; no slope at its end.
double left_of(double offset, double slope, double part);

// The plants of the piece before that hold across the border or just behind it, and the swing that the border cuts.
struct CarriedFoot {
    bool planted = false;      // at the border
    bool has_before = false;   // a plant that ended before the border
    bool lands_soon = false;   // a plant that begins so soon that it stays as planned
    Plant held, before, next;  // times from the border
};
CarriedFoot carried_foot(const Track &previous, int foot);

// After plants and samples: the rest of each swing that crosses the border starts where the piece before had the foot.
void join_swings(const Track &previous, Track &out);
// After everything else: gaze and shoulders go on from where the piece before had them.
void join_upper(const Track &previous, Track &out);

}  // namespace claque::track
