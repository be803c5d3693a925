// Walkers that stand make room for those who want to pass, and take their places again.
#include <algorithm>

#include "tests/unit/walk/floors.h"

using floors::Floor;
using floors::Held;

namespace
{

using Place = std::array<double, 2>;

// Until a walker arrives; the nearest two of all in the meantime.
struct Passage {
    double seconds = 0, nearest_m = 1e9;
    bool arrived = true;
};

Passage until_they_arrive(const Held &held, const std::vector<clq_walker> &all, const std::vector<clq_walker> &walking,
                          double limit_s)
{
    Passage passage;
    const auto arrived = [&](clq_walker one) { return held.info(one).state == CLQ_WALKER_ARRIVED; };
    while (!std::all_of(walking.begin(), walking.end(), arrived)) {
        if (passage.seconds > limit_s) {
            passage.arrived = false;
            break;
        }
        held.step();
        passage.seconds += 0.05;
        std::vector<clq_walker_info> infos;
        for (const clq_walker one : all) infos.push_back(held.info(one));
        for (size_t a = 0; a < infos.size(); ++a)
            for (size_t b = 0; b < a; ++b)
                passage.nearest_m = std::min(passage.nearest_m, floors::apart(infos[a].position, infos[b].position));
    }
    std::printf("walkers: %.1f s, the nearest two %.3f m apart\n", passage.seconds, passage.nearest_m);
    return passage;
}

double away_from(const Held &held, clq_walker walker, double x, double z)
{
    const double place[3] = {x, 0, z};
    return floors::apart(held.info(walker).position, place);
}

// Two halls, and between them a passage from x 8 to 10 of this width round z 3.
Floor passage_of(double width_m)
{
    Floor floor;
    floor.add(0, 0, 18, 6);
    floor.wall(8, 0, 10, 3 - width_m / 2);
    floor.wall(8, 3 + width_m / 2, 10, 6);
    return floor;
}

}  // namespace

TEST(WalkersThatStand, StepAsideInAGapAndTakeTheirPlaceAgain)
{
    const Held held(floors::two_rooms(false));
    const clq_walker stands = held.add(8.1, 3), walks = held.add(4, 3);
    held.go(walks, 12, 3);
    const Passage passage = until_they_arrive(held, {stands, walks}, {walks}, 20);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.38);
    EXPECT_LT(passage.seconds, 10);  // 8 m at 1.34 m/s take 6 s
    EXPECT_EQ(held.info(stands).state, CLQ_WALKER_STANDS);
    held.step(100);
    EXPECT_LT(away_from(held, stands, 8.1, 3), 0.1);
}

TEST(WalkersThatStand, GoAheadWhereTwoCannotPass)
{
    const Held held(passage_of(0.7));
    const clq_walker stands = held.add(9, 3), walks = held.add(4, 3);
    held.go(walks, 15, 3);
    const Passage passage = until_they_arrive(held, {stands, walks}, {walks}, 30);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.38);
}

TEST(WalkersThatStand, OpenAGroupForWalkersThatPass)
{
    const Held held(passage_of(3));
    std::vector<clq_walker> all;
    for (int i = 0; i < 12; ++i) all.push_back(held.add(8.3 + 0.7 * (i / 4), 1.95 + 0.7 * (i % 4)));
    const std::vector<clq_walker> walking = {held.add(4, 3), held.add(14, 2.5)};
    all.insert(all.end(), walking.begin(), walking.end());
    held.go(walking[0], 14, 3), held.go(walking[1], 4, 2.5);
    const Passage passage = until_they_arrive(held, all, walking, 30);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.36);
}

TEST(WalkersThatStand, StayWhereOthersCanGoRoundThem)
{
    const Held held(floors::two_rooms(false));
    const clq_walker stands = held.add(4, 3), walks = held.add(1, 3);
    held.go(walks, 7, 3);
    double farthest_m = 0;
    for (int i = 0; i < 200; ++i) held.step(), farthest_m = std::max(farthest_m, away_from(held, stands, 4, 3));
    EXPECT_EQ(held.info(walks).state, CLQ_WALKER_ARRIVED);
    EXPECT_LT(farthest_m, 0.1);
}

TEST(WalkersThatMeet, PassInACorridorOfTwo)
{
    const Held held(passage_of(1.2));
    const std::vector<clq_walker> both = {held.add(4, 3), held.add(14, 3)};
    held.go(both[0], 14, 3), held.go(both[1], 4, 3);
    const Passage passage = until_they_arrive(held, both, both, 25);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.38);
}

TEST(WalkersThatMeet, GoBackWhereOnlyOneCanGo)
{
    const Held held(passage_of(0.7));
    const std::vector<clq_walker> both = {held.add(4, 3), held.add(14, 3)};
    held.go(both[0], 14, 3), held.go(both[1], 4, 3);
    const Passage passage = until_they_arrive(held, both, both, 40);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.85 * 0.4 - 0.001) << "two whose shoulders are turned";
}

TEST(WalkersThatMeet, GoBackInGroups)
{
    const Held held(passage_of(0.7));
    std::vector<clq_walker> all;
    for (int i = 0; i < 8; ++i) {
        const double z = 2.5 + 0.7 * (i / 4), x = 1 + 0.7 * (i / 2 % 2);
        all.push_back(i % 2 ? held.add(18 - x, z) : held.add(x, z));
        held.go(all.back(), i % 2 ? x : 18 - x, z);
    }
    const Passage passage = until_they_arrive(held, all, all, 90);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.85 * 0.4 - 0.001);
}

TEST(WalkersThatArrive, StandBesideWalkersThatAreThereAlready)
{
    const Held held(floors::two_rooms(false));
    std::vector<clq_walker> all;
    for (int i = 0; i < 8; ++i) {
        all.push_back(held.add(1 + 0.7 * (i % 4), 1 + 3.0 * (i / 4)));
        held.go(all.back(), 6, 3);
    }
    const Passage passage = until_they_arrive(held, all, all, 20);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.36);
    double farthest_m = 0;
    for (const clq_walker one : all) farthest_m = std::max(farthest_m, away_from(held, one, 6, 3));
    EXPECT_LT(farthest_m, 1.6);
    held.step(100);
    std::vector<clq_walker_info> before;
    for (const clq_walker one : all) before.push_back(held.info(one));
    held.step(40);
    for (size_t i = 0; i < all.size(); ++i)  // and then they stand still
        EXPECT_LT(floors::apart(before[i].position, held.info(all[i]).position), 0.02) << i;
}

TEST(WalkersThatArrive, GetToTheirPlacesAmongOthers)
{
    const Held held(floors::two_rooms(false));
    std::vector<clq_walker> all;
    for (int i = 0; i < 4; ++i) all.push_back(held.add(3.3 + (i > 1 ? 1.4 : 0.7) * (i % 2 ? 1 : -1), 3));
    all.push_back(held.add(6.5, 1));
    held.go(all.back(), 3.3, 3, 0.1f);
    const Passage passage = until_they_arrive(held, all, {all.back()}, 8);
    EXPECT_TRUE(passage.arrived);
    EXPECT_GT(passage.nearest_m, 0.38);
    EXPECT_LT(away_from(held, all.back(), 3.3, 3), 0.15);
}
