// The ushers of the odeon: each gets the seat of its class that is nearest and free, no two get one, a leaver frees
// it, and on a bench people go in and out without passing each other.
#include "samples/scenes/odeon/ushers.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "samples/scenes/odeon/floor.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scenario/scenario.h"

namespace
{

using namespace scenes;

enum Question : size_t { ask_bench, ask_seat, ask_leave, leave_seat, ask_way_out };

struct House {
    Theatre theatre = *odeon_scenario().theatre;
    Ushers ushers{theatre, 1};
    std::map<size_t, std::string> heard;  // the last event of each guest
    std::map<size_t, std::array<double, 3>> place;

    size_t add(const std::string &social_class, size_t entrance = 0)
    {
        return ushers.add({social_class, 1, entrances_of(theatre)[entrance]});
    }
    std::string ask(Question question, size_t guest)
    {
        heard.erase(guest);
        ushers.ask(question, guest, [this](const Ushers::Answer &answer) {
            heard[answer.guest] = answer.event, place[answer.guest] = answer.place;
        });
        return heard.count(guest) ? heard[guest] : "";
    }
    size_t seat(const std::string &social_class, size_t entrance = 0)
    {
        const size_t guest = add(social_class, entrance);
        if (ask(ask_bench, guest) == "bench") ask(ask_seat, guest);
        return guest;
    }
};

TEST(Ushers, FillAllSeatsOfAClassAndNoSeatTwice)
{
    House house;
    size_t seats = 0;
    for (const Bench &bench : house.ushers.benches())
        seats += bench.social_class == "patricians" ? bench.seats.size() : 0;
    std::set<size_t> taken;
    for (size_t i = 0; i < seats; ++i) {
        const size_t guest = house.seat("patricians", i % 6), seat = house.ushers.seat_of(guest);
        ASSERT_EQ(house.heard[guest], "seat");
        ASSERT_TRUE(taken.insert(seat).second) << seat;
        EXPECT_EQ(house.theatre.rows[house.ushers.seats()[seat].row].social_class, "patricians");
        const clq_transform place = house.ushers.place_of(seat, 1);
        for (size_t k = 0; k < 3; ++k) EXPECT_EQ(house.place[guest][k], place.position[k]);
    }
    const size_t late = house.add("patricians");
    EXPECT_EQ(house.ask(ask_bench, late), "full");
    EXPECT_EQ(house.ask(ask_bench, house.add("plebeians")), "bench") << "other classes have seats";
}

TEST(Ushers, LetPeopleOutWhenNoneSitsBetweenThemAndTheGangway)
{
    House house;
    std::map<size_t, std::vector<size_t>> benches;  // of the guests of each gangway and row
    for (int i = 0; i < 60; ++i) {
        const size_t guest = house.seat("decurions");
        const size_t seat = house.ushers.seat_of(guest);
        for (size_t b = 0; b < house.ushers.benches().size(); ++b)
            for (const size_t one : house.ushers.benches()[b].seats)
                if (one == seat) benches[b].push_back(guest);
    }
    const std::vector<size_t> *full = nullptr;
    for (const auto &[bench, guests] : benches)
        if (guests.size() >= 3) full = &guests;
    ASSERT_NE(full, nullptr);
    const size_t inner = (*full)[full->size() - 3], middle = (*full)[full->size() - 2], outer = full->back();
    EXPECT_EQ(house.ask(ask_leave, inner), "") << "it waits";
    EXPECT_EQ(house.ask(ask_leave, middle), "");
    EXPECT_EQ(house.ask(ask_leave, outer), "free");
    EXPECT_EQ(house.heard.count(middle), 0u) << "the outer one is still there";
    house.ask(leave_seat, outer);
    EXPECT_EQ(house.heard[middle], "free");
    EXPECT_EQ(house.heard.count(inner), 0u);
    EXPECT_EQ(house.ushers.seat_of(outer), Ushers::nowhere);
    house.ask(leave_seat, middle);
    EXPECT_EQ(house.heard[inner], "free");
}

TEST(Ushers, KeepSeatsApartWhileManyComeAndGo)
{
    House house;
    std::map<size_t, size_t> owner;  // guest by seat
    std::vector<size_t> inside;
    const char *const classes[] = {"decurions", "patricians", "plebeians"};
    for (uint64_t step = 0; step < 6000; ++step) {
        const bool comes = inside.empty() || random_unit(1, step, Purpose::act) < 0.55;
        if (comes) {
            const size_t guest = house.seat(classes[step % 3], step % 6), seat = house.ushers.seat_of(guest);
            if (seat == Ushers::nowhere) continue;
            ASSERT_TRUE(owner.insert({seat, guest}).second) << "two on seat " << seat << " at step " << step;
            inside.push_back(guest);
            continue;
        }
        const size_t at = random_bits(1, step, Purpose::seat) % inside.size(), guest = inside[at];
        const size_t seat = house.ushers.seat_of(guest);
        house.ask(ask_leave, guest);
        house.ask(leave_seat, guest);
        if (house.ushers.seat_of(guest) != Ushers::nowhere) continue;  // others sit before it
        owner.erase(seat);
        inside.erase(inside.begin() + static_cast<ptrdiff_t>(at));
    }
    EXPECT_GT(inside.size(), 100u);
    for (const auto &[seat, guest] : owner) EXPECT_EQ(house.ushers.seat_of(guest), seat);
}

TEST(Ushers, SayTheSameToTheSameQuestions)
{
    House a, b;
    for (int i = 0; i < 200; ++i) {
        const size_t one = a.seat("plebeians", i % 6), same = b.seat("plebeians", i % 6);
        ASSERT_EQ(a.ushers.seat_of(one), b.ushers.seat_of(same));
    }
}

}  // namespace
