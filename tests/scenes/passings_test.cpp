// Passings that are found for a stretch of time are those that are found among all people at once.
#include "samples/scenes/walkers/passings.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "samples/scenes/check.h"

namespace
{

using namespace scenes;
using namespace scenes::walkers;

constexpr int people = 120;

// Tracks across a small square for a few minutes. Some are long, and rows are not at even times.
std::string crossing()
{
    std::string text = "time,id,x,y\n";
    for (int i = 0; i < people; ++i) {
        const int rows = i % 10 == 0 ? 900 : 90;
        for (int k = 0; k < rows; ++k) {
            const double time_s = 2.9 * i + 0.31 * k, turn = 0.7 * i, along = 9 * std::sin(0.04 * k + i);
            char line[120];
            std::snprintf(line, sizeof line, "%.9f,%d,%.4f,%.4f\n", time_s, i, along * std::cos(turn),
                          along * std::sin(turn) + 0.4 * (i % 3));
            text += line;
        }
    }
    return text;
}

TEST(Passings, OfAStretchAreThoseAmongAllPeople)
{
    Library library(1);
    const std::string text = crossing();
    clq_trajectories_def def = clq_trajectories_def_init();
    def.format = CLQ_TRAJECTORY_TABLE, def.columns = "time,id,x,y", def.metres_per_unit = 1;
    clq_trajectories *loaded = nullptr;
    check(clq_trajectories_load_memory(library.context(), text.data(), text.size(), "square", &def, &loaded));
    const std::unique_ptr<clq_trajectories, void (*)(clq_trajectories *)> trajectories(loaded,
                                                                                       clq_trajectories_destroy);
    Plan plan;
    plan.start_s = -17.25;  // so that stretches begin at odd times of the file
    std::vector<std::vector<clq_track_point>> points;
    std::vector<clq_track_def> defs(people, clq_track_def_init());
    std::vector<const clq_track_def *> all;
    for (uint32_t i = 0; i < people; ++i) {
        const clq_trajectory_person person = person_of(loaded, i);
        points.push_back(points_of(person, clq_trajectories_get_samples(loaded), plan, 0, person.sample_count));
        defs[i].points = points[i].data(), defs[i].point_count = static_cast<uint32_t>(points[i].size());
        all.push_back(&defs[i]);
    }
    size_t count = 0;
    check(clq_find_passings(library.context(), all.data(), people, nullptr, 0, &count));
    std::vector<clq_found_passing> wanted(count);
    check(clq_find_passings(library.context(), all.data(), people, wanted.data(), count, &count));
    ASSERT_GT(count, 1000u);

    Passings passings(library, loaded, plan);
    size_t found = 0;
    for (const uint32_t turn : {7u, 1u})  // asked for in other orders; the second time they are known
        for (uint32_t k = 0; k < people; ++k) {
            const uint32_t i = k * turn % people;
            size_t at = 0;
            while (at < count && wanted[at].track != i) ++at;
            for (const clq_track_passing &one : passings.of(i)) {
                ASSERT_LT(at, count);
                ASSERT_EQ(wanted[at].track, i);
                EXPECT_EQ(one.time_s, wanted[at].passing.time_s);
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_EQ(one.position[axis], wanted[at].passing.position[axis]) << one.time_s;
                ++at, ++found;
            }
        }
    EXPECT_EQ(found, 2 * count);
}

}  // namespace
