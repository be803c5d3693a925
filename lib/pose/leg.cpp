#include "lib/pose/leg.h"

#include <cmath>

#include "lib/math/trig.h"

namespace claque::pose
{

using math::Columns;
using math::F4;
using math::splat;

namespace
{

float dot(const glm::vec3 &a, const glm::vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::vec3 cross(const glm::vec3 &a, const glm::vec3 &b)
{
    return glm::vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

float length(const glm::vec3 &v) { return std::sqrt(dot(v, v)); }

// A rotation by its three columns.
struct Turn {
    glm::vec3 x = glm::vec3(1, 0, 0), y = glm::vec3(0, 1, 0), z = glm::vec3(0, 0, 1);

    glm::vec3 operator*(const glm::vec3 &v) const { return x * v.x + y * v.y + z * v.z; }
    Turn operator*(const Turn &other) const { return {*this * other.x, *this * other.y, *this * other.z}; }
};

Turn turn_of(float w, const glm::vec3 &v)
{
    Turn out;
    out.x = glm::vec3(1 - 2 * (v.y * v.y + v.z * v.z), 2 * (v.x * v.y + w * v.z), 2 * (v.x * v.z - w * v.y));
    out.y = glm::vec3(2 * (v.x * v.y - w * v.z), 1 - 2 * (v.x * v.x + v.z * v.z), 2 * (v.y * v.z + w * v.x));
    out.z = glm::vec3(2 * (v.x * v.z + w * v.y), 2 * (v.y * v.z - w * v.x), 1 - 2 * (v.x * v.x + v.y * v.y));
    return out;
}

// The shortest rotation from one direction to another. No trigonometry, so its bits are the same everywhere.
// Opposite directions have no shortest one; no leg gets there.
Turn between(const glm::vec3 &from, const glm::vec3 &to)
{
    const float scale = length(from) * length(to);
    if (!(scale > 0)) return Turn();
    const float w = 1 + dot(from, to) / scale;
    if (!(w > 1e-4f)) return Turn();
    const glm::vec3 v = cross(from, to) / scale;
    const float norm = std::sqrt(w * w + dot(v, v));
    return turn_of(w / norm, v / norm);
}

glm::vec3 vec_of(const F4 &v) { return glm::vec3(v[0], v[1], v[2]); }

// Moves nodes rigidly: `turn` about `from`, which then lies at `to`.
struct Move {
    F4 x, y, z;
    glm::vec3 from, to;

    Move(const Turn &turn, const glm::vec3 &pivot, const glm::vec3 &there)
        : x{turn.x.x, turn.x.y, turn.x.z, 0},
          y{turn.y.x, turn.y.y, turn.y.z, 0},
          z{turn.z.x, turn.z.y, turn.z.z, 0},
          from(pivot),
          to(there)
    {
    }
    F4 turned(const F4 &v) const { return x * splat(v[0]) + y * splat(v[1]) + z * splat(v[2]); }
    void apply(const model::Array<uint32_t> &nodes, Columns *globals) const
    {
        for (const uint32_t node : nodes) {
            Columns &c = globals[node];
            for (int k = 0; k < 3; ++k) c.c[k] = turned(c.c[k]);
            c.c[3] = turned(c.c[3] - F4{from.x, from.y, from.z, 0}) + F4{to.x, to.y, to.z, 0};
        }
    }
};

// The knee that a leg with these joints bends to, for the ankle at `ankle`.
glm::vec3 knee_for(const glm::vec3 &hip, const glm::vec3 &ankle, const glm::vec3 &bent, float thigh, float shin)
{
    const glm::vec3 to_ankle = ankle - hip;
    const float distance = length(to_ankle);
    const glm::vec3 along = to_ankle / distance;
    const float forward = (thigh * thigh - shin * shin + distance * distance) / (2 * distance);
    const float square = thigh * thigh - forward * forward;
    const float out = square > 0 ? std::sqrt(square) : 0;
    glm::vec3 side = bent - along * dot(bent, along);
    // A straight leg bends to the front.
    if (!(length(side) > 1e-3f * thigh)) side = glm::vec3(0, 0, 1) - along * along.z;
    return hip + along * forward + side * (out / length(side));
}

// The joints of a leg, and where its foot has to go.
struct Reach {
    glm::vec3 hip, knee, ankle, foot, wanted;
    Turn turn;  // of the foot
    float thigh, shin;
};

struct Flat {
    float x, z;
};

// From the ball of a flat foot that points along `ahead` to one of its points.
Flat flat_of(const SolePoint &point, const Flat &ahead)
{
    return {ahead.x * point.ahead + ahead.z * point.aside, ahead.z * point.ahead - ahead.x * point.aside};
}

// The lowest point of a sole.
struct Touch {
    const SolePoint *point = nullptr;
    glm::vec3 at = glm::vec3(0);  // in model space
};

Touch touch_of(const Leg &leg, const Columns *globals)
{
    Touch out;
    float low = 0;
    const auto count = static_cast<uint32_t>(leg.sole.size());
    for (uint32_t i = 0; i < count; ++i) {
        const Columns &node = globals[i < leg.first_of_toes ? leg.foot : leg.toes];
        const glm::vec3 &p = leg.sole[i].at;
        const float y = node.c[0][1] * p.x + node.c[1][1] * p.y + node.c[2][1] * p.z + node.c[3][1];
        if (!out.point || y < low) out.point = &leg.sole[i], low = y;
    }
    if (!out.point) return out;
    const bool of_foot = out.point < leg.sole.data() + leg.first_of_toes;
    out.at = point_of(globals[of_foot ? leg.foot : leg.toes], out.point->at);
    return out;
}

Flat ahead_of(const Leg &leg, const Columns *globals)
{
    const glm::vec3 d = point_of(globals[leg.foot], leg.ball) - point_of(globals[leg.foot], leg.heel);
    const float flat = std::sqrt(d.x * d.x + d.z * d.z);
    return flat > 0 ? Flat{d.x / flat, d.z / flat} : Flat{0, 1};
}

// The rotation about y from one unit vector to another.
Turn turn_between(const Flat &from, const Flat &to)
{
    const float c = from.x * to.x + from.z * to.z, s = from.z * to.x - from.x * to.z;
    return {glm::vec3(c, 0, -s), glm::vec3(0, 1, 0), glm::vec3(s, 0, c)};
}

Flat wanted_ahead(const FootTarget &target, const Flat &own)
{
    if (std::isnan(target.turn_rad)) return own;
    const Flat wanted{math::sin(target.turn_rad), math::cos(target.turn_rad)};
    const Flat sum{own.x + (wanted.x - own.x) * target.weight, own.z + (wanted.z - own.z) * target.weight};
    const float size = std::sqrt(sum.x * sum.x + sum.z * sum.z);
    return size > 1e-3f ? Flat{sum.x / size, sum.z / size} : own;
}

// How far a foot that has to stay over a height is moved up, without a corner.
float raised(float clear, float low)
{
    const float more = clear - low, soft = 0.25f * std::fabs(clear);
    return 0.5f * (more + std::sqrt(more * more + soft * soft));
}

Reach reach_of(const FootTarget &target, const Columns *globals)
{
    const Leg &leg = *target.leg;
    const float sink = target.sink * target.weight;
    Reach out;
    out.hip = vec_of(globals[leg.thigh].c[3]), out.knee = vec_of(globals[leg.shin].c[3]);
    out.ankle = point_of(globals[leg.shin], leg.ankle), out.foot = vec_of(globals[leg.foot].c[3]);
    const Flat own = ahead_of(leg, globals), ahead = wanted_ahead(target, own);
    out.turn = turn_between(own, ahead);
    const Touch touch = touch_of(leg, globals);
    const glm::vec3 turned = out.foot + out.turn * (touch.at - out.foot);
    const Flat own_flat = flat_of(*touch.point, own), flat = flat_of(*touch.point, ahead);

    // In the air, too, it is the sole that is moved: a foot that comes down or is lifted must not jump.
    const float to_x = target.planted ? target.x : touch.at.x - own_flat.x + target.x;
    const float to_z = target.planted ? target.z : touch.at.z - own_flat.z + target.z;
    glm::vec3 shift(to_x - (turned.x - flat.x), 0, to_z - (turned.z - flat.z));
    shift = shift * target.weight;
    const float far = length(shift);
    if (far > leg.max_shift) shift = shift * (leg.max_shift / far);
    const auto within = [&leg](float up) {
        return up < -leg.max_shift ? -leg.max_shift : up > leg.max_shift ? leg.max_shift : up;
    };
    const float low = touch.at.y + sink;
    float up = -target.ground * low;
    if (target.clear > -HUGE_VALF) up += (1 - target.ground) * raised(target.clear, low);
    shift.y = target.weight * within(up);
    if (target.y != 0) shift.y = within(shift.y + target.weight * target.y);
    out.wanted = out.foot + shift;
    out.wanted.y += sink;
    if (target.slope != 0) {
        // The foot as it stands on level ground, tilted about the place of its ball.
        const glm::vec3 ball(turned.x - flat.x + shift.x, target.weight * target.y, turned.z - flat.z + shift.z);
        const float slope = target.weight * target.slope;
        const Turn tilt = between(glm::vec3(0, 1, 0), glm::vec3(-slope * ahead.x, 1, -slope * ahead.z));
        out.wanted = ball + tilt * (out.wanted - ball);
        out.turn = tilt * out.turn;
    }
    out.thigh = length(out.knee - out.hip), out.shin = length(out.ankle - out.knee);
    return out;
}

}  // namespace

model::Array<uint32_t> nodes_below(const model::Rig &rig, uint32_t node, uint32_t end,
                                   std::pmr::memory_resource *memory)
{
    model::Array<uint32_t> out(memory);
    model::Array<uint8_t> inside(rig.node_count(), uint8_t(0), memory);
    inside[node] = 1;
    out.push_back(node);
    for (uint32_t i = node + 1; i < rig.node_count(); ++i) {
        const uint32_t parent = rig.parents[i];
        if (parent == model::none || !inside[parent] || i == end) continue;
        inside[i] = 1;
        out.push_back(i);
    }
    return out;
}

glm::vec3 point_of(const Columns &node, const glm::vec3 &point) noexcept
{
    return vec_of(node.c[0] * splat(point.x) + node.c[1] * splat(point.y) + node.c[2] * splat(point.z) + node.c[3]);
}

Print print_of(const Leg &leg, const Columns *globals) noexcept
{
    const Flat ahead = ahead_of(leg, globals);
    const Touch touch = touch_of(leg, globals);
    const Flat flat = flat_of(*touch.point, ahead);
    return {touch.at.x - flat.x, touch.at.z - flat.z, touch.at.y, ahead.x, ahead.z};
}

void move_foot(const FootTarget &target, Columns *globals) noexcept
{
    const Leg &leg = *target.leg;
    const Reach reach = reach_of(target, globals);
    const glm::vec3 &hip = reach.hip, &knee = reach.knee, &ankle = reach.ankle;
    const float thigh = reach.thigh, shin = reach.shin;
    glm::vec3 wanted = reach.wanted;
    const float distance = length(wanted - hip), farthest = (thigh + shin) * 0.9995f;
    const float nearest = std::fabs(thigh - shin) * 1.0005f;
    if (!(thigh > 0) || !(shin > 0) || !(distance > nearest)) return;
    if (distance > farthest) wanted = hip + (wanted - hip) * (farthest / distance);

    // First the leg as a whole, then the knee.
    const Turn whole = between(ankle - hip, wanted - hip);
    const glm::vec3 new_knee = knee_for(hip, wanted, whole * (knee - hip), thigh, shin);
    const Turn upper = between(whole * (knee - hip), new_knee - hip) * whole;
    const Turn lower = between(whole * (ankle - knee), wanted - new_knee) * whole;
    Move(upper, hip, hip).apply(leg.thigh_nodes, globals);
    Move(lower, knee, new_knee).apply(leg.shin_nodes, globals);
    Move(reach.turn, reach.foot, wanted).apply(leg.foot_nodes, globals);
}

}  // namespace claque::pose
