#include "samples/scenes/hundred/dragon_paths.h"

#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::hundred
{
namespace
{

constexpr float round_s = 11, to_fro_s = 6;
constexpr uint32_t corners = 12, keys = 24;

clq_root_path add(clq_crowd *crowd, const clq_root_path_def &def)
{
    clq_root_path path = {};
    check(clq_crowd_add_root_path(crowd, &def, &path));
    return path;
}

// A horizontal circle, flown with a little bank.
clq_root_path circle(clq_crowd *crowd, double beside)
{
    std::vector<float> positions;
    for (uint32_t k = 0; k < corners; ++k) {
        const double turn = 6.283185307179586 * k / corners;
        positions.push_back(static_cast<float>(beside + circle_m * std::sin(turn)));
        positions.push_back(0);
        positions.push_back(static_cast<float>(circle_m * std::cos(turn)));
    }
    clq_root_path_def def = clq_root_path_def_init();
    def.count = corners;
    def.positions = positions.data();
    def.duration_s = round_s;
    def.max_bank_rad = 0.3f;
    return add(crowd, def);
}

// Ahead and back, always looking ahead.
clq_root_path to_and_fro(clq_crowd *crowd)
{
    std::vector<float> positions, rotations, times;
    for (uint32_t k = 0; k < keys; ++k) {
        positions.insert(positions.end(),
                         {0, 0, static_cast<float>(to_fro_m * std::sin(6.283185307179586 * k / keys))});
        rotations.insert(rotations.end(), {0, 0, 0, 1});
        times.push_back(to_fro_s * static_cast<float>(k) / keys);
    }
    clq_root_path_def def = clq_root_path_def_init();
    def.count = keys;
    def.positions = positions.data();
    def.rotations_xyzw = rotations.data();
    def.times_s = times.data();
    def.duration_s = to_fro_s;
    return add(crowd, def);
}

}  // namespace

DragonPaths::DragonPaths(clq_crowd *crowd)
    : crowd_(crowd), paths_{circle(crowd, 0), circle(crowd, aside_m), to_and_fro(crowd)}
{
}

void DragonPaths::send(clq_actor actor, PathKind way, uint64_t number) const
{
    clq_root_path_play motion = {};
    motion.path = paths_[static_cast<size_t>(way)];
    motion.speed = static_cast<float>(random_between(1, number, Purpose::speed, 0.85, 1.15));
    motion.phase_s = static_cast<float>(random_between(1, number, Purpose::lane, 0, 60));
    check(clq_actor_play_root_path(crowd_, actor, &motion));
}

Spheres spheres_of(clq_context *context, clq_template *dragon)
{
    clq_crowd *made = nullptr;
    check(clq_crowd_create(context, nullptr, &made));
    const Own<clq_crowd> crowd(made);
    const DragonPaths ways(made);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = dragon;
    clq_actor actor = {};
    check(clq_actor_create(made, &def, &actor));
    Spheres spheres = {};
    clq_actor_info info = clq_actor_info_init();
    for (uint32_t way = 0; way < static_cast<uint32_t>(PathKind::count); ++way) {
        ways.send(actor, static_cast<PathKind>(way), 0);
        check(clq_actor_get_info(made, actor, &info));
        spheres.refpoint[way] = static_cast<double>(info.refpoint_radius);
    }
    clq_template_info about = clq_template_info_init();
    check(clq_template_get_info(dragon, &about));
    spheres.sklsroot = static_cast<double>(info.sklsroot_radius);
    spheres.sklsroot_centre = {static_cast<double>(about.sklsroot_centre[0]),
                               static_cast<double>(about.sklsroot_centre[1]),
                               static_cast<double>(about.sklsroot_centre[2])};
    return spheres;
}

}  // namespace scenes::hundred
