// A saved movement has the same future, and bytes that are none are refused.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/unit/walk/movement_fixture.h"

using namespace claque;
using walk_test::Movement;

TEST_F(Movement, ThatMakesRoomHasTheSameFutureWhenItIsRestored)
{
    for (int at = 40; at <= 160; at += 5) {  // before the other one steps aside, meanwhile, and on its way back
        const auto movement = make();
        stage::Walker stands = walker(8.1, 3), walks = walker(4, 3);
        stands.radius_m = walks.radius_m = 0.28f;  // two do not fit into the opening
        movement->add(0, stands, 0);
        movement->add(1, walks, 0);
        movement->go(1, goal(12, 3, 1), 0);
        run(*movement, 0, at);
        const auto restored = restored_from(*movement);
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
        const auto restored = restored_from(*movement);
        for (walk::Walking *one : {movement.get(), restored.get()}) one->go(0, goal(6, 3, 2), 0.05 * at + 3.01);
        std::vector<std::string> future = run(*movement, at, at + 200), same = run(*restored, at, at + 200);
        EXPECT_EQ(future, same) << at;
        EXPECT_GT(future.size(), 8u);
    }
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

TEST_F(Movement, ThatMeetsAnotherHasTheSameFutureWhenItIsRestored)
{
    for (int at = 60; at <= 160; at += 10) {  // two groups hold each other up in the opening, and turn their shoulders
        const auto movement = make();
        crowds_that_meet(*movement);
        run(*movement, 0, at);
        const auto restored = restored_from(*movement);
        const std::vector<std::string> future = run(*movement, at, at + 100);
        EXPECT_EQ(run(*restored, at, at + 100), future) << at;
    }
}

TEST_F(Movement, TurnsShouldersWhereTwoMeetAndBackAtRest)
{
    const auto movement = make();
    for (uint32_t i = 0; i < 40; ++i) {  // in one room
        const bool back = i % 2 != 0;
        const double x = 0.5 + 0.6 * ((i / 2) % 3), z = 0.5 + 0.75 * (i / 6);
        movement->add(i, walker(back ? 7.5 - x : x, z), 0);
        movement->go(i, goal(back ? x : 7.5 - x, z, i), 0);
    }
    const auto turned = [&] {
        std::vector<uint8_t> bytes;
        movement->save(bytes);
        const double share = double(walk::turned_shoulders);
        const auto *first = reinterpret_cast<const uint8_t *>(&share);
        size_t count = 0;
        for (auto at = bytes.begin();; ++count, ++at) {
            at = std::search(at, bytes.end(), first, first + sizeof share);
            if (at == bytes.end()) return count;
        }
    };
    size_t most = 0;
    size_t arrived = 0;
    for (int at = 0; at < 1200; at += 10) {
        for (const std::string &one : run(*movement, at, at + 10)) arrived += one.rfind("arrival ", 0) == 0;
        most = std::max(most, turned());
    }
    EXPECT_EQ(arrived, 40u);
    EXPECT_GT(most, 0u);
    EXPECT_EQ(turned(), 0u);
    // Walkers that are stopped while they meet turn back where they have room.
    for (uint32_t i = 0; i < 40; ++i) movement->go(i, goal(i % 2 ? 7 : 0.5, 0.5 + 0.75 * (i / 6), i), 60);
    int at = 1200;
    while (turned() < 1 && at < 1500) run(*movement, at, at + 1), ++at;
    const size_t before = turned();
    for (uint32_t i = 0; i < 40; ++i) movement->stop(i, 0.05 * at);
    run(*movement, at, at + 100);
    EXPECT_LT(turned(), before);
}

TEST_F(Movement, AmongPillarsHasTheSameFutureWheneverItIsRestored)
{
    floors::Floor floor = floors::two_rooms(true);
    for (int i = 0; i < 18; ++i) {
        const double x = 2.2 + 2 * (i / 3) + (i / 9), z = 0.8 + 1.9 * (i % 3);
        floor.wall(x, z, x + 0.3, z + 0.3);
    }
    clq_navigation_destroy(navigation_);
    navigation_ = floor.make().release();
    for (int at = 5; at < 200; at += 9) {
        const auto movement = make();
        crowd(*movement);
        run(*movement, 0, at);
        const auto restored = restored_from(*movement);
        const std::vector<std::string> future = run(*movement, at, at + 60);
        EXPECT_EQ(run(*restored, at, at + 60), future) << at;
    }
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

// A walker whose numbers are all different, so that each is found among the bytes by itself.
TEST_F(Movement, RefusesEachNumberThatNoWalkerHas)
{
    const auto movement = make(), other = make();
    stage::Walker one = walker(2.34375, 3.15625);
    one.radius_m = 0.21875f, one.scale = 1.09375f, one.heading_rad = 0.59375;
    movement->add(0, one, 0);
    stage::Goal where = goal(5.46875, 4.28125, 7);
    where.near_m = 0.78125f, where.speed_m_s = 1.28125f;
    movement->go(0, where, 0);
    run(*movement, 0, 1);
    std::vector<uint8_t> bytes;
    movement->save(bytes);
    // How many of the places of a number refuse another one.
    const auto refusals = [&](double number, double instead) {
        int places = 0, refused = 0;
        for (size_t at = 0; at + sizeof number <= bytes.size(); ++at) {
            if (std::memcmp(&bytes[at], &number, sizeof number) != 0) continue;
            std::vector<uint8_t> forged = bytes;
            std::memcpy(&forged[at], &instead, sizeof instead);
            ++places;
            try {
                other->restore(forged.data(), forged.size());
            } catch (const stage::Error &error) {
                EXPECT_EQ(error.status(), CLQ_FORMAT) << error.what();
                ++refused;
            }
        }
        EXPECT_GT(places, 0) << number;
        return refused;
    };
    // `checked`: places at which it has a range.
    const auto expect = [&](double number, int checked, const std::vector<double> &taken,
                            const std::vector<double> &wrong) {
        for (const double instead : taken) EXPECT_EQ(refusals(number, instead), 0) << number << " as " << instead;
        for (const double instead : wrong) EXPECT_EQ(refusals(number, instead), checked) << number << " as " << instead;
    };
    const double nothing = NAN;
    expect(0.21875, 1, {double(0.05f), double(0.3f)}, {0.0499, 0.301, -1, nothing});  // its radius
    expect(0.78125, 2, {1e-3, 1e3}, {0, -1, nothing});                                // near enough
    expect(1.28125, 1, {1e-3, 8}, {0, -1, 8.001});                                    // its speed
    expect(1.09375, 4, {}, {0, -1, nothing});            // its scale, which its track has too
    expect(4, 1, {0.001, 50}, {0, -1, 50.01, nothing});  // how it gathers speed
    expect(5.46875 - 8, 4, {}, {1e6, -1e6, nothing});    // where it goes, from the middle
    expect(5.46875, 1, {}, {INFINITY, nothing});
    other->restore(bytes.data(), bytes.size());
}
