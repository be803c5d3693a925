#include "samples/scenes/town/passengers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "samples/scenes/occupancy_grid.h"
#include "samples/scenes/random.h"

namespace scenes::town
{
namespace
{

clq_transform place_of(const VehiclePose &pose)
{
    clq_transform place = {};
    std::memcpy(place.position, pose.position, sizeof place.position);
    const std::array<float, 4> turn = pose.orientation_xyzw();
    std::copy(turn.begin(), turn.end(), place.orientation_xyzw);
    place.scale = 1;
    return place;
}

}  // namespace

Passengers::Passengers(Library &library, const CrowdOptions &crowd_options, const Town &town)
    : seed_(crowd_options.seed),
      path_(town.plan(), town.terrain(), Omnibus::wheelbase_m, Omnibus::half_track_m),
      scene_crowd_(library, crowd_options)
{
    for (const char *name : {"citizen", "patrician", "plebeian", "decurion"}) figures_.push_back(library.builtin(name));
    const uint32_t seats = static_cast<uint32_t>(Omnibus::seats().size());
    const uint32_t most = static_cast<uint32_t>(path_.length_m() / spacing_m) * seats;
    const Block &square = town.plan().square();
    first_m_ =
        path_.nearest(town.plan().at(square.u1 + 6, square_plan(town.plan()).fountain_v + 6)) - 2 * metres_a_second;
    // One in eight is on foot; where omnibuses are full, more.
    const uint32_t riding =
        std::min(most, crowd_options.count < 8 ? crowd_options.count : crowd_options.count - crowd_options.count / 8);
    board(riding);
    gather(town, crowd_options.count - riding);
    drive(0);
}

clq_play Passengers::play(clq_template *tmpl, const char *const *clips, size_t count, size_t number) const
{
    const size_t which = std::min(
        count - 1, static_cast<size_t>(random_unit(seed_, number, Purpose::clip) * static_cast<double>(count)));
    clq_play play = {};
    play.clip = clq_template_find_clip(tmpl, clips[which]);
    play.speed = static_cast<float>(random_between(seed_, number, Purpose::speed, 0.9, 1.1));
    clq_clip_info info = clq_clip_info_init();
    if (play.clip != CLQ_NONE && clq_template_get_clip(tmpl, play.clip, &info) == CLQ_OK)
        play.phase_s =
            static_cast<float>(random_unit(seed_, number, Purpose::phase) * static_cast<double>(info.duration_s));
    return play;
}

void Passengers::board(uint32_t people)
{
    constexpr const char *clips[] = {"sit", "sit", "sit_look", "sit_talk", "sit_lean", "sit_laugh", "sit_wave"};
    const std::vector<Omnibus::Seat> &seats = Omnibus::seats();
    const uint32_t vehicles = (people + static_cast<uint32_t>(seats.size()) - 1) / static_cast<uint32_t>(seats.size());
    for (uint32_t vehicle = 0; vehicle < vehicles; ++vehicle) {
        poses_.push_back(path_.at(path_.length_m() * vehicle / vehicles));
        const clq_transform at = place_of(poses_.back());
        clq_group group = {};
        check(clq_group_create(crowd(), &at, &group));
        groups_.push_back(group);
    }
    for (uint32_t number = 0; number < people; ++number) {
        const Omnibus::Seat &seat = seats[number / vehicles];  // one in each, drivers first
        const bool driver = number < vehicles;
        clq_template *tmpl = figures_[driver ? 2 : static_cast<size_t>(random_unit(seed_, number, Purpose::act) * 4)];
        // Small people on small benches: their feet are on the floor at any size.
        const float size = static_cast<float>(random_between(seed_, number, Purpose::size, 0.96, 1.02));
        const double turned = driver ? 0 : random_between(seed_, number, Purpose::heading, -0.12, 0.12);
        const clq_transform place = stand(static_cast<double>(seat.x), static_cast<double>(seat.y),
                                          static_cast<double>(seat.z), turned, 1, size);
        scene_crowd_.enter({tmpl, place, play(tmpl, clips, driver ? 1 : 7, number)});
        check(clq_actor_join(crowd(), scene_crowd_.actors().back(), groups_[number % vehicles], &place));
    }
    seated_ = people;
}

void Passengers::gather(const Town &town, uint32_t people)
{
    constexpr const char *clips[] = {"stand", "stand", "stand", "stand_wave", "stand_laugh", "stand_applaud"};
    const Block &square = town.plan().square();
    const SquarePlan layout = square_plan(town.plan());
    const Point fountain = town.plan().at(layout.fountain_u, layout.fountain_v);
    OccupancyGrid room;
    double half = 17;
    for (uint64_t draw = 0; standing_.size() < people; ++draw) {
        if (draw % 400 == 399) half += 2;  // more room for more people
        const double u = layout.fountain_u - 6 + random_between(seed_, draw, Purpose::place_x, -half, half * 0.75);
        const double v =
            std::min(square.v1 - 2, layout.fountain_v + 4 + random_between(seed_, draw, Purpose::place_z, -half, half));
        const Point at = town.plan().at(u, v);
        const double x = at.x - fountain.x, z = at.z - fountain.z;
        if (x * x + z * z < 4.8 * 4.8 || !room.free(at.x, at.z, 1.1)) continue;
        room.take(at.x, at.z);
        const size_t number = scene_crowd_.actors().size();
        clq_template *tmpl = figures_[static_cast<size_t>(random_unit(seed_, number, Purpose::act) * 4)];
        const double turn = random_between(seed_, number, Purpose::heading, 0, 6.283);
        const float size = static_cast<float>(random_between(seed_, number, Purpose::size, 0.94, 1.06));
        const clq_transform place = stand(at.x, town.height(at.x, at.z), at.z, std::sin(turn), std::cos(turn), size);
        scene_crowd_.enter({tmpl, place, play(tmpl, clips, 6, number)});
        standing_.push_back(place);
    }
}

void Passengers::drive(double time_s)
{
    for (size_t i = 0; i < groups_.size(); ++i) {
        const double start = first_m_ + path_.length_m() * static_cast<double>(i) / static_cast<double>(groups_.size());
        poses_[i] = path_.place_at(time_s, metres_a_second, start);
        const clq_transform place = place_of(poses_[i]);
        check(clq_group_set_transform(crowd(), groups_[i], &place));
    }
}

}  // namespace scenes::town
