// The theatre's stone: seats and steps at their described positions, faces that look outwards, within a triangle
// budget.
#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/odeon/opus_sectile.h"
#include "samples/scenes/odeon/orchestra.h"
#include "samples/scenes/scenario/scenario.h"

namespace
{

using namespace scenes;

constexpr double tolerance_m = 0.001;

const Theatre &theatre()
{
    static const Theatre read = *odeon_scenario().theatre;
    return read;
}

Geometry cavea()
{
    Parts stone;
    build_cavea(stone, theatre(), 1);
    return stone.fine;
}

Geometry stage()
{
    Geometry stone;
    build_stage(stone, theatre());
    return stone;
}

struct Face {
    Vec3 a, b, c;
    Vec3 normal;  // not of unit length: twice the area
};

Vec3 minus(Vec3 p, Vec3 q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Vec3 cross(Vec3 p, Vec3 q) { return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x}; }
double dot(Vec3 p, Vec3 q) { return static_cast<double>(p.x) * q.x + p.y * q.y + p.z * q.z; }

Face face(const Geometry &g, size_t triangle)
{
    const auto at = [&](size_t k) { return g.vertices()[g.indices()[3 * triangle + k]].position; };
    const Vec3 a = at(0), b = at(1), c = at(2);
    return {a, b, c, cross(minus(b, a), minus(c, a))};
}

size_t triangles(const Geometry &g) { return g.indices().size() / 3; }

// The highest surface over a point of the ground plan, and whether it faces up.
struct Top {
    double y = -1;
    bool looks_up = false;
};

Top top(const std::vector<Face> &faces, double x, double z)
{
    Top best;
    for (const Face &f : faces) {
        const double area = f.normal.y;
        if (std::abs(area) < 1e-9) continue;
        const auto side = [&](Vec3 p, Vec3 q) { return (p.z - z) * (q.x - x) - (p.x - x) * (q.z - z); };
        const double u = side(f.b, f.c) / area, v = side(f.c, f.a) / area, w = side(f.a, f.b) / area;
        if (u < 0 || v < 0 || w < 0) continue;
        const double y = u * f.a.y + v * f.b.y + w * f.c.y;
        if (y > best.y) best = {y, area > 0};
    }
    return best;
}

std::vector<Face> faces_of(const Geometry &g)
{
    std::vector<Face> faces;
    for (size_t i = 0; i < triangles(g); ++i) faces.push_back(face(g, i));
    return faces;
}

// For every seat: the stone at this distance behind its front edge (negative: inwards) has the requested height.
void expect_stone(double behind_m, const std::function<double(const Seat &)> &height)
{
    const std::vector<Face> faces = faces_of(cavea());
    for (const Seat &seat : seats_of(theatre())) {
        const double radius = std::sqrt(seat.x * seat.x + seat.z * seat.z), k = (radius + behind_m) / radius;
        const Top found = top(faces, seat.x * k, seat.z * k);
        ASSERT_NEAR(found.y, height(seat), tolerance_m)
            << "row " << seat.row + 1 << ", " << seat.angle_deg << " degrees";
        ASSERT_TRUE(found.looks_up) << "row " << seat.row + 1 << ", " << seat.angle_deg << " degrees";
    }
}

void expect_sound(const Geometry &g, const char *what)
{
    for (size_t i = 0; i < triangles(g); ++i) {
        const Face f = face(g, i);
        const double size = std::sqrt(dot(f.normal, f.normal));
        ASSERT_GT(size, 1e-7) << what << ": triangle " << i << " has no area";
        for (size_t k = 0; k < 3; ++k) {
            const Vec3 lit = g.vertices()[g.indices()[3 * i + k]].normal;
            ASSERT_NEAR(dot(lit, lit), 1, 1e-4) << what << ": triangle " << i;
            ASSERT_GT(dot(lit, f.normal) / size, 0.8) << what << ": triangle " << i << " is lit from behind";
        }
    }
}

bool same(const Geometry &a, const Geometry &b)
{
    return a.indices() == b.indices() && a.vertices().size() == b.vertices().size() &&
           std::memcmp(a.vertices().data(), b.vertices().data(), a.vertices().size() * sizeof(SceneryVertex)) == 0;
}

}  // namespace

TEST(Building, SeatsAreOfTheHeightThatTheirRowsSay)
{
    expect_stone(0.05, [](const Seat &seat) { return seat.y; });
    expect_stone(0.40, [](const Seat &seat) { return seat.y; });
}

TEST(Building, ThereIsStoneUnderTheFeetAtTheHeightOfTheStep)
{
    expect_stone(-0.10, [](const Seat &seat) { return seat.step_y; });
    expect_stone(-0.35, [](const Seat &seat) { return seat.step_y; });
}

TEST(Building, NoFaceIsWithoutAreaOrLitFromBehind)
{
    expect_sound(cavea(), "cavea");
    expect_sound(stage(), "stage");
    expect_sound(Orchestra(theatre(), 1).floor(), "orchestra");
}

TEST(Building, ATheatreHasAtMostSixtyThousandTriangles)
{
    EXPECT_LE(triangles(cavea()) + triangles(stage()) + triangles(Orchestra(theatre(), 1).floor()), 60000u);
}

TEST(Building, ATheatreIsTheSameEachTime)
{
    EXPECT_TRUE(same(cavea(), cavea()));
    EXPECT_TRUE(same(stage(), stage()));
    EXPECT_EQ(opus_sectile(1, 11).rgba, opus_sectile(1, 11).rgba);
    EXPECT_NE(opus_sectile(1, 11).rgba, opus_sectile(2, 11).rgba);
}

TEST(Building, TheOrchestraIsPavedToBelowThePodiumAndLevel)
{
    const Orchestra orchestra(theatre(), 1);
    const std::vector<Face> faces = faces_of(orchestra.floor());
    for (int k = 0; k < 97; ++k) {
        const double turn = 0.0647 * k, out = theatre().orchestra_radius_m * (k % 9 / 8.0);
        const Top found = top(faces, out * std::sin(turn), out * std::cos(turn));
        EXPECT_EQ(found.y, 0) << out << " m from the middle";
        EXPECT_TRUE(found.looks_up) << out << " m from the middle";
    }
}
