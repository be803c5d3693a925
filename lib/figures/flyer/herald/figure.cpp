// The herald's nodes, pieces with their distances, charts, zones and flight style.
#include "lib/figures/figure.h"

#include "lib/figures/flyer/herald/herald.h"

namespace claque::figures
{

namespace
{

using namespace flyer;
using namespace flyer::herald;

const Joints joints = {{{Node::body, {0, 0, 0}},
                        {Node::body, {0, 0.050f, -0.005f}},
                        {Node::spine, {0, 0.460f, -0.020f}},
                        {Node::neck, {0, 0.555f, -0.005f}},
                        {Node::head, eye_left},
                        {Node::head, {-eye_left.x, eye_left.y, eye_left.z}},
                        {Node::head, {0, eye_left.y, eye_left.z}},
                        {Node::head, jaw_joint},
                        {Node::head, {0, 0.730f, 0.090f}},
                        {Node::spine, {0.055f, 0.370f, -0.095f}},
                        {Node::spine, {-0.055f, 0.370f, -0.095f}},
                        {Node::spine, {0.166f, 0.395f, -0.012f}},
                        {Node::spine, {-0.166f, 0.395f, -0.012f}},
                        {Node::body, {0, -0.100f, 0}}}};

// Each piece has distances of its own (S0 5.1).
std::vector<Piece> pieces()
{
    return {
        {"hips", Node::body, 0, {16, 45, limbs_deactivation_m}, add_skirt},
        {"chest", Node::spine, 0, {20, 50, limbs_deactivation_m}, add_chest},
        {"neck", Node::neck, 0, {20, limbs_deactivation_m}, add_neck},
        {"head", Node::head, 0, {12, face_deactivation_m}, add_head},
        {"head_far", Node::head, face_deactivation_m, {70, limbs_deactivation_m}, add_far_head},
        {"eye_left", Node::eye_left, 0, {12, face_deactivation_m}, add_eye_left},
        {"eye_right", Node::eye_right, 0, {12, face_deactivation_m}, add_eye_right},
        {"lids", Node::lids, 0, {12, face_deactivation_m}, add_lids},
        {"jaw", Node::jaw, 0, {12, face_deactivation_m}, add_jaw},
        {"brow", Node::brow, 0, {12, face_deactivation_m}, add_brow},
        {"wing_left", Node::wing_left, 0, {25, 60, limbs_deactivation_m, wings_deactivation_m}, add_wing_left},
        {"wing_right", Node::wing_right, 0, {25, 60, limbs_deactivation_m, wings_deactivation_m}, add_wing_right},
        {"arm_left", Node::arm_left, 0, {16, 45, limbs_deactivation_m}, add_arm_left},
        {"arm_right", Node::arm_right, 0, {16, 45, limbs_deactivation_m}, add_arm_right},
        {"legs", Node::legs, 0, {16, 45, limbs_deactivation_m}, add_legs},
        {"bust", Node::spine, limbs_deactivation_m, {wings_deactivation_m}, add_bust},
        {"lower_half", Node::body, limbs_deactivation_m, {wings_deactivation_m}, add_lower_half},
        {"whole", Node::body, wings_deactivation_m, {for_ever}, add_whole},
    };
}

const Layout &layout()
{
    static const Layout made = {
        {head_chart, {0, 0, 272, 208}},          {far_head_chart, {272, 0, 72, 56}},
        {eye_chart, {344, 0, 48, 56}},           {lid_chart, {392, 0, 40, 24}},
        {jaw_chart, {272, 56, 104, 48}},         {mouth_chart, {392, 24, 40, 16}},
        {brow_chart, {392, 40, 40, 16}},         {neck_chart, {376, 56, 56, 32}},
        {wreath_chart, {376, 88, 56, 16}},       {collar_chart, {272, 104, 136, 24}},
        {far_limb_chart, {408, 104, 24, 48}},    {talaria_chart, {408, 152, 24, 24}},
        {lining_chart, {272, 176, 128, 32}},     {scroll_chart, {400, 176, 32, 32}},
        {trumpet_chart, {432, 0, 32, 208}},      {sleeve_chart, {272, 128, 136, 48}},
        {chest_chart, {0, 208, 208, 176}},       {skirt_chart, {0, 384, 208, 128}},
        {wing_back_chart, {208, 208, 112, 304}}, {wing_front_chart, {320, 208, 112, 304}},
        {leg_chart, {432, 208, 80, 304}},        {arm_chart, {464, 0, 48, 208}},
    };
    return made;
}

Zones zones()
{
    return {
        {Zone::skin, {0.90f, 0.68f, 0.55f}, {14, 28, 0.30f, 0.55f, 0.55f, 0.96f}},
        {Zone::hair, {0.52f, 0.31f, 0.14f}, {14, 44, 0.30f, 0.72f, 0.20f, 0.80f}},
        {Zone::eyes, {0.94f, 0.93f, 0.90f}, {30, 210, 0.02f, 0.10f, 0.90f, 1.00f}},
        {Zone::lips, {0.78f, 0.42f, 0.38f}, {2, 14, 0.40f, 0.55f, 0.60f, 0.80f}},
        {Zone::tunic, {0.94f, 0.90f, 0.80f}, {0, 360, 0.05f, 0.55f, 0.62f, 1.00f}},
        {Zone::belt, {0.38f, 0.50f, 0.24f}, {70, 130, 0.40f, 0.65f, 0.35f, 0.60f}},
        {Zone::border, {0.70f, 0.20f, 0.18f}, {0, 360, 0.45f, 0.80f, 0.40f, 0.85f}},
        {Zone::sandals, {0.52f, 0.33f, 0.19f}, {14, 36, 0.40f, 0.70f, 0.30f, 0.62f}},
        {Zone::wings, {0.97f, 0.95f, 0.92f}, {20, 230, 0.02f, 0.22f, 0.78f, 1.00f}},
        {Zone::jewellery, {0.90f, 0.70f, 0.26f}, {38, 48, 0.55f, 0.75f, 0.80f, 0.98f}},
    };
}

}  // namespace

model::Model winged_herald()
{
    Flyer made;
    made.name = "herald";
    made.joints = joints;
    made.pieces = pieces();
    made.painter = herald::paint;
    made.layout = layout();
    made.zones = zones();
    made.flight_style = {1.02f, 4, 5, 0.62f, 0.22f, 0.78f, 0.16f};
    return assemble(made);
}

}  // namespace claque::figures
