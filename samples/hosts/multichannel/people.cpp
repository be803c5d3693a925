#include "samples/hosts/multichannel/people.h"

#include <cmath>

#include "samples/hosts/multichannel/forum.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace multichannel
{
namespace
{

using namespace scenes;

constexpr uint64_t people_seed = 11;
constexpr double pi = 3.141592653589793;
constexpr double stride_m = 1.24;  // length of a walk cycle at speed 1

clq_transform at(double radius, double turn, double facing_x, double facing_z, double scale)
{
    return stand(radius * std::sin(turn), 0, -radius * std::cos(turn), facing_x, facing_z, static_cast<float>(scale));
}

}  // namespace

People::People(Library &library)
{
    const char *const names[] = {"citizen", "patrician", "decurion", "plebeian"};
    for (size_t i = 0; i < templates_.size(); ++i) templates_[i] = library.builtin(names[i]);
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &crowd));
    crowd_.reset(crowd);
    stand_rows();
    walk_rings();
    place(0);
}

size_t People::enter(const clq_transform &place, const char *clip)
{
    const uint64_t person = actors_.size();
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = templates_[random_bits(people_seed, person, Purpose::group_size) % templates_.size()];
    def.transform = place;
    def.seed = person;
    def.play.clip = clq_template_find_clip(def.tmpl, clip);
    def.play.phase_s = static_cast<float>(random_between(people_seed, person, Purpose::phase, 0, 6));
    clq_actor actor = {};
    check(clq_actor_create(crowd_.get(), &def, &actor));
    check(clq_actor_randomise_colours(crowd_.get(), actor, nullptr, 0));
    actors_.push_back(actor);
    places_.push_back(place);
    return person;
}

// Facing the eye, or nearly.
void People::stand_rows()
{
    constexpr double first_m = 9, step_m = 1.5;
    constexpr const char *clips[] = {"stand_applaud", "stand_wave", "stand_cheer", "stand", "stand_laugh", "applaud"};
    for (int row = 0; row < 6; ++row) {
        const double radius = first_m + row * step_m;
        const int seats = static_cast<int>(1.32 * pi * radius / 1.25);
        for (int i = 0; i < seats; ++i) {
            const uint64_t person = actors_.size();
            const double turn = (-0.66 + 1.32 * (i + 0.5 * (row % 2)) / seats) * pi +
                                random_between(people_seed, person, Purpose::place_x, -0.2, 0.2) / radius;
            const double set_camera = turn + random_between(people_seed, person, Purpose::heading, -0.35, 0.35);
            enter(at(radius + random_between(people_seed, person, Purpose::place_z, -0.2, 0.2), turn,
                     -std::sin(set_camera), std::cos(set_camera),
                     random_between(people_seed, person, Purpose::size, 0.94, 1.06)),
                  clips[random_bits(people_seed, person, Purpose::clip) % 6]);
        }
    }
}

void People::walk_rings()
{
    constexpr double radii_m[] = {4.6, 6.2, 20.5};
    for (int ring = 0; ring < 3; ++ring) {
        const int count = ring < 2 ? 7 : 40;
        for (int i = 0; i < count; ++i) {
            const size_t person = enter(at(radii_m[ring], 0, 1, 0, 1), "walk");
            clq_clip_info walk = clq_clip_info_init();
            const clq_template *tmpl =
                templates_[random_bits(people_seed, person, Purpose::group_size) % templates_.size()];
            check(clq_template_get_clip(tmpl, clq_template_find_clip(tmpl, "walk"), &walk));
            const double speed = stride_m / static_cast<double>(walk.duration_s);
            walkers_.push_back({person, radii_m[ring],
                                2 * pi * (i + random_between(people_seed, person, Purpose::gap, -0.2, 0.2)) / count,
                                ring % 2 == 0 ? speed : -speed});
        }
    }
}

void People::place(double time_s)
{
    for (const Walker &w : walkers_) {
        const double turn = w.start_rad + time_s * w.speed_mps / w.radius_m, way = w.speed_mps < 0 ? -1 : 1;
        places_[w.person] = at(w.radius_m, turn, way * std::cos(turn), way * std::sin(turn), 1);
    }
    check(
        clq_crowd_set_transforms(crowd_.get(), actors_.data(), places_.data(), static_cast<uint32_t>(actors_.size())));
}

}  // namespace multichannel
