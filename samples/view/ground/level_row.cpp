#include "samples/view/ground/level_row.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/roles/performer.h"

namespace view
{
namespace
{

// So large that the priority of each actor chooses its level at any distance.
constexpr float lod_scale = 1000;

}  // namespace

using scenes::check;

LevelRow::LevelRow(scenes::Library &library, clq_template *tmpl, const clq_transform &place, double step_m,
                   const clq_play &play, uint32_t texture_set, const std::vector<uint8_t> &rgb)
    : tmpl_(tmpl)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.lod_scale = lod_scale;
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), &def, &made));
    crowd_.reset(made);
    check(clq_view_create(made, &view_));
    check(clq_view_set_height(view_, 0));
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    const double heading = scenes::roles::home_of(place).heading_rad;
    std::vector<float> colours;
    for (const uint8_t byte : rgb) colours.push_back(static_cast<float>(byte) / 255);
    for (uint32_t level = 0; level < info.level_count; ++level) {
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = tmpl, actor_def.transform = place, actor_def.play = play, actor_def.texture_set = texture_set;
        actor_def.transform.position[0] += std::cos(heading) * step_m * (level + 1);
        actor_def.transform.position[2] -= std::sin(heading) * step_m * (level + 1);
        clq_actor actor = {};
        check(clq_actor_create(made, &actor_def, &actor));
        if (!colours.empty())
            check(clq_actor_set_colours(made, actor, colours.data(), static_cast<uint32_t>(colours.size() / 3)));
        actors_.push_back(actor);
        places_.push_back(actor_def.transform);
    }
}

void LevelRow::update(const clq_camera &camera, double time_s)
{
    for (uint32_t level = 0; level < actors_.size(); ++level) {
        clq_level_info own = clq_level_info_init(), next = clq_level_info_init();
        check(clq_template_get_level(tmpl_, level, &own));
        const bool last = level + 1 == actors_.size();
        if (!last) check(clq_template_get_level(tmpl_, level + 1, &next));
        const double from = static_cast<double>(own.lod_min_m),
                     to = last ? from * 1.5 + 1 : static_cast<double>(next.lod_min_m);
        double square = 0;
        for (int k = 0; k < 3; ++k)
            square += (camera.eye[k] - places_[level].position[k]) * (camera.eye[k] - places_[level].position[k]);
        const double size = std::fabs(static_cast<double>(places_[level].scale));
        const double away = std::max(0.05, std::sqrt(square)) * static_cast<double>(lod_scale) / size;
        const double priority = level == 0 ? 1 : 1 - (from + to) / 2 / away;
        check(clq_actor_set_priority(crowd_.get(), actors_[level],
                                     static_cast<float>(std::fmin(1.0, std::fmax(0.0, priority)))));
    }
    check(clq_view_set_camera(view_, &camera));
    check(clq_crowd_update(crowd_.get(), time_s, &view_, 1));
}

}  // namespace view
