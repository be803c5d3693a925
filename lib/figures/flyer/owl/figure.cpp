// The owl's nodes, pieces with their distances, charts, zones and flight style.
#include "lib/figures/figure.h"

#include "lib/figures/flyer/owl/owl.h"

namespace claque::figures
{

namespace
{

using namespace flyer;
using namespace flyer::owl;

const Joints joints = {{{Node::body, {0, 0, 0}},
                        {Node::body, {0, 0.000f, -0.010f}},
                        {Node::spine, {0, 0.270f, 0.000f}},
                        {Node::neck, {0, 0.340f, 0.000f}},
                        {Node::head, eye_left},
                        {Node::head, {-eye_left.x, eye_left.y, eye_left.z}},
                        {Node::head, {0, eye_left.y, eye_left.z}},
                        {Node::head, jaw_joint},
                        {Node::head, {0, 0.570f, 0.120f}},
                        {Node::spine, {0.160f, 0.200f, -0.110f}},
                        {Node::spine, {-0.160f, 0.200f, -0.110f}},
                        {Node::body, {0.112f, -0.340f, 0.030f}},
                        {Node::body, {-0.112f, -0.340f, 0.030f}},
                        {Node::body, {0, -0.420f, -0.090f}}}};

std::vector<Piece> pieces()
{
    return {
        {"belly", Node::body, 0, {20, 55, limbs_deactivation_m}, add_belly},
        {"chest", Node::spine, 0, {20, 55, limbs_deactivation_m}, add_chest},
        {"ruff", Node::neck, 0, {25, limbs_deactivation_m}, add_ruff},
        {"head", Node::head, 0, {14, face_deactivation_m}, add_head},
        {"head_far", Node::head, face_deactivation_m, {75, limbs_deactivation_m}, add_far_head},
        {"eye_left", Node::eye_left, 0, {14, face_deactivation_m}, add_eye_left},
        {"eye_right", Node::eye_right, 0, {14, face_deactivation_m}, add_eye_right},
        {"lids", Node::lids, 0, {14, face_deactivation_m}, add_lids},
        {"jaw", Node::jaw, 0, {14, face_deactivation_m}, add_beak},
        {"brow", Node::brow, 0, {14, face_deactivation_m}, add_tufts},
        {"wing_left", Node::wing_left, 0, {25, 60, limbs_deactivation_m, wings_deactivation_m}, add_wing_left},
        {"wing_right", Node::wing_right, 0, {25, 60, limbs_deactivation_m, wings_deactivation_m}, add_wing_right},
        {"foot_left", Node::arm_left, 0, {18, 55, limbs_deactivation_m}, add_foot_left},
        {"foot_right", Node::arm_right, 0, {18, 55, limbs_deactivation_m}, add_foot_right},
        {"tail", Node::legs, 0, {18, 55, limbs_deactivation_m}, add_tail},
        {"bust", Node::spine, limbs_deactivation_m, {wings_deactivation_m}, add_bust},
        {"lower_half", Node::body, limbs_deactivation_m, {wings_deactivation_m}, add_lower_half},
        {"whole", Node::body, wings_deactivation_m, {for_ever}, add_whole},
    };
}

const Layout &layout()
{
    static const Layout made = {
        {head_chart, {0, 0, 240, 160}},
        {far_head_chart, {240, 0, 72, 56}},
        {eye_chart, {312, 0, 56, 56}},
        {lid_chart, {368, 0, 48, 32}},
        {beak_chart, {368, 32, 48, 24}},
        {tuft_chart, {416, 0, 32, 56}},
        {ruff_chart, {240, 56, 176, 40}},
        {collar_chart, {240, 96, 176, 16}},
        {letter_chart, {416, 56, 32, 56}},
        {foot_chart, {240, 112, 112, 48}},
        {talon_chart, {352, 112, 56, 48}},
        {far_body_chart, {408, 112, 40, 48}},
        {tail_chart, {448, 0, 64, 160}},
        {chest_chart, {0, 160, 256, 160}},
        {belly_chart, {0, 320, 256, 192}},
        {wing_back_chart, {256, 160, 128, 352}},
        {wing_front_chart, {384, 160, 128, 352}},
    };
    return made;
}

Zones zones()
{
    return {
        {Zone::skin, {0.86f, 0.66f, 0.30f}, {30, 46, 0.45f, 0.75f, 0.60f, 0.92f}},
        {Zone::hair, {0.93f, 0.88f, 0.78f}, {24, 44, 0.06f, 0.24f, 0.84f, 1.00f}},
        {Zone::eyes, {0.98f, 0.66f, 0.16f}, {20, 56, 0.60f, 0.90f, 0.90f, 1.00f}},
        {Zone::tunic, {0.92f, 0.80f, 0.62f}, {22, 42, 0.12f, 0.42f, 0.74f, 0.98f}},
        {Zone::outer, {0.56f, 0.40f, 0.26f}, {18, 34, 0.25f, 0.60f, 0.34f, 0.74f}},
        {Zone::wings, {0.72f, 0.56f, 0.38f}, {20, 38, 0.20f, 0.52f, 0.50f, 0.90f}},
        {Zone::border, {0.72f, 0.16f, 0.16f}, {0, 360, 0.55f, 0.85f, 0.45f, 0.85f}},
        {Zone::jewellery, {0.90f, 0.70f, 0.26f}, {38, 48, 0.55f, 0.75f, 0.80f, 0.98f}},
    };
}

}  // namespace

model::Model letter_owl()
{
    Flyer made;
    made.name = "owl";
    made.joints = joints;
    made.pieces = pieces();
    made.painter = owl::paint;
    made.layout = layout();
    made.zones = zones();
    made.flight_style = {0.98f, 3, 4, 0.52f, 0.16f, 0.62f, 0.10f};
    return assemble(made);
}

}  // namespace claque::figures
