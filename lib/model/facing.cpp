#include "lib/model/facing.h"

#include <cmath>
#include <vector>

#include "lib/math/trig.h"
#include "lib/model/limb_names.h"

namespace claque::model
{

namespace
{

// Over the ground.
struct Way {
    double x = 0, z = 0;

    double length() const { return std::sqrt(x * x + z * z); }
    double heading_deg() const { return math::atan2(x, z) * 180 / math::pi; }
};

class Body
{
public:
    Body(const Rig &rig, const std::vector<math::Affine> &globals) : rig_(rig), globals_(globals)
    {
        find_limbs(rig, legs_);
    }

    bool stands() const
    {
        for (int side = 0; side < 2; ++side) {
            if (legs_[side][0] == none || low(side) == none) return false;
            const glm::dvec3 d = place(legs_[side][0]) - place(low(side));
            if (!(d.y > 0.5 * std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z))) return false;
        }
        return true;
    }

    // Animals have no arms.
    bool has_arms() const
    {
        bool found[2] = {false, false};
        for (const std::pmr::string &name : rig_.node_names) {
            const std::pmr::string plain = plain_name(name, rig_.parents.get_allocator().resource());
            const Side side = side_of(name, plain);
            if (side != Side::unknown && has(plain, "arm")) found[side == Side::right] = true;
        }
        return found[0] && found[1];
    }

    // Both feet, if they agree.
    bool by_toes(Way &out) const
    {
        for (const auto &leg : legs_) {
            if (leg[2] == none || leg[3] == none) return false;
            const Way foot = way(leg[2], leg[3]);
            if (!(foot.length() > 0)) return false;
            out.x += foot.x / foot.length(), out.z += foot.z / foot.length();
        }
        return out.length() > 1.2;  // feet turned outwards by 53 degrees each
    }

    // The middle of two eyes, as seen from the head.
    bool by_eyes(Way &out) const
    {
        bool found[2] = {false, false};
        for (uint32_t i = 0; i < rig_.node_count(); ++i) {
            const std::pmr::string plain = plain_name(rig_.node_names[i], rig_.parents.get_allocator().resource());
            const Side side = side_of(rig_.node_names[i], plain);
            if (!has(plain, "eye") || has(plain, "brow") || has(plain, "lid") || has(plain, "lash")) continue;
            const uint32_t head = head_above(i);
            if (side == Side::unknown || head == none || found[side == Side::right] || is_control(plain)) continue;
            const Way eye = way(head, i);
            out.x += eye.x, out.z += eye.z;
            found[side == Side::right] = true;
        }
        const glm::dvec3 leg = place(legs_[0][0]) - place(low(0));
        return found[0] && found[1] && out.length() > 0.05 * leg.y;  // a head's joint may lie between the eyes
    }

    bool by_legs(Way &out) const
    {
        const Way left = way(legs_[1][0], legs_[0][0]);
        out = {-left.z, left.x};
        return out.length() > 0;
    }

private:
    // The lowest part of a leg that has a name: some rigs have the feet among their controls.
    uint32_t low(int side) const { return legs_[side][2] != none ? legs_[side][2] : legs_[side][1]; }
    glm::dvec3 place(uint32_t node) const { return glm::dvec3(globals_[node].column(3)); }
    Way way(uint32_t from, uint32_t to) const
    {
        const glm::dvec3 d = place(to) - place(from);
        return {d.x, d.z};
    }
    uint32_t head_above(uint32_t node) const
    {
        for (node = rig_.parents[node]; node != none; node = rig_.parents[node])
            if (has(plain_name(rig_.node_names[node], rig_.parents.get_allocator().resource()), "head")) break;
        return node;
    }

    const Rig &rig_;
    const std::vector<math::Affine> &globals_;
    uint32_t legs_[2][4] = {};
};

std::vector<math::Affine> rest_of(const Rig &rig)
{
    std::vector<math::Affine> globals;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const math::Affine local = math::affine_of(rig.rest[i]);
        globals.push_back(rig.parents[i] == none ? local : math::mul(globals[rig.parents[i]], local));
    }
    return globals;
}

}  // namespace

bool is_person(const Rig &rig)
{
    const std::vector<math::Affine> globals = rest_of(rig);
    const Body body(rig, globals);
    return body.stands() && body.has_arms();
}

Facing facing_of(const Rig &rig) { return facing_of(rig, rest_of(rig)); }

Facing facing_of(const Rig &rig, const std::vector<math::Affine> &globals)
{
    const Body body(rig, globals);
    if (!body.stands()) return {};
    Way toes, eyes, legs;
    const bool has_legs = body.by_legs(legs);
    // Feet and heads turn; of the two ways in which the legs may stand side by side they choose one.
    const auto chosen = [&](const char *seen, const Way &way) {
        const bool agree = has_legs && legs.x * way.x + legs.z * way.z > 0;
        return Facing{seen, (agree ? legs : way).heading_deg()};
    };
    if (body.by_toes(toes)) return chosen("toes", toes);
    if (body.by_eyes(eyes)) return chosen("eyes", eyes);
    if (has_legs) return chosen("legs", legs);
    return {};
}

int quarter_of(double heading_deg) { return static_cast<int>(std::floor((heading_deg + 225) / 90)) % 4; }

const char *axis_of(double heading_deg)
{
    constexpr const char *axes[] = {"-z", "-x", "+z", "+x"};
    return axes[quarter_of(heading_deg)];
}

double turn_to_front_deg(double heading_deg)
{
    const double turn = -90 * std::floor(heading_deg / 90 + 0.5);
    return turn <= -180 ? turn + 360 : turn;
}

}  // namespace claque::model
