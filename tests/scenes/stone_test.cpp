// No vertex of a person in the odeon lies in the stone: body, hem and toga, sitting, rising, sitting down and standing
// before the seat. The stone is the one that is drawn: seats, steps, stairs, and the riser of the next row.
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/validate_theatre.h"
#include "samples/scenes/scenario/scenario.h"
#include "tests/scenes/body.h"

namespace
{

using namespace scenes;
using glm::dvec3;

// Cloth and flesh that bear a person's weight give way by so much; the stone's arcs are chords that deviate by 3 mm.
constexpr double gives_way_m = 0.010;
constexpr int moments = 25;

using Triangle = std::array<dvec3, 3>;

dvec3 nearest(const Triangle &t, dvec3 p)
{
    const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const auto part = [&](dvec3 m, dvec3 n) { return glm::dot(glm::cross(m - p, n - p), normal); };
    const double u = part(t[1], t[2]), v = part(t[2], t[0]), w = part(t[0], t[1]);
    if (u >= 0 && v >= 0 && w >= 0 && u + v + w > 0) return (u * t[0] + v * t[1] + w * t[2]) / (u + v + w);
    dvec3 best = t[0];
    for (size_t k = 0; k < 3; ++k) {
        const dvec3 m = t[k], line = t[(k + 1) % 3] - m;
        const dvec3 q = m + line * glm::clamp(glm::dot(p - m, line) / glm::dot(line, line), 0.0, 1.0);
        if (glm::distance(q, p) < glm::distance(best, p)) best = q;
    }
    return best;
}

// The drawn triangles near a seat.
class Stone
{
public:
    Stone(const Geometry &all, const Seat &seat)
    {
        const std::vector<SceneryVertex> &vertices = all.vertices();
        const std::vector<uint32_t> &indices = all.indices();
        for (size_t i = 0; i + 2 < indices.size(); i += 3) {
            Triangle t;
            dvec3 low(1e9), high(-1e9);
            for (size_t k = 0; k < 3; ++k) {
                const Vec3 p = vertices[indices[i + k]].position;
                t[k] = {double(p.x), double(p.y), double(p.z)};
                low = glm::min(low, t[k]), high = glm::max(high, t[k]);
            }
            const dvec3 near(seat.x, seat.y, seat.z), room(0.9, 1, 0.9);
            if (glm::all(glm::lessThan(low, near + room)) && glm::all(glm::greaterThan(high, near - room)))
                near_.push_back(t);
        }
    }

    // Inside is where the first face above looks up.
    double depth(dvec3 p) const
    {
        double above = 1e9;
        bool inside = false;
        for (const Triangle &t : near_) {
            const auto side = [&](dvec3 m, dvec3 n) { return (m.z - p.z) * (n.x - p.x) - (m.x - p.x) * (n.z - p.z); };
            const double u = side(t[1], t[2]), v = side(t[2], t[0]), w = side(t[0], t[1]), area = u + v + w;
            if ((u > 0) != (v > 0) || (v > 0) != (w > 0) || area == 0) continue;
            const double y = (u * t[0].y + v * t[1].y + w * t[2].y) / area;
            if (y < p.y || y > above) continue;
            above = y;
            inside = area > 0;
        }
        if (!inside) return 0;
        double least = 1e9;
        for (const Triangle &t : near_) least = std::min(least, glm::distance(nearest(t, p), p));
        return least;
    }

private:
    std::vector<Triangle> near_;
};

struct Scene {
    Theatre theatre = *odeon_scenario().theatre;
    std::vector<Seat> seats = seats_of(theatre);
    std::vector<Sitter> people = seat_people(theatre, seats, 0, 1);
    Geometry stone;  // as it is drawn near by

    Scene()
    {
        Parts parts;
        build_cavea(parts, theatre, 1);
        stone = parts.fine;
    }
};

const Scene &scene()
{
    static const Scene made;
    return made;
}

// In each row of a character: the people who are the largest, the smallest, and turned the farthest from the
// orchestra's centre to either side.
std::vector<Sitter> extreme_people(const std::string &character)
{
    std::map<size_t, std::array<std::pair<double, const Sitter *>, 6>> rows;
    for (const Sitter &one : scene().people) {
        if (scene().theatre.classes[one.social_class].character != character) continue;
        const Seat &seat = scene().seats[one.seat];
        const double sine = double(one.place.orientation_xyzw[1]), cosine = double(one.place.orientation_xyzw[3]);
        const double away = std::remainder(2 * std::atan2(sine, cosine) - std::atan2(-seat.x, -seat.z), 6.283185307);
        const double size = 20 * (double(one.scale) - 1);
        const double merits[6] = {size, -size, away, -away, away - size, -away - size};
        for (size_t k = 0; k < 6; ++k) {
            auto &best = rows[seat.row][k];
            if (!best.second || merits[k] > best.first) best = {merits[k], &one};
        }
    }
    std::vector<Sitter> out;
    for (const auto &[row, best] : rows)
        for (const auto &[merit, one] : best) out.push_back(*one);
    return out;
}

struct Depth {
    double metres = 0;
    std::string when;
};

// Of all vertices below the seat's top, or behind the seat.
double deepest(const Stone &stone, const Seat &seat, const clq_transform &place, const std::vector<dvec3> &vertices)
{
    const double radius = std::hypot(seat.x, seat.z), deep = scene().theatre.rows[seat.row].depth_m;
    double most = 0;
    for (const dvec3 &vertex : vertices) {
        const dvec3 p = bodies::placed(place, vertex);
        const double behind = std::hypot(p.x, p.z) - radius;
        if (behind < deep - 0.05 && (p.y > seat.y + 0.001 || (behind < -0.05 && p.y > seat.step_y + 0.001))) continue;
        most = std::max(most, stone.depth(p));
    }
    return most;
}

void expect_out_of_the_stone(const std::string &character, size_t rows)
{
    bodies::Body body(character);
    std::vector<std::pair<Sitter, Stone>> people;
    for (const Sitter &one : extreme_people(character))
        people.emplace_back(one, Stone(scene().stone, scene().seats[one.seat]));
    EXPECT_EQ(people.size(), 6 * rows);
    for (size_t act = 0; act < act_count; ++act) {
        const char *name = clip_name(static_cast<Act>(act));
        const uint32_t clip = body.clip(name);
        Depth found;
        for (int k = 0; k <= moments; ++k) {
            const double time = body.duration_s(clip) * k / moments;
            body.pose(clip, time);
            for (const auto &[one, stone] : people) {
                const double depth = deepest(stone, scene().seats[one.seat], one.place, body.vertices());
                if (depth <= found.metres) continue;
                found = {depth, std::to_string(time) + " s, row " + std::to_string(scene().seats[one.seat].row + 1) +
                                    ", scale " + std::to_string(one.scale)};
            }
        }
        testing::Test::RecordProperty(name, std::to_string(found.metres));
        EXPECT_LE(found.metres, gives_way_m) << name << " at " << found.when;
    }
}

TEST(InStone, LiesNoVertexOfADecurion) { expect_out_of_the_stone("decurion", 9); }
TEST(InStone, LiesNoVertexOfAPatrician) { expect_out_of_the_stone("patrician", 5); }
TEST(InStone, LiesNoVertexOfAPlebeian) { expect_out_of_the_stone("plebeian", 4); }

// A person who sits 4 cm too low or too far back is found at that depth.
TEST(InStone, TheTestFindsPeopleWhoSitTooLowOrTooFarBack)
{
    bodies::Body body("plebeian");
    body.pose(body.clip("sit"), 0);
    const Sitter one = extreme_people("plebeian").front();
    const Seat &seat = scene().seats[one.seat];
    const Stone stone(scene().stone, seat);
    clq_transform low = one.place, back = one.place;
    low.position[1] -= 0.04;
    back.position[0] -= 0.2 * seat.facing_x, back.position[2] -= 0.2 * seat.facing_z;
    EXPECT_NEAR(deepest(stone, seat, low, body.vertices()), 0.04, 0.012);
    EXPECT_GT(deepest(stone, seat, back, body.vertices()), 0.04);
}

}  // namespace
