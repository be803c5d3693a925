// The town: ground height matches its triangles, houses stand on the ground, and pieces lie inside their spheres.
#include "samples/scenes/town/town.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "samples/scenes/scene_renderer.h"

namespace
{

using namespace scenes;
using namespace scenes::town;

const Town &the_town()
{
    static const Town built(1);
    return built;
}

template <class Visit>
void each_vertex(const Piece &piece, Visit visit)
{
    for (const Span &span : piece.spans) {
        const Geometry &g = the_town().pieces().on(span.layer);
        for (uint32_t i = span.first; i < span.first + span.count; ++i)
            visit(g.vertices()[g.indices()[i]].position, span.layer);
    }
}

double twice_area(Vec3 a, Vec3 b, Vec3 c)
{
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    return std::sqrt(x * x + y * y + z * z);
}

Eye eye_at(double x, double y, double z, double to_x, double to_y, double to_z)
{
    return eye_of(look({x, y, z}, {to_x, to_y, to_z}, 44, 4.0 / 3, 2, 5500));
}

std::vector<Eye> eyes_over_the_town()
{
    std::vector<Eye> eyes;
    for (const double high : {30.0, 78.0, 150.0})
        for (int turn = 0; turn < 12; ++turn)
            for (const double out : {0.0, 150.0, 300.0}) {
                const double s = std::sin(turn * 0.5236), c = std::cos(turn * 0.5236);
                eyes.push_back(eye_at(out * s, high, out * c, (out - 100) * s, high - 25, (out - 100) * c));
            }
    return eyes;
}

}  // namespace

TEST(Town, GroundHasTheHeightOfTheTriangleThatIsDrawnThere)
{
    for (const SurfaceKind layer :
         {SurfaceKind::land, SurfaceKind::furrows, SurfaceKind::paving, SurfaceKind::cobbles, SurfaceKind::water}) {
        for (const Piece &piece : the_town().pieces().all()) {
            if (piece.kind != Piece::Kind::ground) continue;
            for (const Span &span : piece.spans) {
                if (span.layer != layer) continue;
                const Geometry &g = the_town().pieces().on(layer);
                for (uint32_t i = span.first; i < span.first + span.count; i += 3) {
                    double x = 0, y = 0, z = 0;  // weights that put the point in one triangle alone
                    for (uint32_t k = 0; k < 3; ++k) {
                        const Vec3 p = g.vertices()[g.indices()[i + k]].position;
                        const double weight = k == 0 ? 0.5 : k == 1 ? 0.3 : 0.2;
                        x += weight * p.x, y += weight * p.y, z += weight * p.z;
                    }
                    ASSERT_NEAR(the_town().height(x, z), y, 0.001) << x << ' ' << z;
                }
            }
        }
    }
}

TEST(Town, HousesStandOnTheGroundWithEveryLowestCorner)
{
    for (const House &house : the_town().houses()) {
        for (const double a : {-0.5, 0.0, 0.5})
            for (const double o : {-0.5, 0.5}) {
                const Point p = house.site().ground(a * house.width_m, o * house.depth_m);
                double lowest = 1e9;  // of the walls there
                for (const Piece &piece : the_town().pieces().all()) {
                    const double dx = piece.sphere.centre.x - house.at.x, dz = piece.sphere.centre.z - house.at.z;
                    if (piece.kind != Piece::Kind::house || dx * dx + dz * dz > 9) continue;
                    each_vertex(piece, [&](Vec3 v, SurfaceKind) {
                        if (std::abs(v.x - p.x) < 0.01 && std::abs(v.z - p.z) < 0.01)
                            lowest = std::min(lowest, static_cast<double>(v.y));
                    });
                }
                ASSERT_NEAR(lowest, the_town().height(p.x, p.z), 0.05) << "house " << house.number;
            }
    }
}

TEST(Town, NoStandingPieceFloats)
{
    for (const Piece &piece : the_town().pieces().all()) {
        if (piece.kind == Piece::Kind::ground || piece.kind == Piece::Kind::shade) continue;
        double least = 1e9;  // above the ground, of all its vertices
        each_vertex(piece, [&](Vec3 v, SurfaceKind) { least = std::min(least, v.y - the_town().height(v.x, v.z)); });
        ASSERT_LT(least, 0.05) << piece.sphere.centre.x << ' ' << piece.sphere.centre.z;
    }
}

TEST(Town, ShadowsLieOnTheGround)
{
    for (const Piece &piece : the_town().pieces().all()) {
        if (piece.kind != Piece::Kind::shade) continue;
        each_vertex(piece, [&](Vec3 v, SurfaceKind) {
            ASSERT_NEAR(v.y, the_town().height(v.x, v.z), 0.02) << v.x << ' ' << v.z;
        });
    }
}

TEST(Town, SpheresHoldTheirPieces)
{
    for (const Piece &piece : the_town().pieces().all())
        each_vertex(piece, [&](Vec3 v, SurfaceKind) {
            const double x = v.x - piece.sphere.centre.x, y = v.y - piece.sphere.centre.y,
                         z = v.z - piece.sphere.centre.z;
            ASSERT_LE(std::sqrt(x * x + y * y + z * z), piece.sphere.radius * 1.00001);
        });
}

TEST(Town, PiecesAreEveryTriangleOnce)
{
    std::map<SurfaceKind, std::vector<uint8_t>> covered;
    for (const Piece &piece : the_town().pieces().all())
        for (const Span &span : piece.spans) {
            std::vector<uint8_t> &flags = covered[span.layer];
            flags.resize(the_town().pieces().on(span.layer).indices().size());
            for (uint32_t i = span.first; i < span.first + span.count; ++i) ++flags[i];
        }
    for (size_t layer = 0; layer < surface_kind_count; ++layer) {
        const std::vector<uint8_t> &flags = covered[static_cast<SurfaceKind>(layer)];
        EXPECT_EQ(flags.size(), the_town().pieces().on(static_cast<SurfaceKind>(layer)).indices().size());
        EXPECT_TRUE(std::all_of(flags.begin(), flags.end(), [](uint8_t times) { return times == 1; })) << layer;
    }
}

TEST(Town, NoTriangleIsWithoutArea)
{
    for (size_t layer = 0; layer < surface_kind_count; ++layer) {
        const Geometry &g = the_town().pieces().on(static_cast<SurfaceKind>(layer));
        for (size_t i = 0; i < g.indices().size(); i += 3) {
            const auto at = [&](size_t k) { return g.vertices()[g.indices()[i + k]].position; };
            ASSERT_GT(twice_area(at(0), at(1), at(2)), 1e-5)
                << layer << ": " << at(0).x << ' ' << at(0).y << ' ' << at(0).z;
        }
    }
}

TEST(Town, CullingLeavesOutNoPieceWithAVertexInThePicture)
{
    for (const float share : {1.0f, 0.6f}) {
        size_t left_out = 0;
        for (const Eye &eye : eyes_over_the_town()) {
            const Frustum cull(eye, share);
            for (const Piece &piece : the_town().pieces().all()) {
                if (cull.meets(piece.sphere)) continue;
                ++left_out;
                each_vertex(piece, [&](Vec3 v, SurfaceKind) {
                    double clip[4];
                    const double in[4] = {v.x, v.y, v.z, 1};
                    double seen[4] = {};
                    for (size_t r = 0; r < 4; ++r)
                        for (size_t c = 0; c < 4; ++c) seen[r] += eye.view[4 * c + r] * in[c];
                    for (size_t r = 0; r < 4; ++r) {
                        clip[r] = 0;
                        for (size_t c = 0; c < 4; ++c) clip[r] += eye.projection[4 * c + r] * seen[c];
                    }
                    const double w = clip[3] * share * 0.9999;
                    ASSERT_FALSE(clip[3] > 2 && std::abs(clip[0]) < w && std::abs(clip[1]) < w &&
                                 std::abs(clip[2]) < clip[3] * 0.9999);
                });
            }
        }
        EXPECT_GT(left_out, 10000u);
    }
}

TEST(Town, IsAtMostThirtyThousandTrianglesOnScreen)
{
    Pieces::Choice choice;
    for (const Eye &eye : eyes_over_the_town()) {
        const Frustum cull(eye);
        const size_t all = the_town().pieces().choose(nullptr, eye.position, choice);
        const size_t seen = the_town().pieces().choose(&cull, eye.position, choice);
        EXPECT_LE(seen, 30000u);
        EXPECT_LT(seen, all);
    }
}

TEST(Town, HousesDoNotOverlapOrStandOnStreets)
{
    const std::vector<House> &houses = the_town().houses();
    EXPECT_GE(houses.size(), 60u);
    EXPECT_LE(houses.size(), 140u);
    for (const House &a : houses)
        for (const House &b : houses) {
            if (&a == &b) continue;
            for (const double s : {-0.5, 0.0, 0.5})
                for (const double t : {-0.5, 0.0, 0.5}) {
                    const Point p = a.site().ground(s * a.width_m, t * a.depth_m);
                    const double x = p.x - b.at.x, z = p.z - b.at.z;
                    const bool inside = std::abs(x * b.out.x + z * b.out.z) < b.depth_m / 2 &&
                                        std::abs(x * b.out.z - z * b.out.x) < b.width_m / 2;
                    ASSERT_FALSE(inside) << a.number << " in " << b.number;
                }
        }
    const Plan &plan = the_town().plan();
    for (const House &house : houses)
        for (const Street &street : plan.streets())
            for (double along = std::max(street.first, -300.0); along < std::min(street.last, 300.0); along += 1) {
                const Point p = street.direction == Street::Direction::south ? plan.at(street.at, along)
                                                                             : plan.at(along, street.at);
                const double x = p.x - house.at.x, z = p.z - house.at.z;
                const double clear = 0.66 * street.half_width;  // the roadway: steps may reach over the pavement
                ASSERT_FALSE(std::abs(x * house.out.x + z * house.out.z) < house.depth_m / 2 + clear &&
                             std::abs(x * house.out.z - z * house.out.x) < house.width_m / 2)
                    << house.number;
            }
}

TEST(Town, IsTheSameEachTimeAndAnotherWithAnotherSeed)
{
    const Town again(1), other(2);
    for (size_t layer = 0; layer < surface_kind_count; ++layer) {
        const auto bytes = [&](const Town &t) {
            const std::vector<SceneryVertex> &v = t.pieces().on(static_cast<SurfaceKind>(layer)).vertices();
            const uint8_t *first = reinterpret_cast<const uint8_t *>(v.data());
            return hash_of({first, first + v.size() * sizeof(SceneryVertex)});
        };
        EXPECT_EQ(bytes(the_town()), bytes(again)) << layer;
        EXPECT_NE(bytes(the_town()), bytes(other)) << layer;
    }
}
