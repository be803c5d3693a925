#include "lib/pose/upper.h"

#include <cmath>

#include "lib/math/trig.h"

namespace claque::pose
{

namespace
{

using math::Columns;
using math::F4;
using math::splat;

// Turns nodes about the vertical through the first of them.
void turn_nodes(const model::Array<uint32_t> &nodes, float angle_rad, Columns *globals)
{
    const F4 pivot = globals[nodes[0]].c[3];
    const float c = math::cos(angle_rad), s = math::sin(angle_rad);
    const auto turned = [&](const F4 &v) { return F4{v[0] * c + v[2] * s, v[1], v[2] * c - v[0] * s, v[3]}; };
    for (const uint32_t node : nodes) {
        Columns &columns = globals[node];
        for (int k = 0; k < 3; ++k) columns.c[k] = turned(columns.c[k]);
        columns.c[3] = turned(columns.c[3] - pivot) + pivot;
    }
}

// No farther than its share of the room: a turn about a pivot moves what the sphere holds by less than the arc of the
// sphere's centre about that pivot.
float limited(const Upper &upper, const Columns &pivot, float angle_rad, float share)
{
    const float x = pivot.c[3][0] - upper.centre_x, z = pivot.c[3][2] - upper.centre_z;
    const float arc = std::fabs(angle_rad) * std::sqrt(x * x + z * z), room = share * upper.room;
    return arc > room ? angle_rad * (room / arc) : angle_rad;
}

}  // namespace

void turn_upper(const UpperTarget &target, const uint8_t *active, Columns *globals) noexcept
{
    const Upper &upper = *target.upper;
    const auto turns = [active](uint32_t node) { return node != model::none && (!active || active[node]); };
    const auto turn = [&](const model::Array<uint32_t> &nodes, float angle_rad, float share) {
        if (angle_rad == 0 || !turns(nodes.empty() ? model::none : nodes[0])) return 0.0f;
        const float allowed = limited(upper, globals[nodes[0]], angle_rad, share);
        turn_nodes(nodes, allowed, globals);
        return allowed;
    };
    // The head keeps its direction while the torso turns.
    const float rest = target.gaze_rad - turn(upper.torso_nodes, target.torso_rad, 0.5f);
    const bool has_both = turns(upper.neck) && turns(upper.head);
    turn(upper.neck_nodes, has_both ? neck_share * rest : rest, 0.2f);
    turn(upper.head_nodes, has_both ? (1 - neck_share) * rest : turns(upper.neck) ? 0 : rest, 0.3f);
}

}  // namespace claque::pose
