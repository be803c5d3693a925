// The agents of a stage that walk: pieces are there when their time is decided, and each request is answered once.
#include <map>

#include "tests/unit/walk/movement_fixture.h"

using namespace claque;
using walk_test::Movement;

TEST_F(Movement, HasThePieceOfEachTimeWhenTheTimeIsDecided)
{
    const auto movement = make();
    crowd(*movement);
    movement->add(12, walker(3, 5), 1.23);  // comes later
    std::map<uint32_t, stage::Piece> last;
    for (int tick = 1; tick <= 200; ++tick) {
        const double before_s = 0.05 * (tick - 1), until_s = 0.05 * tick;
        movement->advance(until_s, moved_);
        for (const stage::Piece &piece : moved_.pieces) {
            clq_track_info info = clq_track_info_init();
            ASSERT_EQ(clq_track_get_info(piece.track, &info), CLQ_OK);
            ASSERT_NEAR(info.start_s, piece.from_s, 1e-9);
            ASSERT_EQ(piece.start_s, 0);
            ASSERT_LE(piece.from_s, until_s + 1e-6);
            if (tick > 1) {
                ASSERT_GT(piece.from_s, before_s - 1e-6);
            }
            const auto old = last.find(piece.agent);
            if (old != last.end()) {
                ASSERT_EQ(info.previous_hash, hash_of(old->second.track));
                clq_track_destroy(old->second.track);
            }
            last[piece.agent] = piece;
        }
        moved_.pieces.clear(), moved_.arrivals.clear();
        for (const auto &[agent, piece] : last) {
            clq_track_state state;
            ASSERT_EQ(clq_track_evaluate(piece.track, until_s, &state), CLQ_OK);
            ASSERT_TRUE(state.present) << agent << " at " << until_s;
            ASSERT_LT(floors::apart(state.position, movement->place(agent, until_s).position), 1e-9);
        }
        EXPECT_EQ(last.count(12), until_s >= 1.23) << tick;
    }
    EXPECT_EQ(last.size(), 13u);
    for (const auto &entry : last) clq_track_destroy(entry.second.track);
}

TEST_F(Movement, AnswersEachRequestOnce)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    movement->go(0, goal(15, 3, 7), 0);
    EXPECT_EQ(run(*movement, 0, 20).size(), 3u);  // three pieces
    movement->go(0, goal(5, 3, 8), 1);            // instead
    int answers = 0;
    const auto count = [&](int from, int to, uint64_t request, bool reached) {
        for (int tick = from + 1; tick <= to; ++tick) {
            movement->advance(0.05 * tick, moved_);
            for (const stage::Arrival &one : moved_.arrivals) {
                EXPECT_EQ(one.request, request);
                EXPECT_EQ(one.reached, reached);
                EXPECT_GT(one.time_s, 0.05 * (tick - 1) - 1e-6);
                EXPECT_LE(one.time_s, 0.05 * tick + 1e-6);
                ++answers;
            }
            clear(moved_);
        }
    };
    count(20, 200, 8, true);
    EXPECT_EQ(answers, 1);
    movement->go(0, goal(500, 3, 9), 10);  // there is no ground
    count(200, 240, 9, false);
    EXPECT_EQ(answers, 2);
    ASSERT_EQ(clq_navigation_set_door(navigation_, 0, false), CLQ_OK);
    movement->go(0, goal(15, 3, 10), 12);
    count(240, 500, 10, false);
    EXPECT_EQ(answers, 3);
    movement->go(0, goal(1, 3, 11), 25);
    movement->stop(0, 25);
    count(500, 700, 0, false);
    EXPECT_EQ(answers, 3);
}

TEST_F(Movement, TurnsToTheHeadingOfItsGoal)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    stage::Goal wanted = goal(6, 3, 1);
    wanted.heading_rad = 0;  // it walks along +x, at pi / 2
    movement->go(0, wanted, 0);
    run(*movement, 0, 160);
    EXPECT_NEAR(std::remainder(movement->place(0, 8).heading_rad, 2 * M_PI), 0, 0.1);
    EXPECT_LT(movement->place(0, 8).speed_m_s, 0.01f);
}

TEST_F(Movement, DoesNotDependOnHowTimeIsCut)
{
    const auto a = make(), b = make();
    crowd(*a), crowd(*b);
    std::vector<std::string> fine = run(*a, 0, 120), coarse;
    for (int tick = 0; tick < 120; tick += 20) {
        b->advance(0.05 * (tick + 20), moved_);
        for (const stage::Piece &piece : moved_.pieces)
            coarse.push_back(std::to_string(piece.agent) + " " + std::to_string(piece.from_s) + " " +
                             std::to_string(hash_of(piece.track)));
        for (const stage::Arrival &one : moved_.arrivals)
            coarse.push_back("arrival " + std::to_string(one.agent) + " " + std::to_string(one.request) + " " +
                             std::to_string(one.time_s) + " " + std::to_string(one.reached));
        clear(moved_);
    }
    std::sort(fine.begin(), fine.end()), std::sort(coarse.begin(), coarse.end());
    EXPECT_EQ(fine, coarse);
}
