// Omnibuses keep to their lane, stand on the ground, hold their passengers, and move as groups.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/scene_renderer.h"
#include "samples/scenes/town/passengers.h"

namespace
{

using namespace scenes;
using namespace scenes::town;

const Town &the_omnibus_town()
{
    static const Town built(1);
    return built;
}

const VehiclePath &path()
{
    static const VehiclePath way(the_omnibus_town().plan(), the_omnibus_town().terrain(), Omnibus::wheelbase_m,
                                 Omnibus::half_track_m);
    return way;
}

double from_axis(Point p)
{
    const Plan &plan = the_omnibus_town().plan();
    double nearest = 1e9;
    for (const Street &street : plan.streets())
        for (double along = std::max(street.first, -300.0); along < std::min(street.last, 300.0); along += 0.25) {
            const Point q =
                street.direction == Street::Direction::south ? plan.at(street.at, along) : plan.at(along, street.at);
            nearest = std::min(nearest, std::hypot(p.x - q.x, p.z - q.z));
        }
    return nearest;
}

SceneOptions options(uint64_t seed = 1)
{
    SceneOptions o;
    o.scene = "vehicle";
    o.crowd_options.count = 60;
    o.crowd_options.seed = seed;
    o.width = 320, o.height = 240;
    return o;
}

}  // namespace

TEST(Omnibus, KeepsToTheStreetOnItsRightHandSide)
{
    double sum = 0, count = 0;
    for (double metres = 0; metres < path().length_m(); metres += 3) {
        const double away = from_axis(path().point(metres));
        ASSERT_LT(away, 3.0) << "at " << metres;  // half the roadway less half an omnibus, and cut corners
        sum += away, ++count;
    }
    EXPECT_NEAR(sum / count, VehiclePath::lane_m, 0.25);
}

TEST(Omnibus, GoesRoundWithoutAJumpInPlaceOrHeading)
{
    for (double metres = 0; metres < path().length_m() + 1; metres += 0.1) {
        const VehiclePose a = path().at(metres), b = path().at(metres + 0.1);
        const double moved = std::hypot(b.position[0] - a.position[0], b.position[2] - a.position[2]);
        ASSERT_NEAR(moved, 0.1, 0.02) << "at " << metres;
        ASSERT_GT(a.forward[0] * b.forward[0] + a.forward[1] * b.forward[1] + a.forward[2] * b.forward[2], 0.999);
    }
    const VehiclePose first = path().at(7), round = path().at(7 + path().length_m());
    EXPECT_NEAR(first.position[0], round.position[0], 1e-6);
    EXPECT_NEAR(first.position[2], round.position[2], 1e-6);
}

TEST(Omnibus, StandsOnItsWheels)
{
    for (double metres = 0; metres < path().length_m(); metres += 5) {
        const VehiclePose s = path().at(metres);
        for (const double ahead : {-0.5, 0.5})
            for (const double aside : {-1.0, 1.0}) {
                double p[3];
                for (size_t i = 0; i < 3; ++i)
                    p[i] = s.position[i] + ahead * Omnibus::wheelbase_m * s.forward[i] +
                           aside * Omnibus::half_track_m * s.right_hand_x[i];
                ASSERT_NEAR(p[1], the_omnibus_town().height(p[0], p[2]), 0.05) << "at " << metres;
            }
    }
}

TEST(Omnibus, TurnsAsItsOrientationAndItsMatrixSay)
{
    for (double metres = 0; metres < path().length_m(); metres += 11) {
        const VehiclePose s = path().at(metres);
        const auto q = s.orientation_xyzw();
        const auto m = s.matrix();
        const double x = q[0], y = q[1], z = q[2], w = q[3];
        EXPECT_NEAR(x * x + y * y + z * z + w * w, 1, 1e-5);
        EXPECT_NEAR(m[8], 2 * (x * z + w * y), 1e-5);
        EXPECT_NEAR(m[9], 2 * (y * z - w * x), 1e-5);
        EXPECT_NEAR(m[10], 1 - 2 * (x * x + y * y), 1e-5);
        EXPECT_NEAR(m[5], 1 - 2 * (x * x + z * z), 1e-5);
    }
}

TEST(Omnibus, SphereHoldsBodyAndPeople)
{
    const Omnibus omnibus({1, 0, 0});
    const Sphere &s = omnibus.sphere();
    const auto away = [&](double x, double y, double z) {
        return std::sqrt((x - s.centre.x) * (x - s.centre.x) + (y - s.centre.y) * (y - s.centre.y) +
                         (z - s.centre.z) * (z - s.centre.z));
    };
    for (const SceneryVertex &v : omnibus.body().vertices())
        ASSERT_LE(away(v.position.x, v.position.y, v.position.z), s.radius);
    EXPECT_GE(Omnibus::seats().size(), 13u);
    for (const Omnibus::Seat &seat : Omnibus::seats())
        for (const double high : {0.0, 1.35})  // from a sitter's feet to its crown
            ASSERT_LE(away(seat.x, seat.y + high, seat.z), s.radius);
}

TEST(Omnibus, SeatsAreApart)
{
    const auto &seats = Omnibus::seats();
    for (size_t i = 0; i < seats.size(); ++i)
        for (size_t k = 0; k < i; ++k) {
            const double x = std::abs(seats[i].x - seats[k].x), z = std::abs(seats[i].z - seats[k].z);
            EXPECT_TRUE(x >= 0.65 || z >= 0.92) << i << ' ' << k;
        }
}

TEST(Omnibus, MovesItsPassengersAsOneGroup)
{
    Library library(1);
    CrowdOptions crowd_options;
    crowd_options.count = 60;
    Passengers people(library, crowd_options, the_omnibus_town());
    EXPECT_EQ(people.cast().actors().size(), 60u);
    people.drive(3);
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(people.crowd(), people.cast().actors()[0], &info));
    ASSERT_NE(info.group.index1, 0u);
    clq_group_info group = clq_group_info_init();
    check(clq_group_get_info(people.crowd(), info.group, &group));
    EXPECT_EQ(group.member_count,
              people.seated() / people.poses().size() + (people.seated() % people.poses().size() > 0));
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(group.transform.position[i], people.poses()[0].position[i]);
    EXPECT_FLOAT_EQ(static_cast<float>(info.transform.position[1]), static_cast<float>(Omnibus::floor_m));
}

TEST(Vehicle, IsTheSamePictureAtTheSameTimeAndAnotherWithAnotherSeed)
{
    Library library(1);
    SceneRenderer scene_renderer(library, options());
    const uint64_t first = hash_of(scene_renderer.picture(4));
    const uint64_t later = hash_of(scene_renderer.picture(5));
    EXPECT_NE(first, later);
    EXPECT_EQ(hash_of(scene_renderer.picture(4)), first);
    SceneRenderer again(library, options());
    EXPECT_EQ(hash_of(again.picture(4)), first);
    SceneRenderer other(library, options(2));
    EXPECT_NE(hash_of(other.picture(4)), first);
}
