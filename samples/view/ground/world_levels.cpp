// Levels of detail side by side.
#include <algorithm>
#include <cmath>

#include "samples/view/ground/ground_panels.h"
#include "samples/view/ground/save.h"

namespace view
{

const Findings *World::findings(const clq_template *tmpl) const
{
    const auto found = findings_.find(tmpl);
    return found == findings_.end() ? nullptr : &found->second;
}

void World::show_levels(Model &model)
{
    clq_actor_info info = clq_actor_info_init();
    const bool picked = find(model.picked.actor, info);
    if (model.ground.examine && picked && findings_.count(info.tmpl) == 0) {
        try {
            const std::string character = character_of(*this, info.tmpl);
            if (!opened_.asset_of) throw scenes::Failure(character + " cannot be read again to be examined");
            findings_.emplace(info.tmpl, examine(*library_, info.tmpl, opened_.asset_of(*library_, character)));
        } catch (const scenes::Failure &failure) {
            model.message = failure.what();
        }
    }
    model.ground.examine = false;
    const Findings *found = picked ? findings(info.tmpl) : nullptr;
    if (!found || !model.ground.level_row) {
        level_row_.reset();
        return;
    }
    const bool same =
        level_row_of_.index1 == model.picked.actor.index1 && level_row_of_.generation == model.picked.actor.generation;
    if (!level_row_ || !same) {
        clq_template *levelled = found->levelled.get();
        for (clq_template *one : templates_)
            if (!found->levelled && one == info.tmpl) levelled = one;
        for (const auto &renderer : renderers_)
            if (renderer) scenes::check(clq_renderer_prepare(renderer.get(), levelled));
        const double wide =
            std::fabs(static_cast<double>(info.transform.scale) * static_cast<double>(info.sklsroot_radius));
        level_row_ = std::make_unique<LevelRow>(*library_, levelled, workbench_->place_of(model.picked.actor, info),
                                                std::max(0.3, 0.8 * wide), info.play, info.texture_set,
                                                colours(model.picked.actor));
        level_row_of_ = model.picked.actor;
    }
    level_row_->update(camera_, time_s_);
}

void level_marks(Ui &ui, const World &world)
{
    if (!world.level_row()) return;
    const std::vector<clq_transform> &places = world.level_row()->places();
    for (size_t level = 0; level < places.size(); ++level) {
        double x = 0, y = 0;
        const double *p = places[level].position;
        if (!project(world.camera(), {p[0], p[1], p[2]}, x, y)) continue;
        const float px = static_cast<float>((x + 1) / 2 * world.width()),
                    py = static_cast<float>((1 - y) / 2 * world.height());
        if (px < 0 || py < 0 || px >= static_cast<float>(world.width()) || py >= static_cast<float>(world.height()))
            continue;
        ui.mark(px, py, std::to_string(level));
    }
}

}  // namespace view
