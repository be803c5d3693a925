// Tracks made in pieces, as a host that decides while it shows makes them.
#pragma once

#include "tests/unit/track/feet.h"
#include "tests/unit/track/made_tracks.h"

namespace claque::test
{

struct PieceRule {
    double length_s = 0.5;
    double ahead_s = 1.0;    // of points behind the end of a piece
    double overlap_s = 1.5;  // of points before its begin
};

class Pieces
{
public:
    // Points that a piece sees; `seen` may change them before they are used.
    using See = std::function<void(std::vector<track::Point> &, double end_s)>;
    explicit Pieces(const std::vector<track::Point> &points, const std::string &figure = "citizen",
                    const PieceRule &rule = {}, const See &see = nullptr, const track::BuildSettings &common = {});

    const track::Track &at(double time_s) const;
    double start_s() const { return all.front()->start_s; }
    double end_s() const { return track::end_of(*all.back()); }

    std::vector<std::unique_ptr<track::Track>> all;
};

// The plants of all pieces, each once, with its times on the tracks' own clock.
struct LongPlant {
    int foot;
    double begin_s, end_s, x, z;
};
std::vector<LongPlant> plants_of(const Pieces &pieces);

// As drift_of (feet.h), over the borders.
FootDrift drift_of_pieces(Soles &soles, const Pieces &pieces, double step_s);

}  // namespace claque::test
