#include "samples/scenes/cast.h"

#include <cmath>

namespace scenes
{

Cast::Cast(Library &library, const Casting &casting)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = casting.cache;
    def.cache_budget_bytes = casting.cache_budget_bytes;
    def.seed = casting.seed;
    def.cull = casting.cull;
    def.placement = casting.placement;
    def.geometry = casting.geometry;
    def.key_poses = casting.key_poses;
    def.lod_scale = casting.lod_scale;
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), &def, &made));
    crowd_.reset(made);
}

clq_actor Cast::add(const Part &part, uint64_t seed)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = part.tmpl;
    def.place = part.place;
    def.play = part.play;
    def.seed = seed;
    def.texture_set = CLQ_BY_LOT;
    clq_actor actor = {};
    check(clq_actor_create(crowd_.get(), &def, &actor));
    actors_.push_back(actor);
    places_.push_back(part.place);
    return actor;
}

void Cast::enter(const Part &part)
{
    check(clq_actor_draw_colours(crowd_.get(), add(part, actors_.size()), nullptr, 0));
}

void Cast::enter(const Part &part, uint64_t seed, const std::vector<clq_hsb_range> &dyes)
{
    check(clq_actor_draw_colours(crowd_.get(), add(part, seed), dyes.data(), static_cast<uint32_t>(dyes.size())));
}

void Cast::play(size_t who, const clq_play &play) { check(clq_actor_play(crowd_.get(), actors_[who], &play)); }

void Cast::move()
{
    check(clq_crowd_place(crowd_.get(), actors_.data(), places_.data(), static_cast<uint32_t>(actors_.size())));
}

clq_place stand(double x, double y, double z, double facing_x, double facing_z, float scale)
{
    clq_place place = {};
    place.position[0] = x;
    place.position[1] = y;
    place.position[2] = z;
    const double length = std::sqrt(facing_x * facing_x + facing_z * facing_z);
    const double s = length > 0 ? facing_x / length : 0, c = length > 0 ? facing_z / length : 1;
    // Half the angle about the upright axis, from its sine and cosine: no arc tangent, which processors round apart.
    const double half_c = std::sqrt(std::fmax(0.0, (1 + c) / 2));
    const double half_s = std::sqrt(std::fmax(0.0, (1 - c) / 2)) * (s < 0 ? -1 : 1);
    place.orientation_xyzw[1] = static_cast<float>(half_s);
    place.orientation_xyzw[3] = static_cast<float>(half_c);
    place.scale = scale;
    return place;
}

}  // namespace scenes
