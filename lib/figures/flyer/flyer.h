// Flying characters of rigid parts, like the actors of S0 7.1: 13 Skeleton nodes with 19 degrees of freedom below a
// body, five levels of detail whose pieces switch at distances of their own (S0 5.1), and nodes with deactivation
// distances (S0 5.2). A flyer is a list of pieces; nodes, degrees of freedom and clips are shared.
//
// Space: metres, Y up, facing +Z, left +X; the origin is the middle of the body. At rest the flyer is upright with its
// wings spread; clips lean it forward.
#pragma once

#include <array>
#include <vector>

#include "lib/figures/canvas.h"

namespace claque::figures::flyer
{

enum class Node : uint8_t {
    body,  // hips and skirt, or tail; moved by clips only
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

// The joints of the nodes in the rest pose, and their deactivation distances.
struct Joint {
    Node parent;
    glm::vec3 at;
};
using Joints = std::array<Joint, node_count>;

// Distances from the eye in metres. An error of half a pixel at 768 lines and 60 degrees is 0.75 mm per metre.
constexpr float face_deactivation_m = 35;    // eyes, lids, jaw, brow
constexpr float limbs_deactivation_m = 160;  // neck, head, arms, legs
constexpr float wings_deactivation_m = 400;  // and the spine, their parent
constexpr float for_ever = std::numeric_limits<float>::infinity();

// A geometry on one node in several levels: level k is drawn from the end of level k - 1 up to ends_m[k].
struct Piece {
    const char *name;
    Node node;
    float first_m;
    std::vector<float> ends_m;
    void (*shape)(Mesh &, int level);
};

// The parameters of one flyer's clips, see clips.cpp.
struct FlightStyle {
    float lean_rad;     // of the body in `fly`
    int beats;          // of the wings in the two seconds of `fly`
    int hover_beats;    // the same for `hover`
    float beat_rad;     // half the sweep of the wings
    float raised_rad;   // centre of a beat
    float look_up_rad;  // how far neck and spine together compensate for the lean
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

// With degrees of freedom, ranges and deactivation distances; one matrix each.
void add_nodes(model::Rig &rig, const Joints &joints);
void add_clips(model::Rig &rig, const Joints &joints, const FlightStyle &flight_style);

// Throws base::Error if the figure breaks a rule of model::check.
model::Model assemble(const Flyer &flyer);

}  // namespace claque::figures::flyer
