// Those who show people to their seats. Each answer is an event for the one who asked, or for one who waited.
//
//     ask_bench     answer `bench` from the gangway beside its row, or `full`: no seat of its class is free
//     ask_seat      answer `seat` from the exact place before the seat, its value is the heading in degrees; or `full`
//     ask_leave     answer `free`, as soon as all between the seat and the gangway have left
//     leave_seat    the seat is free for others
//     ask_way_out   answer `way_out` from a place outside
//
// All is a function of the calls in their order.
#pragma once

#include <functional>

#include "samples/scenes/odeon/benches.h"
#include "samples/scenes/odeon/seating.h"

namespace scenes
{

// A person that comes.
struct Spectator {
    std::string social_class;  // as rows name it
    float scale = 1;
    std::array<double, 3> entrance{};
};

class Ushers
{
public:
    // `seed` turns the heads of people on their seats, as in seat_people.
    Ushers(const Theatre &theatre, uint64_t seed);
    Ushers(const Ushers &) = delete;
    Ushers &operator=(const Ushers &) = delete;

    struct Answer {
        size_t guest = 0;
        const char *event = nullptr;
        std::array<double, 3> place{};
        double value = 0;
    };
    using Send = std::function<void(const Answer &)>;

    static const std::vector<std::string> &questions();
    // questions()[question] of a guest.
    void ask(size_t question, size_t guest, const Send &send);
    // Returns its number: guests count from 0.
    size_t add(const Spectator &spectator);

    static constexpr size_t nowhere = SIZE_MAX;
    // The seat that is a spectator's, of seats_of(); nowhere: none is.
    size_t seat_of(size_t spectator) const;
    size_t bench_of(size_t spectator) const { return guests_[spectator].bench; }
    const std::vector<Seat> &seats() const { return seats_; }
    const std::vector<Bench> &benches() const { return benches_; }
    // Where someone of a size stands before a seat and sits on it.
    clq_transform place_of(size_t seat, float scale) const;

private:
    struct Guest {
        Spectator person;
        size_t bench = nowhere, slot = nowhere;
        bool waits = false;  // to leave
    };
    struct Row {
        uint32_t promised = 0;        // places promised to people on their way
        std::vector<size_t> sitting;  // guests, by slot
    };
    void give_bench(size_t guest);
    void give_seat(size_t guest);
    void let_go(size_t guest);
    void take_back(size_t guest);
    void show_out(size_t guest);

    double way_m(const Guest &guest, size_t bench) const;
    bool is_shut_in(const Guest &guest) const;
    void free_last(size_t bench);
    void answer(const char *event, size_t guest, const std::array<double, 3> &place, double value = 0) const;

    const Theatre theatre_;
    uint64_t seed_;
    std::vector<Seat> seats_;
    std::vector<Bench> benches_;
    std::vector<std::array<double, 3>> outside_;
    std::vector<Row> rows_;  // by bench
    std::vector<Guest> guests_;
    const Send *send_ = nullptr;  // while it answers
};

}  // namespace scenes
