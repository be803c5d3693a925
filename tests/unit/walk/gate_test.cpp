// A gate that was measured in another year and place than the bottleneck by which the hurried gap was chosen (run
// 040_c_56_h-, Wuppertal 2018): 75 people stand in a corridor 5.6 m wide and leave by a gate 0.5 m wide.
#include <claque/trajectories.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/collected_file.h"
#include "tests/unit/walk/floors.h"

namespace
{

constexpr double gate_m = 0.5, corridor_m = 5.6;

struct Standing {
    double x, y;
};

// People a second from the first tenth to the last; times ascend.
double rate_of(std::vector<double> times_s)
{
    std::sort(times_s.begin(), times_s.end());
    const size_t first = times_s.size() / 10, last = times_s.size() * 9 / 10 - 1;
    return double(last - first) / (times_s[last] - times_s[first]);
}

// Where all stand at first, and when each passes the gate, at y = 0.
void read_gate(const std::string &file, std::vector<Standing> &people, std::vector<double> &passed_s)
{
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
    clq_trajectories *read = nullptr;
    ASSERT_EQ(clq_trajectories_load(context, file.c_str(), nullptr, &read), CLQ_OK) << clq_last_error();
    clq_trajectories_info info = clq_trajectories_info_init();
    ASSERT_EQ(clq_trajectories_get_info(read, &info), CLQ_OK);
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(read);
    for (uint32_t i = 0; i < info.person_count; ++i) {
        clq_trajectory_person person = clq_trajectory_person_init();
        ASSERT_EQ(clq_trajectories_get_person(read, i, &person), CLQ_OK);
        const clq_trajectory_sample *own = samples + person.first_sample;
        people.push_back({own[0].x, own[0].y});
        for (uint64_t k = 1; k < person.sample_count; ++k)
            if (own[k - 1].y > 0 && own[k].y <= 0) {
                passed_s.push_back(own[k].time_s);
                break;
            }
    }
    clq_trajectories_destroy(read);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

// Walkers with bodies of a radius, on ground that is made for them.
std::vector<double> walked(const std::vector<Standing> &people, float radius_m)
{
    floors::Floor floor;
    floor.add(-corridor_m / 2, -9, corridor_m / 2, 9);
    floor.wall(-corridor_m / 2, 0, -gate_m / 2, 0.2);
    floor.wall(gate_m / 2, 0, corridor_m / 2, 0.2);
    floor.radius_m = std::min(radius_m, 0.2f), floor.cell_m = 0.04f;
    clq_walkers_def def = clq_walkers_def_init();
    def.time_gap_s = CLQ_HURRIED_TIME_GAP_S;
    const floors::Held held(floor, &def);
    std::vector<clq_walker> inside;
    for (const Standing &one : people) {
        inside.push_back(held.add(one.x, -one.y, nullptr, radius_m));
        held.go(inside.back(), 0, 8, 0.5f);
    }
    std::vector<clq_walker> outside;
    std::vector<double> passed_s;
    const auto is_behind = [&](clq_walker one, double z) { return held.info(one).position[2] > z; };
    for (int tick = 0; tick < 6000 && !inside.empty(); ++tick) {
        held.step();
        for (size_t i = inside.size(); i-- > 0;) {
            if (!is_behind(inside[i], 0)) continue;
            passed_s.push_back(0.05 * tick);
            outside.push_back(inside[i]);
            inside.erase(inside.begin() + static_cast<ptrdiff_t>(i));
        }
        for (size_t i = outside.size(); i-- > 0;) {
            if (!is_behind(outside[i], 4)) continue;
            EXPECT_EQ(clq_walkers_remove(held.walkers, outside[i]), CLQ_OK);
            outside.erase(outside.begin() + static_cast<ptrdiff_t>(i));
        }
    }
    return passed_s;
}

}  // namespace

TEST(GateOfOnePerson, LetsAsManyHurriedPeopleThroughAsWereMeasured)
{
    const std::string file = std::string(CLAQUE_ASSETS_DIR) + "/tracks/pedpy/040_c_56_h-.txt";
    CLAQUE_NEEDS_FILE(file);
    std::vector<Standing> people;
    std::vector<double> measured_s;
    read_gate(file, people, measured_s);
    ASSERT_EQ(people.size(), 75u);
    ASSERT_EQ(measured_s.size(), 75u);
    const std::vector<double> slim = walked(people, CLQ_HURRIED_RADIUS_M), wide = walked(people, 0.22f);
    const double measured = rate_of(measured_s);
    std::printf("gate of %g m: bodies of %g m %.2f people a second, of 0.22 m %.2f, %.2f were measured\n", gate_m,
                double(CLQ_HURRIED_RADIUS_M), rate_of(slim), rate_of(wide), measured);
    ASSERT_EQ(slim.size(), people.size());
    EXPECT_NEAR(rate_of(slim), measured, 0.25 * measured);
    // Bodies that do not turn nearly fill the gate. The guide says so; nobody is stuck.
    EXPECT_EQ(wide.size(), people.size());
    EXPECT_LT(rate_of(wide), rate_of(slim));
}
