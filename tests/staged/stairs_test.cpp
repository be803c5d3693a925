// The stairs of a theatre: people walk on them as on a ramp, and their feet stand on the treads.
#include <cmath>

#include "samples/scenes/walkers/cast.h"
#include "samples/stage/ground.h"
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

struct DestroyWalkers {
    void operator()(clq_walkers *p) const { clq_walkers_destroy(p); }
};

struct Steps {
    int on_treads = 0, beside = 0;
    double highest = 0, farthest_off = 0;
};

// A person goes up the middle stairs and comes down again.
class StairsOfATheatre : public testing::Test
{
protected:
    StairsOfATheatre()
        : scenario_(load_scenario(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/odeon-evening.toml")),
          setting_(staged::make_setting(library_, scenario_, 1)),
          navigation_(staged::make_navigation(*setting_, *scenario_.stage)),
          member_(walkers::cast(library_, scenario_.characters[0], Lod::off, walkers::Heads::still))
    {
    }

    Steps climb(bool knows_stone)
    {
        const staged::Setting::Stone stone = setting_->stone();
        clq_walkers_def def = clq_walkers_def_init();
        def.smooth_s = 0.3f;
        if (knows_stone) def.ground = stone.height, def.ground_user = stone.user;
        clq_walkers *made = nullptr;
        check(clq_walkers_create(navigation_.get(), &def, &made));
        const std::unique_ptr<clq_walkers, DestroyWalkers> walkers(made);
        clq_walker_def one = clq_walker_def_init();
        one.locomotion = member_.locomotion.get(), one.radius_m = 0.16f, one.scale = static_cast<float>(member_.scale);
        one.position[2] = -5;
        clq_walker walker = {};
        check(clq_walkers_add(made, &one, &walker));
        Steps steps;
        for (const double goal : {-13.3, -5.0}) {
            const double place[3] = {0, goal < -10 ? 4.3 : 0.0, goal};
            check(clq_walker_go(made, walker, place, 0.3f, 0));
            for (int tick = 0; tick < 300; ++tick) {
                check(clq_walkers_step(made));
                watch(made, stone, steps);
            }
        }
        return steps;
    }

private:
    static void watch(clq_walkers *walkers, const staged::Setting::Stone &stone, Steps &steps)
    {
        const clq_walker_piece *pieces = nullptr;
        uint32_t count = 0;
        check(clq_walkers_get_pieces(walkers, &pieces, &count));
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t foot = 0; foot < 2; ++foot) {
                clq_track_plant plants[8];
                size_t found = 0;
                check(
                    clq_track_get_plants(pieces[i].track, foot, pieces[i].begin_s, pieces[i].end_s, plants, 8, &found));
                for (size_t k = 0; k < found; ++k) {
                    const double *at = plants[k].position;
                    const double y = stone.height(stone.user, at);
                    steps.highest = std::max(steps.highest, at[1]);
                    if (std::isnan(y)) continue;
                    const double off = std::fabs(at[1] - y);
                    ++(off < 0.001 ? steps.on_treads : steps.beside);
                    steps.farthest_off = std::max(steps.farthest_off, off);
                }
            }
    }

    Library library_{1};
    Scenario scenario_;
    std::unique_ptr<staged::Setting> setting_;
    staged::OwnNavigation navigation_;
    walkers::Member member_;
};

TEST_F(StairsOfATheatre, HaveAllFeetOfTheirPeopleOnTreads)
{
    const Steps steps = climb(true);
    EXPECT_GT(steps.highest, 3.5);
    EXPECT_GT(steps.on_treads, 50);
    EXPECT_EQ(steps.beside, 0) << "by up to " << steps.farthest_off << " m";
}

TEST_F(StairsOfATheatre, AreARampForThoseWithoutKnowledgeOfTheStone)
{
    const Steps steps = climb(false);
    EXPECT_GT(steps.highest, 3.5);
    EXPECT_GT(steps.beside, 30);
    EXPECT_GT(steps.farthest_off, 0.08);
}

}  // namespace
}  // namespace staged_test
