// The agents of a stage that walk: pieces are there when their time is decided, each request is answered once, and a
// saved movement has the same future.
#include "lib/stage/walk/movement.h"

#include <claque/assets.h>

#include <map>

#include "tests/unit/walk/floors.h"

using namespace claque;

namespace
{

class Movement : public testing::Test
{
protected:
    Movement() : navigation_(floors::two_rooms(true).make())
    {
        EXPECT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        EXPECT_EQ(clq_template_builtin(context_, "citizen", &citizen_), CLQ_OK) << clq_last_error();
        clq_locomotion_def walk = clq_locomotion_def_init();
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        EXPECT_EQ(clq_locomotion_create(context_, &walk, &locomotion_), CLQ_OK) << clq_last_error();
    }
    ~Movement() override
    {
        clear(moved_);
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
        clq_navigation_destroy(navigation_);
    }
    std::unique_ptr<walk::Walking> make() const
    {
        clq_walkers_def def = clq_walkers_def_init();
        def.max_count = 40;
        return std::make_unique<walk::Walking>(*navigation_, def, std::vector<const clq_locomotion *>{locomotion_});
    }
    stage::Walker walker(double x, double z) const
    {
        stage::Walker out;
        out.locomotion = locomotion_;
        out.position[0] = x, out.position[2] = z;
        return out;
    }
    static stage::Goal goal(double x, double z, uint64_t request)
    {
        stage::Goal out;
        out.position[0] = x, out.position[2] = z, out.request = request, out.heading_rad = NAN;
        return out;
    }
    static void clear(stage::Moved &moved)
    {
        for (const stage::Piece &piece : moved.pieces) clq_track_destroy(piece.track);
        moved.pieces.clear(), moved.arrivals.clear();
    }
    static uint64_t hash_of(const clq_track *track)
    {
        clq_track_info info = clq_track_info_init();
        EXPECT_EQ(clq_track_get_info(track, &info), CLQ_OK);
        return info.hash;
    }
    // Everything that is published up to a time, as text.
    std::vector<std::string> run(walk::Walking &movement, int from, int to)
    {
        std::vector<std::string> out;
        for (int tick = from + 1; tick <= to; ++tick) {
            movement.advance(0.05 * tick, moved_);
            for (const stage::Piece &piece : moved_.pieces)
                out.push_back(std::to_string(piece.agent) + " " + std::to_string(piece.from_s) + " " +
                              (piece.track ? std::to_string(hash_of(piece.track)) : "leaves"));
            for (const stage::Arrival &one : moved_.arrivals)
                out.push_back("arrival " + std::to_string(one.agent) + " " + std::to_string(one.request) + " " +
                              std::to_string(one.time_s) + " " + std::to_string(one.reached));
            clear(moved_);
        }
        return out;
    }
    void crowd(walk::Walking &movement) const
    {
        for (uint32_t i = 0; i < 12; ++i) {
            movement.add(i, walker(1 + 0.8 * (i % 4), 1 + 1.2 * (i / 4)), 0);
            movement.go(i, goal(15 - 0.8 * (i % 4), 1 + 1.2 * (i / 4), i), 0);
        }
    }

    clq_navigation *navigation_;
    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
    stage::Moved moved_;
};

}  // namespace

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

// Of someone that settles at a place beside the ground: pieces, and where it is at each tick.
TEST_F(Movement, SettlesExactlyBesideTheGround)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    stage::Goal seat = goal(4, -0.05, 1);  // a hand's breadth in the wall
    seat.position[1] = 0.03, seat.heading_rad = 0.4, seat.settles = true;
    movement->go(0, seat, 0);
    double left_s = 0, arrived_s = 0, begins_s = 0;
    for (int tick = 1; tick <= 240; ++tick) {
        movement->advance(0.05 * tick, moved_);
        for (const stage::Arrival &one : moved_.arrivals) {
            EXPECT_TRUE(one.reached);
            EXPECT_EQ(arrived_s, 0) << "it is answered once";
            arrived_s = one.time_s;
        }
        for (const stage::Piece &piece : moved_.pieces) {
            if (!piece.track) {
                EXPECT_EQ(left_s, 0) << "it leaves its track once";
                left_s = piece.from_s;
            }
            EXPECT_FALSE(piece.rises);
            begins_s = std::max(begins_s, piece.from_s);
        }
        clear(moved_);
    }
    ASSERT_GT(arrived_s, 2);
    EXPECT_GT(left_s, arrived_s);
    EXPECT_LT(left_s, arrived_s + 1.3);
    EXPECT_EQ(begins_s, left_s) << "no piece comes behind the last one";
    const stage::Place place = movement->place(0, 12);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(place.position[k], seat.position[k], 0.004) << k;
    EXPECT_NEAR(std::remainder(place.heading_rad - seat.heading_rad, 2 * M_PI), 0, 0.02);
}

TEST_F(Movement, ThatHasSettledIsInNoOthersWay)
{
    // Through the door, in whose middle another one stands; it has settled there or not.
    for (const bool settles : {false, true}) {
        const auto movement = make();
        movement->add(0, walker(7, 3), 0);
        stage::Goal middle = goal(8.1, 3, 1);
        middle.heading_rad = 0, middle.settles = settles, middle.near_m = 0.1f;
        movement->go(0, middle, 0);
        run(*movement, 0, 120);
        movement->add(1, walker(5, 3), 6);
        movement->go(1, goal(12, 3, 2), 6);
        double nearest_m = 9;
        for (int tick = 120; tick < 320; ++tick) {
            run(*movement, tick, tick + 1);
            const double now_s = 0.05 * (tick + 1);
            nearest_m = std::min(nearest_m,
                                 floors::apart(movement->place(0, now_s).position, movement->place(1, now_s).position));
        }
        EXPECT_EQ(nearest_m < 0.15, settles) << nearest_m;
        EXPECT_EQ(nearest_m > 0.25, !settles) << nearest_m;
    }
}

TEST_F(Movement, ThatHasSettledGoesOnFromWhereItWas)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    stage::Goal seat = goal(4, -0.05, 1);
    seat.heading_rad = 0, seat.settles = true;
    movement->go(0, seat, 0);
    run(*movement, 0, 240);
    const stage::Place sat = movement->place(0, 12);
    movement->go(0, goal(6, 3, 2), 12.01);
    stage::Place before = sat;
    int rises = 0;
    for (int tick = 241; tick <= 400; ++tick) {
        movement->advance(0.05 * tick, moved_);
        for (const stage::Piece &piece : moved_.pieces) {
            EXPECT_EQ(piece.rises, rises == 0);
            if (piece.rises) EXPECT_NEAR(piece.from_s, 12.01, 1e-9);
            ++rises;
        }
        clear(moved_);
        const stage::Place now = movement->place(0, 0.05 * tick);
        EXPECT_LT(floors::apart(now.position, before.position), 0.12) << "at " << 0.05 * tick;
        before = now;
    }
    EXPECT_GT(rises, 3);
    EXPECT_LT(std::hypot(before.position[0] - 6, before.position[2] - 3), 0.6);
}

TEST_F(Movement, ThatMakesRoomHasTheSameFutureWhenItIsRestored)
{
    for (int at = 90; at <= 150; at += 6) {  // before the other one steps aside, meanwhile, and on its way back
        const auto movement = make();
        movement->add(0, walker(8.1, 3), 0);
        movement->add(1, walker(4, 3), 0);
        movement->go(1, goal(12, 3, 1), 0);
        run(*movement, 0, at);
        std::vector<uint8_t> bytes;
        movement->save(bytes);
        const auto restored = make();
        restored->restore(bytes.data(), bytes.size());
        const std::vector<std::string> future = run(*movement, at, at + 150);
        EXPECT_EQ(run(*restored, at, at + 150), future) << at;
        EXPECT_GT(future.size(), 16u);
    }
}

TEST_F(Movement, ThatSettlesHasTheSameFutureWhenItIsRestored)
{
    for (const int at : {40, 62, 75, 88, 140}) {  // on its way, beside the ground, before and after it left its track
        const auto movement = make();
        movement->add(0, walker(1, 3), 0);
        stage::Goal seat = goal(3, -0.05, 1);
        seat.heading_rad = 0, seat.settles = true;
        movement->go(0, seat, 0);
        run(*movement, 0, at);
        std::vector<uint8_t> bytes;
        movement->save(bytes);
        const auto restored = make();
        restored->restore(bytes.data(), bytes.size());
        for (walk::Walking *one : {movement.get(), restored.get()}) one->go(0, goal(6, 3, 2), 0.05 * at + 3.01);
        std::vector<std::string> future = run(*movement, at, at + 200), same = run(*restored, at, at + 200);
        EXPECT_EQ(future, same) << at;
        EXPECT_GT(future.size(), 8u);
    }
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

TEST_F(Movement, HasTheSameFutureWhenItIsRestored)
{
    const auto movement = make();
    crowd(*movement);
    movement->add(12, walker(3, 5), 9.5);
    run(*movement, 0, 60);
    ASSERT_EQ(clq_navigation_set_door(navigation_, 0, false), CLQ_OK);
    run(*movement, 60, 90);
    std::vector<uint8_t> bytes, again;
    movement->save(bytes);
    movement->save(again);
    EXPECT_EQ(bytes, again);
    const std::vector<std::string> future = run(*movement, 90, 300);
    ASSERT_EQ(clq_navigation_set_door(navigation_, 0, true), CLQ_OK);
    const auto restored = make();
    restored->restore(bytes.data(), bytes.size());
    bool open = true;
    ASSERT_EQ(clq_navigation_get_door(navigation_, 0, &open), CLQ_OK);
    EXPECT_FALSE(open);
    again.clear();
    restored->save(again);
    EXPECT_EQ(bytes, again);
    EXPECT_EQ(run(*restored, 90, 300), future);
    EXPECT_GT(future.size(), 200u);
}

TEST_F(Movement, RefusesBytesThatAreNoMovement)
{
    const auto movement = make(), other = make();
    crowd(*movement);
    run(*movement, 0, 60);
    std::vector<uint8_t> bytes, before, after;
    movement->save(bytes);
    other->save(before);
    const auto refused = [&](const std::vector<uint8_t> &bad) {
        try {
            other->restore(bad.data(), bad.size());
            return false;
        } catch (const stage::Error &error) {
            EXPECT_EQ(error.status(), CLQ_FORMAT) << error.what();
            return true;
        }
    };
    for (size_t size = 0; size < bytes.size(); size += size < 300 ? 7 : 997)
        ASSERT_TRUE(refused({bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(size)})) << size;
    other->save(after);
    EXPECT_EQ(before, after);
    // Any change is refused or harmless.
    for (size_t at = 0; at < bytes.size(); at += at < 600 ? 3 : 211) {
        std::vector<uint8_t> changed = bytes;
        changed[at] ^= at % 2 ? 0xff : 0x01;
        if (refused(changed)) continue;
        try {
            run(*other, 60, 64);
        } catch (const stage::Error &) {  // such as a walker of another size than its track
        }
    }
}
