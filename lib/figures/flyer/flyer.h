// Flying characters in rigid parts, like the actors of S0 7.1: 13 Skeleton nodes with 19 degrees of freedom below a
// body, five levels of detail whose pieces change at distances of their own (S0 5.1), nodes that stop on the way
// (S0 5.2). What one of them looks like is a list of pieces; nodes, freedoms and clips are shared.
//
// Space: metres, Y up, looking along +Z, its left +X; the origin is the body's middle. At rest it stands upright with
// its wings spread; clips lay it forward.
#pragma once

#include <array>
#include <vector>

#include "lib/figures/canvas.h"

namespace claque::figures::flyer
{

enum class Node : uint8_t {
    body,  // hips and skirt, or tail; moved by clips alone
    spine,
    neck,
    head,
    eye_left,
    eye_right,
    lids,
    jaw,
    brow,
    wing_left,
    wing_right,
    arm_left,
    arm_right,
    legs
};
constexpr int node_count = 14;

// Where the nodes turn, in the rest pose, and where they stop.
struct Joint {
    Node parent;
    glm::vec3 at;
};
using Joints = std::array<Joint, node_count>;

// Distances from the eye, in metres. An error of half a pixel at 768 lines and 60 degrees is 0.75 mm a metre.
constexpr float face_deactivation_m = 35;    // eyes, lids, jaw, brow
constexpr float limbs_deactivation_m = 160;  // neck, head, arms, legs
constexpr float wings_deactivation_m = 400;  // and the spine, which carries them
constexpr float for_ever = std::numeric_limits<float>::infinity();

// A geometry on one node in several levels: level k is drawn from where k - 1 ends to ends_m[k].
struct Piece {
    const char *name;
    Node node;
    float first_m;
    std::vector<float> ends_m;
    void (*shape)(Mesh &, int level);
};

// How the clips of one figure beat, see clips.cpp.
struct FlightStyle {
    float lean_rad;     // of the body in `fly`
    int beats;          // of the wings in the two seconds of `fly`
    int hover_beats;    // and of `hover`
    float beat_rad;     // half of what the wings sweep over
    float raised_rad;   // where a beat has its middle
    float look_up_rad;  // how neck and spine together make good for the lean
    float trail_rad;    // the legs in `fly`
};

struct Flyer {
    const char *name = "";
    Joints joints;
    std::vector<Piece> pieces;
    Painter painter;
    Layout layout;
    Zones zones;
    FlightStyle flight_style;
};

void add_nodes(model::Rig &rig, const Joints &joints);  // with freedoms, ranges, stops; one matrix each
void add_clips(model::Rig &rig, const Joints &joints, const FlightStyle &flight_style);

// Throws base::Error should the figure break a rule of model::check.
model::Model assemble(const Flyer &flyer);

}  // namespace claque::figures::flyer
