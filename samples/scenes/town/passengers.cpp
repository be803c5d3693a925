#include "samples/scenes/town/passengers.h"

#include "samples/scenes/elbow_room.h"
#include "samples/scenes/lot.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace scenes::town
{
namespace
{

clq_place place_of(const Stance &stance)
{
    clq_place place = {};
    std::memcpy(place.position, stance.position, sizeof place.position);
    const std::array<float, 4> turn = stance.orientation_xyzw();
    std::copy(turn.begin(), turn.end(), place.orientation_xyzw);
    place.scale = 1;
    return place;
}

}  // namespace

Passengers::Passengers(Library &library, const Casting &casting, const Town &town)
    : seed_(casting.seed),
      path_(town.plan(), town.terrain(), Omnibus::wheelbase_m, Omnibus::half_track_m),
      cast_(library, casting)
{
    for (const char *name : {"citizen", "patrician", "plebeian", "decurion"}) figures_.push_back(library.builtin(name));
    const uint32_t seats = static_cast<uint32_t>(Omnibus::seats().size());
    const uint32_t most = static_cast<uint32_t>(path_.length_m() / spacing_m) * seats;
    const Block &square = town.plan().square();
    first_m_ =
        path_.nearest(town.plan().at(square.u1 + 6, square_plan(town.plan()).fountain_v + 6)) - 2 * metres_a_second;
    // One in eight is on foot; where omnibuses are full, more.
    const uint32_t riding = std::min(most, casting.count < 8 ? casting.count : casting.count - casting.count / 8);
    board(riding);
    gather(town, casting.count - riding);
    drive(0);
}

clq_play Passengers::play(clq_template *tmpl, const char *const *clips, size_t count, size_t who) const
{
    const size_t which =
        std::min(count - 1, static_cast<size_t>(lot(seed_, who, Lot::clip) * static_cast<double>(count)));
    clq_play play = {};
    play.clip = clq_template_find_clip(tmpl, clips[which]);
    play.speed = static_cast<float>(lot_between(seed_, who, Lot::speed, 0.9, 1.1));
    clq_clip_info info = {};
    if (play.clip != CLQ_NONE && clq_template_get_clip(tmpl, play.clip, &info) == CLQ_OK)
        play.phase_s = static_cast<float>(lot(seed_, who, Lot::phase) * static_cast<double>(info.duration_s));
    return play;
}

void Passengers::board(uint32_t people)
{
    constexpr const char *clips[] = {"sit", "sit", "sit_look", "sit_talk", "sit_lean", "sit_laugh", "sit_wave"};
    const std::vector<Omnibus::Seat> &seats = Omnibus::seats();
    const uint32_t vehicles = (people + static_cast<uint32_t>(seats.size()) - 1) / static_cast<uint32_t>(seats.size());
    for (uint32_t vehicle = 0; vehicle < vehicles; ++vehicle) {
        stances_.push_back(path_.at(path_.length_m() * vehicle / vehicles));
        const clq_place at = place_of(stances_.back());
        clq_group group = {};
        check(clq_group_create(crowd(), &at, &group));
        groups_.push_back(group);
    }
    for (uint32_t who = 0; who < people; ++who) {
        const Omnibus::Seat &seat = seats[who / vehicles];  // one each, drivers first
        const bool driver = who < vehicles;
        clq_template *tmpl = figures_[driver ? 2 : static_cast<size_t>(lot(seed_, who, Lot::act) * 4)];
        // Small people on small benches: their feet are on the floor whatever their size.
        const float size = static_cast<float>(lot_between(seed_, who, Lot::size, 0.96, 1.02));
        const double turned = driver ? 0 : lot_between(seed_, who, Lot::heading, -0.12, 0.12);
        const clq_place place = stand(static_cast<double>(seat.x), static_cast<double>(seat.y),
                                      static_cast<double>(seat.z), turned, 1, size);
        cast_.enter({tmpl, place, play(tmpl, clips, driver ? 1 : 7, who)});
        check(clq_actor_join(crowd(), cast_.actors().back(), groups_[who % vehicles], &place));
    }
    seated_ = people;
}

void Passengers::gather(const Town &town, uint32_t people)
{
    constexpr const char *clips[] = {"stand", "stand", "stand", "stand_wave", "stand_laugh", "stand_applaud"};
    const Block &square = town.plan().square();
    const SquarePlan layout = square_plan(town.plan());
    const Point fountain = town.plan().at(layout.fountain_u, layout.fountain_v);
    ElbowRoom room;
    double half = 17;
    for (uint64_t draw = 0; standing_.size() < people; ++draw) {
        if (draw % 400 == 399) half += 2;  // more room for more people
        const double u = layout.fountain_u - 6 + lot_between(seed_, draw, Lot::place_x, -half, half * 0.75);
        const double v =
            std::min(square.v1 - 2, layout.fountain_v + 4 + lot_between(seed_, draw, Lot::place_z, -half, half));
        const Point at = town.plan().at(u, v);
        const double x = at.x - fountain.x, z = at.z - fountain.z;
        if (x * x + z * z < 4.8 * 4.8 || !room.free(at.x, at.z, 1.1)) continue;
        room.take(at.x, at.z);
        const size_t who = cast_.actors().size();
        clq_template *tmpl = figures_[static_cast<size_t>(lot(seed_, who, Lot::act) * 4)];
        const double turn = lot_between(seed_, who, Lot::heading, 0, 6.283);
        const float size = static_cast<float>(lot_between(seed_, who, Lot::size, 0.94, 1.06));
        const clq_place place = stand(at.x, town.height(at.x, at.z), at.z, std::sin(turn), std::cos(turn), size);
        cast_.enter({tmpl, place, play(tmpl, clips, 6, who)});
        standing_.push_back(place);
    }
}

void Passengers::drive(double time_s)
{
    for (size_t i = 0; i < groups_.size(); ++i) {
        const double start = first_m_ + path_.length_m() * static_cast<double>(i) / static_cast<double>(groups_.size());
        stances_[i] = path_.place_at(time_s, metres_a_second, start);
        const clq_place place = place_of(stances_[i]);
        check(clq_group_place(crowd(), groups_[i], &place));
    }
}

}  // namespace scenes::town
