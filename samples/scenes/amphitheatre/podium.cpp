// The podium: the wall of the arena with its gates, and the two boxes of honour at the ends of the short axis.
#include "samples/scenes/amphitheatre/surround.h"
#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr Rgb marble = {0.88f, 0.85f, 0.79f}, base = {0.62f, 0.55f, 0.48f}, gate = {0.34f, 0.22f, 0.14f},
              panel_a = {0.93f, 0.74f, 0.48f}, panel_b = {0.72f, 0.42f, 0.33f}, purple = {0.50f, 0.16f, 0.30f},
              gold = {0.92f, 0.74f, 0.34f};
constexpr double parapet_m = 0.75, step_m = 1.6;

void box_of_honour(Masonry &m, const Plan &plan, double turn)
{
    const double half = Plan::box_half_m / plan.oval().radius(turn, 2.0), l = turn - half, h = turn + half;
    const double front = -0.6, back = plan.walkways()[0].from_m;
    // It stands out before the podium.
    m.sweep({{front, 0, 0.6}, {front, box_floor_m, 0.9}}, l, h, step_m, marble);
    m.sweep({{front, box_floor_m + 0.0, 0.9}, {front, box_floor_m + parapet_m * 0.8, 1}}, l, h, step_m, gold);
    m.sweep({{front, box_floor_m + parapet_m * 0.8, 1}, {front + 0.25, box_floor_m + parapet_m * 0.8, 1}}, l, h, step_m,
            marble);
    m.sweep({{front + 0.25, box_floor_m + parapet_m * 0.8, 0.8}, {front + 0.251, box_floor_m, 0.7}}, l, h, step_m,
            marble);
    m.sweep({{front + 0.25, box_floor_m, 0.8}, {box_deep_m, box_floor_m, 0.6}}, l, h, step_m, panel_a * 0.9f);
    m.sweep({{box_deep_m, box_floor_m, 1}, {box_deep_m, box_floor_m + 3.0, 1}}, l, h, step_m, purple * 1.5f);
    m.sweep({{box_deep_m + 0.2, box_floor_m + 3.0, 0.8}, {box_deep_m + 0.201, plan.walkways()[0].level_m, 0.8}}, l, h,
            step_m, marble);
    m.sweep({{box_deep_m, box_floor_m + 3.0, 0.9}, {box_deep_m + 0.2, box_floor_m + 3.0, 0.9}}, l, h, step_m, gold);
    m.sweep({{box_deep_m + 0.2, plan.walkways()[0].level_m, 0.7}, {back + 0.05, plan.walkways()[0].level_m, 0.8}}, l, h,
            step_m, marble * 0.9f);
    for (const double along : {-0.72, -0.24, 0.24, 0.72})
        m.panel(turn + along * half, 1.05, front - 0.02, 0.7, box_floor_m - 0.5,
                along * along > 0.1 ? panel_b : panel_a);
    for (const int side : {-1, 1}) {
        const double edge = side < 0 ? l : h;
        m.cheek(edge, front, box_deep_m + 0.2, 0, box_floor_m + parapet_m * 0.8, box_floor_m + parapet_m * 0.8, side,
                marble);
        m.cheek(edge, front, box_deep_m + 0.2, box_floor_m, box_floor_m + parapet_m * 0.8,
                box_floor_m + parapet_m * 0.8, -side, marble * 0.9f);
    }
    // A canopy on four columns.
    const double roof = box_floor_m + 4.1;
    for (const double along : {-0.92, -0.36, 0.36, 0.92})
        for (const double out : {front + 0.3, box_deep_m - 0.1})
            m.column(turn + along * half, out, box_floor_m, roof, 0.17, 8, marble);
    m.sweep({{front - 0.2, roof, 0.9}, {front - 0.2, roof + 0.35, 1}}, l, h, step_m, gold);
    m.sweep({{front - 0.2, roof + 0.35, 1}, {(front + box_deep_m) / 2, roof + 1.4, 1}}, l, h, step_m, purple * 1.4f);
    m.sweep({{(front + box_deep_m) / 2, roof + 1.4, 1}, {box_deep_m + 0.4, roof + 0.35, 1}}, l, h, step_m,
            purple * 1.4f);
    m.sweep({{box_deep_m + 0.4, roof + 0.35, 0.9}, {box_deep_m + 0.401, roof, 0.8}}, l, h, step_m, gold);
    m.sweep_shaded({{box_deep_m + 0.4, roof, 0.5}, {front - 0.2, roof, 0.5}}, l, h, step_m, purple);
    for (const int side : {-1, 1}) {
        const double edge = side < 0 ? l : h;
        m.cheek(edge, front - 0.2, box_deep_m + 0.4, roof, roof + 0.35, roof + 0.35, side, gold);
        m.cheek(edge, front - 0.2, (front + box_deep_m) / 2, roof + 0.35, roof + 0.36, roof + 1.4, side, purple * 1.4f);
        m.cheek(edge, (front + box_deep_m) / 2, box_deep_m + 0.4, roof + 0.35, roof + 1.4, roof + 0.36, side,
                purple * 1.4f);
    }
}

}  // namespace

void build_podium(Masonry &m, const Plan &plan)
{
    m.sweep({{0, 0, 0.55}, {0, 0.5, 0.8}}, 0, two_pi, step_m, base);
    m.sweep({{0.04, 0.5, 0.85}, {0.04, podium_m - 0.3, 0.9}}, 0, two_pi, step_m, marble);
    m.sweep({{0, 0.5, 0.9}, {0.04, 0.5, 0.9}}, 0, two_pi, step_m, base);
    // The coping, the parapet and the walk behind it.
    m.sweep({{0.04, podium_m - 0.3, 0.7},
             {-0.12, podium_m - 0.2, 0.9},
             {-0.12, podium_m, 1},
             {0, podium_m, 0.9},
             {0, podium_m + parapet_m, 1},
             {0.2, podium_m + parapet_m, 1},
             {0.201, podium_m, 0.7},
             {plan.tiers()[0].out_m + 0.06, podium_m, 0.7}},
            0, two_pi, step_m, marble);
    for (int k = 0; k < bay_count; ++k) {
        const bool at_gate = k % 40 == 0 || k % 40 == 39;
        if (!at_gate) m.panel(plan.turn_of(k + 0.5), 1.35, 0.02, 0.85, podium_m - 0.6, k % 2 == 0 ? panel_a : panel_b);
        if (k % 10 == 5) m.recess(plan.turn_of(k), 0.65, 0.015, 0, 1.9, gate);
    }
    // The gates of triumph and of the dead, at the ends of the long axis.
    for (const double turn : {0.0, two_pi / 2}) {
        m.block(turn, 3.1, -0.35, 0.1, 0, podium_m + 0.2, marble * 0.96f);
        m.recess(turn, 2.3, -0.38, 0, podium_m - 0.5, gate);
        for (int bar = -4; bar <= 4; ++bar)
            m.block(turn + bar * 0.5 / plan.oval().radius(turn, 0), 0.05, -0.44, -0.4, 0, podium_m - 0.5, gate * 1.8f);
    }
    box_of_honour(m, plan, two_pi / 4);
    box_of_honour(m, plan, 3 * two_pi / 4);
}

}  // namespace scenes::amphitheatre
