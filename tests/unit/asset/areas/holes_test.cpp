// Random rooms with many obstacles against what is known without triangles: their areas by cells, and a place in each
// obstacle.
#include <algorithm>

#include "fixture.h"
#include "lib/base/hash.h"

namespace claque::testing
{
namespace
{

// Obstacles lie in cells of their own, so they touch each other and the walls at corners and at middles of sides.
struct Room {
    std::vector<asset::Ring> rings;
    std::vector<asset::Point> solid;  // a place in each obstacle
    double area_m2 = 0;
};

class RoomMaker
{
public:
    explicit RoomMaker(uint64_t seed) : seed_(seed) {}

    Room make()
    {
        const int side = 3 + static_cast<int>(below(6));
        const double s = side;
        Room room;
        room.area_m2 = s * s;
        room.rings.push_back({{0, 0}, {s / 2, 0}, {s, 0}, {s, s}, {0, s}});
        const uint64_t some = 1 + below(3);
        for (int x = 0; x < side; ++x)
            for (int y = 0; y < side; ++y)
                if (below(3) < some) add_obstacle(room, x, y);
        for (asset::Ring &ring : room.rings)
            if (below(2)) std::reverse(ring.begin(), ring.end());
        return room;
    }

private:
    uint64_t below(uint64_t limit) { return base::hash(seed_, thrown_++, base::Purpose::pick) % limit; }

    void add_obstacle(Room &room, double x, double y)
    {
        switch (below(4)) {
            case 0:  // touches four cells
                room.rings.push_back({{x + 0.5, y}, {x + 1, y + 0.5}, {x + 0.5, y + 1}, {x, y + 0.5}});
                room.area_m2 -= 0.5;
                break;
            case 1:  // touches the cell above, to the right
                room.rings.push_back({{x + 0.25, y + 0.25}, {x + 1, y + 1}, {x + 0.25, y + 0.75}});
                room.area_m2 -= 0.1875;
                break;
            case 2:  // touches the cell above, to the left
                room.rings.push_back({{x, y + 1}, {x + 0.25, y + 0.5}, {x + 0.5, y + 0.25}, {x + 0.75, y + 0.5}});
                room.area_m2 -= 0.1875;
                break;
            default:  // with points on straight ways
                room.rings.push_back({{x + 0.25, y + 0.25},
                                      {x + 0.5, y + 0.25},
                                      {x + 0.75, y + 0.25},
                                      {x + 0.75, y + 0.75},
                                      {x + 0.25, y + 0.75},
                                      {x + 0.25, y + 0.5}});
                room.area_m2 -= 0.25;
        }
        room.solid.push_back({x + 0.4375, y + 0.5});
    }

    uint64_t seed_, thrown_ = 0;
};

// Where a room lies: turned, then moved as far along x as a map may have it.
struct Pose {
    double angle, moved_m;

    asset::Point of(const asset::Point &p) const
    {
        return {p.x * std::cos(angle) - p.y * std::sin(angle) + moved_m, p.x * std::sin(angle) + p.y * std::cos(angle)};
    }
};

TEST(AreaHoles, OfRandomRoomsStayFreeAndTheRestIsFilledOnce)
{
    size_t obstacles = 0;
    for (uint64_t seed = 0; seed < 100; ++seed)
        for (const Pose &pose : {Pose{0, 0}, Pose{0.3, 0}, Pose{1.1, 0}, Pose{0.3, 1e3}, Pose{1.1, 5e5}}) {
            SCOPED_TRACE(
                base::text_of("room %d turned by %g, moved by %g m", static_cast<int>(seed), pose.angle, pose.moved_m));
            Room room = RoomMaker(seed).make();
            for (asset::Ring &ring : room.rings)
                for (asset::Point &p : ring) p = pose.of(p);
            asset::AreaBuilder builder;
            ASSERT_NO_THROW(builder.add_polygon(room.rings));
            const asset::Area area = builder.take();
            EXPECT_NEAR(area.area_m2, room.area_m2, (1e-12 + 4e-16 * pose.moved_m) * area.points.size());
            expect_filled(area);
            for (const asset::Point &p : room.solid) {
                const asset::Point at = pose.of(p);
                EXPECT_EQ(triangles_at(area, at.x, at.y), 0u);
            }
            obstacles += room.solid.size();
        }
    EXPECT_GT(obstacles, 5000u);
}

// The second obstacle lies below a place where the first one touches a wall, or shares a corner and a side with two.
TEST(AreaHoles, OfObstaclesOnWallsAreJoinedUnderBoth)
{
    const std::vector<asset::Ring> below{
        {{0, 0}, {7, 0}, {7, 7}, {0, 7}}, {{2.25, 6.75}, {3, 7}, {2.25, 6.25}}, {{4, 1}, {3, 1}, {3, 2}}};
    const std::vector<asset::Ring> beside{
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {0, 1}, {1, 1}}, {{1, 0.5}, {1.5, 1}, {2, 0.5}, {1.5, 0}}};
    asset::AreaBuilder builder;
    builder.add_polygon(below);
    asset::Area area = builder.take();
    EXPECT_EQ(area.area_m2, 49 - 0.1875 - 0.5);
    expect_filled(area);
    asset::AreaBuilder other;
    other.add_polygon(beside);
    area = other.take();
    EXPECT_EQ(area.area_m2, 16 - 0.5 - 0.5);
    expect_filled(area);
}

// Where obstacles meet, the way to one may begin in more than one corner of the outline, but for rounding.
TEST(AreaHoles, ThatMeetAtOnePlaceAreJoinedHoweverTheRoomIsTurned)
{
    const std::vector<asset::Ring> room{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{0, 4}, {1, 5}, {3, 5}, {2, 4}},
                                        {{3, 2}, {4, 4}, {2, 4}, {6, 5}}, {{6, 6}, {6, 5}, {5, 5}, {5, 6}},
                                        {{5, 3}, {5, 2}, {4, 3}},         {{8, 5}, {7, 4}, {6, 5}}};
    for (int i = 0; i < 200; ++i) {
        const Pose pose{0.0314 * i, 0};
        SCOPED_TRACE(base::text_of("turned by %g", pose.angle));
        std::vector<asset::Ring> rings = room;
        for (asset::Ring &ring : rings)
            for (asset::Point &p : ring) p = pose.of(p);
        asset::AreaBuilder builder;
        ASSERT_NO_THROW(builder.add_polygon(rings));
        const asset::Area area = builder.take();
        EXPECT_NEAR(area.area_m2, 81 - 2 - 2.5 - 1 - 0.5 - 1, 1e-10);
        expect_filled(area);
    }
}

TEST(AreaHoles, HoldIslandsWithHolesThatHoldIslands)
{
    const asset::Area area = read_area_text(
        "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9), (1 1, 8 1, 8 8, 1 8)), ((2 2, 7 2, 7 7, 2 7), (3 3, 6 3, 6 6, 3 6)), "
        "((4 4, 5 4, 5 5, 4 5)))");
    EXPECT_EQ(area.polygons, 3u);
    EXPECT_EQ(area.area_m2, 81 - 49 + 25 - 9 + 1);
    expect_filled(area);
}

}  // namespace
}  // namespace claque::testing
