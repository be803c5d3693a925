// Rows of the odeon are as narrow as a body, and lead off at right angles from steep stairs. A walker that is too fast
// for such a corner, or beside the polygons of its way, must not circle before it.
#include <cmath>

#include "samples/scenes/odeon/ushers.h"
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;
using Point3 = std::array<double, 3>;

struct DestroyRowWalkers {
    void operator()(clq_walkers *p) const { clq_walkers_destroy(p); }
};

class RowsOfTheOdeon : public testing::Test
{
protected:
    RowsOfTheOdeon()
        : scenario_(load_scenario(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/odeon-evening.toml")),
          world_(scenario_, 1, false),
          ushers_(*scenario_.theatre, 1)
    {
        clq_walkers_def def = clq_walkers_def_init();
        def.climbing = def.descending = 1;
        clq_walkers *made = nullptr;
        check(clq_walkers_create(world_.run().navigation(), &def, &made));
        walkers_.reset(made);
    }

    // The places that the ushers show to the next guest of a class: beside its row on the stairs, and before its seat.
    std::vector<Point3> shown_to(const std::string &social_class)
    {
        std::vector<Point3> places;
        const size_t guest = ushers_.add({social_class, 1, {7, 0, 13.6}});
        for (const size_t question : {0u, 1u})
            ushers_.ask(question, guest, [&](const Ushers::Answer &answer) {
                if (std::string(answer.event) != "full") places.push_back(answer.place);
            });
        return places;
    }

    // From 1.5 m further down the stairs. Returns the seconds that it needs; 0: it does not get there.
    double walked_s(const std::vector<Point3> &places, float speed_m_s)
    {
        const Point3 &beside = places[0], &seat = places[1];
        const double share = 1 - 1.5 / std::hypot(beside[0], beside[2]);
        clq_walker_def def = clq_walker_def_init();
        def.radius_m = 0.16f, def.speed_m_s = speed_m_s;
        def.position[0] = share * beside[0], def.position[1] = beside[1] - 0.7, def.position[2] = share * beside[2];
        clq_walker walker = {};
        check(clq_walkers_add(walkers_.get(), &def, &walker));
        check(clq_walker_go(walkers_.get(), walker, seat.data(), 0.35f, 0));
        double needed_s = 0;
        for (int tick = 1; tick <= 600 && needed_s == 0; ++tick) {
            check(clq_walkers_step(walkers_.get()));
            clq_walker_info info = clq_walker_info_init();
            check(clq_walkers_get_walker(walkers_.get(), walker, &info));
            if (info.state == CLQ_WALKER_ARRIVED) needed_s = 0.05 * tick;
        }
        check(clq_walkers_remove(walkers_.get(), walker));
        return needed_s;
    }

    Scenario scenario_;
    World world_;
    Ushers ushers_;
    std::unique_ptr<clq_walkers, DestroyRowWalkers> walkers_;
};

TEST_F(RowsOfTheOdeon, AreReachedByEveryWalkerThatIsAlone)
{
    size_t seats = 0;
    for (const char *social_class : {"decurions", "patricians", "plebeians"})
        for (;;) {
            const std::vector<Point3> places = shown_to(social_class);
            if (places.size() < 2) break;
            ++seats;
            for (const float speed_m_s : {0.95f, 1.4f})
                EXPECT_GT(walked_s(places, speed_m_s), 0)
                    << social_class << " at " << speed_m_s << " m/s to " << places[1][0] << " " << places[1][2];
        }
    EXPECT_GE(seats, 540u);
}

}  // namespace
}  // namespace staged_test
