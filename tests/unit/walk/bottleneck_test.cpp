// A bottleneck that was measured (Duesseldorf 2009, run AO_300): 348 people leave a hall by an opening of 3 m. Walkers
// in the same hall, which come where and when the people came, are counted on the same line.
#include <claque/trajectories.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/collected_file.h"
#include "tests/unit/walk/floors.h"

namespace
{

constexpr double opening_m = 3.0;  // from x -0.6 to 2.4, and 1.06 m deep; the line y = 0 is in its middle

struct Person {
    double from_s;
    double x, y;
};

struct Measured {
    std::vector<Person> people;
    std::vector<double> crossings_s;
};

// People per second and metre while the opening is full: from the first tenth to the last.
double flow_of(std::vector<double> crossings_s)
{
    std::sort(crossings_s.begin(), crossings_s.end());
    const size_t first = crossings_s.size() / 10, last = crossings_s.size() * 9 / 10 - 1;
    return double(last - first) / (crossings_s[last] - crossings_s[first]) / opening_m;
}

class Bottleneck : public testing::Test
{
protected:
    void SetUp() override
    {
        CLAQUE_NEEDS_FILE(folder_);
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        read_people();
        read_hall();
    }
    ~Bottleneck() override
    {
        if (context_) {
            EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
        }
    }
    void read_people()
    {
        clq_trajectories *read = nullptr;
        ASSERT_EQ(clq_trajectories_load(context_, (folder_ + "/traj.txt").c_str(), nullptr, &read), CLQ_OK)
            << clq_last_error();
        clq_trajectories_info info = clq_trajectories_info_init();
        ASSERT_EQ(clq_trajectories_get_info(read, &info), CLQ_OK);
        const clq_trajectory_sample *samples = clq_trajectories_get_samples(read);
        for (uint32_t i = 0; i < info.person_count; ++i) {
            clq_trajectory_person person = clq_trajectory_person_init();
            ASSERT_EQ(clq_trajectories_get_person(read, i, &person), CLQ_OK);
            const clq_trajectory_sample *own = samples + person.first_sample;
            measured_.people.push_back({own[0].time_s, own[0].x, own[0].y});
            for (uint64_t k = 1; k < person.sample_count; ++k)
                if (own[k - 1].y < 0 && own[k].y >= 0) {
                    measured_.crossings_s.push_back(own[k].time_s);
                    break;
                }
        }
        clq_trajectories_destroy(read);
    }
    void read_hall()
    {
        clq_area *area = nullptr;
        ASSERT_EQ(clq_area_load(context_, (folder_ + "/geo.xml").c_str(), &area), CLQ_OK) << clq_last_error();
        clq_area_info found = clq_area_info_init();
        ASSERT_EQ(clq_area_get_info(area, &found), CLQ_OK);
        for (uint32_t i = 0; i < found.point_count; ++i)
            for (const double x : {found.points_m[3 * i], found.points_m[3 * i + 2], -found.points_m[3 * i + 1]})
                hall_.vertices.push_back(x);
        hall_.triangles.assign(found.triangles, found.triangles + 3 * size_t(found.triangle_count));
        clq_area_destroy(area);
    }
    std::vector<double> simulated(float time_gap_s, float radius_m) const;

    const std::string folder_ = std::string(CLAQUE_ASSETS_DIR) + "/tracks/pedpy/ref-bottleneck";
    clq_context *context_ = nullptr;
    Measured measured_;
    floors::Floor hall_;
};

std::vector<double> Bottleneck::simulated(float time_gap_s, float radius_m) const
{
    clq_walkers_def def = clq_walkers_def_init();
    def.time_gap_s = time_gap_s;
    floors::Floor hall = hall_;
    hall.radius_m = radius_m;
    const floors::Held held(hall, &def);
    struct Walking {
        clq_walker id;
        double y;
        bool crossed;
    };
    std::vector<Walking> walking;
    std::vector<double> crossings_s;
    std::vector<Person> waiting = measured_.people;
    std::sort(waiting.begin(), waiting.end(), [](const Person &a, const Person &b) { return a.from_s < b.from_s; });
    size_t next = 0;
    for (int tick = 0; tick < 3000 && crossings_s.size() < waiting.size(); ++tick) {
        const double time_s = 0.05 * tick;
        for (; next < waiting.size() && waiting[next].from_s <= time_s; ++next) {
            const clq_walker id = held.add(waiting[next].x, -waiting[next].y, nullptr, radius_m);
            held.go(id, 0.9, -5.5, 0.5f);
            walking.push_back({id, waiting[next].y, false});
        }
        held.step();
        for (size_t i = 0; i < walking.size();) {
            Walking &one = walking[i];
            const double y = -held.info(one.id).position[2];
            if (!one.crossed && one.y < 0 && y >= 0) crossings_s.push_back(time_s + 0.05), one.crossed = true;
            one.y = y;
            if (y < 4.5) {
                ++i;
                continue;
            }
            EXPECT_EQ(clq_walkers_remove(held.walkers, one.id), CLQ_OK);
            walking.erase(walking.begin() + static_cast<ptrdiff_t>(i));
        }
    }
    return crossings_s;
}

}  // namespace

TEST_F(Bottleneck, LetsAsManyHurriedPeopleThroughAsWereMeasured)
{
    const std::vector<double> crossings_s = simulated(CLQ_HURRIED_TIME_GAP_S, CLQ_HURRIED_RADIUS_M);
    const double flow = flow_of(crossings_s), measured = flow_of(measured_.crossings_s);
    std::printf(
        "bottleneck: %.2f people a second and metre, %.2f were measured; the last of %zu after %.1f s, measured "
        "%.1f s\n",
        flow, measured, crossings_s.size(), *std::max_element(crossings_s.begin(), crossings_s.end()),
        *std::max_element(measured_.crossings_s.begin(), measured_.crossings_s.end()));
    EXPECT_EQ(crossings_s.size(), measured_.people.size());
    EXPECT_NEAR(flow, measured, 0.25 * measured);
    // Others need their time.
    const clq_walker_def other = clq_walker_def_init();
    EXPECT_LT(flow_of(simulated(clq_walkers_def_init().time_gap_s, other.radius_m)), 0.75 * measured);
}
