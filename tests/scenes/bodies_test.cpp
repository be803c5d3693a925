// Individuals sit on their seats with their feet on the stone, and no body intersects another.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/odeon/validate_theatre.h"
#include "samples/scenes/scenario/scenario.h"
#include "tests/scenes/body.h"

namespace
{

using namespace scenes;
using bodies::Body;
using bodies::Capsule;

constexpr double touch_m = 0.015;  // allowed depth where neighbours' sleeves touch

const std::vector<std::string> figures = {"decurion", "patrician", "plebeian"};

const Theatre &full_odeon()
{
    static const Theatre theatre = *odeon_scenario().theatre;
    return theatre;
}

Body &body(const std::string &figure)
{
    static std::map<std::string, std::unique_ptr<Body>> made;
    std::unique_ptr<Body> &found = made[figure];
    if (!found) found = std::make_unique<Body>(figure);
    return *found;
}

// Distance between the hip joints and the seat, of a character of scale 1.
constexpr double flesh_m = 0.072;

// Where a sitter touches the stone, above its character's own ground.
struct Contact {
    double pelvis = 0;  // of its joints
    double skin = 9;    // the lowest vertex under it
    double left_foot = 9, right_foot = 9;
};

Contact contact(const Body &posed)
{
    Contact c;
    c.pelvis = posed.hips().y - flesh_m;
    for (const glm::dvec3 &p : posed.vertices()) {
        if (p.z > -0.52 && p.z < -0.28 && std::abs(p.x) < 0.2) c.skin = std::min(c.skin, p.y);
        double &foot = p.x > 0 ? c.left_foot : c.right_foot;
        if (p.z > -0.12) foot = std::min(foot, p.y);
    }
    return c;
}

void expect_on_the_stone(const std::string &figure, float smallest, float tallest)
{
    Body &one = body(figure);
    Seat seat;
    seat.y = 5.0;
    seat.step_y = 5.0 - sitting_height_m;
    seat.facing_z = 1;
    for (size_t act = 0; act < seated_count; ++act) {
        const uint32_t clip = one.clip(clip_name(static_cast<Act>(act)));
        for (double t = 0; t < one.duration_s(clip); t += 0.1) {
            one.pose(clip, t);
            const Contact met = contact(one);
            for (const float scale : {smallest, (smallest + tallest) / 2, tallest}) {
                const double ground = sit_down(seat, 0, scale).position[1];
                const auto at = [&](double y) { return ground + static_cast<double>(scale) * y; };
                const std::string when = figure + " " + clip_name(static_cast<Act>(act)) + " at " + std::to_string(t);
                EXPECT_NEAR(at(met.pelvis), seat.y, 0.03) << when << ", scale " << scale;
                EXPECT_NEAR(at(met.skin), seat.y, 0.04) << when << ", scale " << scale;
                EXPECT_NEAR(at(met.left_foot), seat.step_y, 0.015) << when << ", scale " << scale;
                EXPECT_NEAR(at(met.right_foot), seat.step_y, 0.015) << when << ", scale " << scale;
            }
        }
    }
}

struct Posed {
    std::vector<glm::dvec3> vertices;
    std::vector<Capsule> capsules;
};

Posed posed(const Member &member, const std::string &figure, const clq_transform &place, double time_s)
{
    Body &one = body(figure);
    const Playing now = playing_at(member, time_s);
    one.pose(one.clip(clip_name(now.act)), (time_s - now.begin_s) * now.speed);
    Posed out;
    for (const glm::dvec3 &p : one.vertices()) out.vertices.push_back(bodies::placed(place, p));
    for (Capsule c : one.capsules()) {
        c.from = bodies::placed(place, c.from);
        c.to = bodies::placed(place, c.to);
        c.radius *= static_cast<double>(place.scale);
        out.capsules.push_back(c);
    }
    return out;
}

// How deep a vertex of one body lies in a limb of another, in metres; negative outside.
struct Overlap {
    double depth = -1;
    const char *limb = "";
};

Overlap overlap(const Posed &a, const Posed &b)
{
    Overlap deepest;
    const auto look = [&](const Posed &of, const Posed &in) {
        for (const glm::dvec3 &p : of.vertices)
            for (const Capsule &c : in.capsules) {
                const double depth = bodies::depth(c, p);
                if (depth > deepest.depth) deepest = {depth, c.name};
            }
    };
    look(a, b);
    look(b, a);
    return deepest;
}

struct Crush {
    double deepest = -1;
    uint32_t pairs = 0, inside = 0;
    std::string person;
};

// Every `stride`th seat with those beside and behind it, in theatres whose seats and rows may be narrower.
Crush crush(const Theatre &theatre, size_t stride, const std::vector<double> &times)
{
    const std::vector<Seat> seats = seats_of(theatre);
    const std::vector<Sitter> people = seat_people(theatre, seats, 0, 1);
    std::vector<Member> members = members_of(theatre, seats, people, 1);
    const auto figure = [&](size_t i) { return theatre.classes[people[i].social_class].character; };
    for (size_t i = 0; i < people.size(); ++i)
        for (size_t act = 0; act < act_count; ++act)
            members[i].duration_s[act] =
                body(figure(i)).duration_s(body(figure(i)).clip(clip_name(static_cast<Act>(act))));
    Crush found;
    for (size_t i = 0; i < people.size(); i += stride)
        for (size_t k = 0; k < people.size(); ++k) {
            const Seat &a = seats[people[i].seat], &b = seats[people[k].seat];
            if (i == k || b.row < a.row || b.row > a.row + 1 || std::hypot(a.x - b.x, a.z - b.z) > 1.1) continue;
            for (const double t : times) {
                const Overlap deep = overlap(posed(members[i], figure(i), people[i].place, t),
                                             posed(members[k], figure(k), people[k].place, t));
                ++found.pairs;
                found.inside += deep.depth > touch_m;
                if (deep.depth <= found.deepest) continue;
                found.deepest = deep.depth;
                found.person = "seats " + std::to_string(people[i].seat) + " and " + std::to_string(people[k].seat) +
                               " at " + std::to_string(t) + " s, in the " + deep.limb + " (" +
                               clip_name(playing_at(members[i], t).act) + ", " +
                               clip_name(playing_at(members[k], t).act) + ")";
            }
        }
    return found;
}

TEST(Bodies, ADecurionSitsOnTheSeatWithFeetOnTheStep) { expect_on_the_stone("decurion", 0.97f, 1.03f); }
TEST(Bodies, APatricianSitsOnTheSeatWithFeetOnTheStep) { expect_on_the_stone("patrician", 0.93f, 0.98f); }
TEST(Bodies, APlebeianSitsOnTheSeatWithFeetOnTheStep) { expect_on_the_stone("plebeian", 0.97f, 1.03f); }

TEST(Bodies, NoTwoPeopleIntersect)
{
    const Crush found = crush(full_odeon(), 3, {2.0, 11.7, 23.4, 58.0, 77.1});
    EXPECT_GT(found.pairs, 3000u);
    EXPECT_LE(found.deepest, touch_m) << found.person << ", " << found.inside << " of " << found.pairs;
}

TEST(Bodies, TheTestFindsPeopleWhoSitFifteenCentimetresTooNear)
{
    Theatre narrow = full_odeon(), shallow = full_odeon();
    narrow.seat_width_m -= 0.15;
    EXPECT_GT(crush(narrow, 10, {2.0}).inside, 8u);
    for (size_t row = 0; row < shallow.rows.size(); ++row)
        shallow.rows[row].radius_m -= 0.15 * static_cast<double>(row < 9 ? row : row - 9);
    EXPECT_GT(crush(shallow, 10, {2.0}).inside, 8u);
}

TEST(Bodies, ClipsThatFollowEachOtherJoin)
{
    for (const std::string &figure : figures) {
        Body &one = body(figure);
        const auto vertices = [&](Act act, bool end) {
            const uint32_t clip = one.clip(clip_name(act));
            one.pose(clip, end ? one.duration_s(clip) : 0.0);
            return one.vertices();
        };
        const std::vector<glm::dvec3> seat = vertices(Act::sit, false), up = vertices(Act::stand, false);
        for (size_t a = 0; a < act_count; ++a) {
            const Act act = static_cast<Act>(a);
            const bool seated = a < seated_count;
            const std::vector<glm::dvec3> begin = vertices(act, false), end = vertices(act, true);
            for (size_t v = 0; v < seat.size(); ++v) {
                const glm::dvec3 from = seated || act == Act::rise ? seat[v] : up[v];
                const glm::dvec3 to = seated || act == Act::sit_down ? seat[v] : up[v];
                // Cloth may still swing a little where a neighbour has just risen.
                ASSERT_LT(glm::length(begin[v] - from), act == Act::sit_down ? 0.04 : 0.01)
                    << figure << " " << clip_name(act) << " begins";
                ASSERT_LT(glm::length(end[v] - to), act == Act::rise ? 0.04 : 0.01)
                    << figure << " " << clip_name(act) << " ends";
            }
        }
    }
}

}  // namespace
