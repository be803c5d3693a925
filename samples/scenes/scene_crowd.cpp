#include "samples/scenes/scene_crowd.h"

#include <cmath>

namespace scenes
{

SceneCrowd::SceneCrowd(Library &library, const CrowdOptions &crowd_options)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = crowd_options.cache;
    def.cache_budget_bytes = crowd_options.cache_budget_bytes;
    def.seed = crowd_options.seed;
    def.cull = crowd_options.cull;
    def.rigid_mode = crowd_options.rigid_mode;
    def.vertex_format = crowd_options.vertex_format;
    def.key_poses = crowd_options.key_poses;
    def.lod_scale = crowd_options.lod_scale;
    if (crowd_options.exact_poses) def.period_near_s = def.period_far_s = 0;
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), &def, &made));
    crowd_.reset(made);
}

clq_actor SceneCrowd::add(const Part &part, uint64_t seed)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = part.tmpl;
    def.transform = part.place;
    def.play = part.play;
    def.seed = seed;
    def.texture_set = CLQ_RANDOM;
    clq_actor actor = {};
    check(clq_actor_create(crowd_.get(), &def, &actor));
    actors_.push_back(actor);
    places_.push_back(part.place);
    return actor;
}

void SceneCrowd::enter(const Part &part)
{
    check(clq_actor_randomise_colours(crowd_.get(), add(part, actors_.size()), nullptr, 0));
}

void SceneCrowd::enter(const Part &part, uint64_t seed, const std::vector<clq_hsb_range> &palette)
{
    check(clq_actor_randomise_colours(crowd_.get(), add(part, seed), palette.data(),
                                      static_cast<uint32_t>(palette.size())));
}

void SceneCrowd::play(size_t person, const clq_play &play)
{
    check(clq_actor_play(crowd_.get(), actors_[person], &play));
}

void SceneCrowd::move()
{
    check(
        clq_crowd_set_transforms(crowd_.get(), actors_.data(), places_.data(), static_cast<uint32_t>(actors_.size())));
}

clq_transform stand(double x, double y, double z, double facing_x, double facing_z, float scale)
{
    clq_transform place = {};
    place.position[0] = x;
    place.position[1] = y;
    place.position[2] = z;
    const double length = std::sqrt(facing_x * facing_x + facing_z * facing_z);
    const double s = length > 0 ? facing_x / length : 0, c = length > 0 ? facing_z / length : 1;
    // Half the angle about the vertical axis, from its sine and cosine: no arc tangent, which processors round
    // differently.
    const double half_c = std::sqrt(std::fmax(0.0, (1 + c) / 2));
    const double half_s = std::sqrt(std::fmax(0.0, (1 - c) / 2)) * (s < 0 ? -1 : 1);
    place.orientation_xyzw[1] = static_cast<float>(half_s);
    place.orientation_xyzw[3] = static_cast<float>(half_c);
    place.scale = scale;
    return place;
}

}  // namespace scenes
