// Vehicles of SUMO are boxes of their size, and who rides in one sits on a seat of its own inside of it.
#include "samples/scenes/walkers/vehicles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

namespace
{

using namespace scenes;
using namespace scenes::walkers;

constexpr int seconds = 12;
constexpr double speed_m_s = 4;

// A car goes north with one rider, a bus goes east with seven, of whom two board after four seconds on the seats of two
// that left; the riders are where their vehicle's front is. One person walks.
class Riders : public testing::Test
{
protected:
    Riders() : library_(1), file_(testing::TempDir() + "riders.fcd.xml")
    {
        std::ofstream out(file_);
        out << "<fcd-export>\n";
        for (int t = 0; t < seconds; ++t) {
            out << "<timestep time=\"" << t << "\">";
            const auto row = [&](const char *kind, const std::string &id, double x, double y, int angle) {
                out << '<' << kind << " id=\"" << id << "\" x=\"" << x << "\" y=\"" << y << "\" angle=\"" << angle
                    << "\" speed=\"" << speed_m_s << "\"/>";
            };
            row("vehicle", "car", 50, speed_m_s * t, 0), row("vehicle", "bus", speed_m_s * t, 20, 90);
            row("person", "driven", 50, speed_m_s * t, 0);
            for (int i = 0; i < 7; ++i)
                if (i < 3 || (i < 5 ? t < 4 : t >= 4)) row("person", "r" + std::to_string(i), speed_m_s * t, 20, 90);
            out << "<person id=\"walks\" x=\"" << 30 + 1.2 * t << "\" y=\"10\" angle=\"90\" speed=\"1.2\"/>"
                << "</timestep>\n";
        }
        out << "</fcd-export>\n";
        out.close();
        options_.file = file_, options_.reading.vehicles = true;
        trajectories_ = load(library_, options_);
        plan_ = plan_of(trajectories_.get(), options_);
        cast_.push_back(cast(library_, class_of("citizen"), Lod::off));
        people_.emplace(library_, trajectories_.get(), plan_, cast_, 1);
        vehicles_.emplace(trajectories_.get(), plan_, people_->all());
    }
    size_t number_of(const std::string &id) const
    {
        for (size_t i = 0; i < people_->all().size(); ++i)
            if (people_->all()[i].id == id) return i;
        ADD_FAILURE() << id;
        return 0;
    }
    // How far ahead of the front of a vehicle, and to its right, in the world's axes.
    std::array<double, 2> inside(const std::string &vehicle, const std::string &rider, double time_s) const
    {
        const Vehicles::Stand at = vehicles_->at(number_of(rider), time_s);
        const double east = at.position[0] + plan_.x, north = plan_.y - at.position[2];
        if (vehicle == "car") return {north - speed_m_s * time_s, east - 50};
        return {east - speed_m_s * time_s, 20 - north};
    }

    Library library_;
    std::string file_;
    Options options_;
    OwnTrajectories trajectories_;
    Plan plan_;
    std::vector<Member> cast_;
    std::optional<People> people_;
    std::optional<Vehicles> vehicles_;
};

TEST_F(Riders, AreOfThreeKindsByTheirIds)
{
    using Kind = Person::Kind;
    for (const auto &[id, kind] : {std::pair("car", Kind::vehicle),
                                   {"bus", Kind::vehicle},
                                   {"driven", Kind::rides},
                                   {"r6", Kind::rides},
                                   {"walks", Kind::walks}})
        EXPECT_EQ(people_->all()[number_of(id)].kind, kind) << id;
    size_t tracks = 0;
    for (const Person &person : people_->take([](size_t, size_t) {})) tracks += person.track != nullptr;
    EXPECT_EQ(tracks, 1u);
}

TEST_F(Riders, SitOnSeatsOfTheirOwnInTheirVehicle)
{
    for (const double time_s : {0.0, 2.3, 3.0, 4.0, 7.75, 11.0}) {
        const auto driven = inside("car", "driven", time_s);
        EXPECT_TRUE(driven[0] < -0.5 && driven[0] > -4.5) << driven[0];
        EXPECT_LT(std::fabs(driven[1]), 0.7);
        std::vector<std::array<double, 2>> seats;
        for (int i = 0; i < 7; ++i) {
            if (i >= 3 && (i < 5) != (time_s < 4)) continue;
            seats.push_back(inside("bus", "r" + std::to_string(i), time_s));
            EXPECT_TRUE(seats.back()[0] < -1 && seats.back()[0] > -11) << seats.back()[0];
            EXPECT_LT(std::fabs(seats.back()[1]), 1.1);
        }
        ASSERT_EQ(seats.size(), 5u);
        for (size_t a = 0; a < seats.size(); ++a)
            for (size_t b = 0; b < a; ++b)
                EXPECT_GT(std::hypot(seats[a][0] - seats[b][0], seats[a][1] - seats[b][1]), 0.45) << time_s;
    }
    // Who stays keeps the seat.
    const auto early = inside("bus", "r1", 1), late = inside("bus", "r1", 10);
    EXPECT_NEAR(early[0], late[0], 1e-5);
    EXPECT_NEAR(early[1], late[1], 1e-5);
}

TEST_F(Riders, AreInBoxesOfTheSizesOfSumo)
{
    vehicles_->place(5);
    struct Extent {
        double low = HUGE_VAL, high = -HUGE_VAL;
        void add(double value) { low = std::min(low, value), high = std::max(high, value); }
    } car[3], bus[3];
    for (const SceneryVertex &vertex : vehicles_->boxes().vertices()) {
        const double east = double(vertex.position.x) + plan_.x, north = plan_.y - double(vertex.position.z);
        Extent *const extents = east > 35 ? car : bus;
        extents[0].add(east), extents[1].add(north), extents[2].add(double(vertex.position.y));
    }
    const auto expect = [](const Extent &extent, double low, double high) {
        EXPECT_NEAR(extent.low, low, 1e-4);
        EXPECT_NEAR(extent.high, high, 1e-4);
    };
    expect(car[0], 50 - 0.9, 50 + 0.9), expect(car[1], 20 - 5.0, 20), expect(car[2], 0, 1.5);
    expect(bus[0], 20 - 12.0, 20), expect(bus[1], 20 - 1.25, 20 + 1.25), expect(bus[2], 0, 3.4);
    vehicles_->place(seconds + 1);
    EXPECT_TRUE(vehicles_->boxes().vertices().empty());
}

// Drawn or not: the scene has an actor for each person and none for a vehicle, whichever time was shown before.
TEST_F(Riders, AreActorsWithoutTheirVehicles)
{
    CrowdOptions crowd_options;
    crowd_options.as_shown = true;
    const auto scene = make(library_, crowd_options, options_);
    EXPECT_EQ(scene->actors().size(), 1u + 1 + 7);
    const auto head = [&](Scene &of, size_t actor, double time_s) {
        of.place(time_s);
        check(clq_crowd_update(of.crowd(), time_s, nullptr, 0));
        double matrix[16];
        const uint32_t node = clq_template_find_node(of.templates().front(), "head");
        check(clq_actor_get_node(of.crowd(), of.actors()[actor], node, time_s, matrix));
        return std::array<double, 3>{matrix[12], matrix[13], matrix[14]};
    };
    const auto again = make(library_, crowd_options, options_);
    const auto there = head(*scene, 0, 7.5);
    for (const double time_s : {11.5, 0.0, 3.0}) (void)head(*again, 0, time_s);
    EXPECT_EQ(head(*again, 0, 7.5), there);
    EXPECT_NEAR(there[0] + plan_.x, 50, 0.6);
    EXPECT_NEAR(plan_.y - there[2], 7.5 * speed_m_s - 2.3, 0.9);
    EXPECT_GT(there[1], 0.9);
    EXPECT_LT(there[1], 1.35) << "sits";
}

}  // namespace
