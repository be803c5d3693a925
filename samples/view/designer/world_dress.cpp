// How a world follows its designer.
#include <cmath>

#include "samples/scenes/social_classes.h"
#include "samples/view/designer/line_up.h"
#include "samples/view/designer/painting.h"
#include "samples/view/world.h"

namespace view
{

// Returns false if the scene has to be made anew for it.
bool World::count_people(uint32_t wanted)
{
    people_ = wanted;
    Countable *countable = dynamic_cast<Countable *>(scene_.get());
    if (!countable || wanted == 0) return false;
    countable->set_count(wanted);
    return true;
}

Painted paint_templates(scenes::Library &library, Opened &opened, scenes::Lod lod, const std::vector<SharedMap> &maps)
{
    Painted painted;
    std::map<std::string, scenes::Own<clq_asset>> assets;
    try {
        for (const SharedMap &map : maps) {
            if (!opened.asset_of) throw scenes::Failure("the characters of this scene cannot be painted");
            scenes::Own<clq_asset> &asset = assets[map->tmpl];
            if (!asset) asset = opened.asset_of(library, map->tmpl);
            give_zones(library.context(), asset.get(), *map);
        }
        for (const auto &[name, asset] : assets) {
            clq_template *made = nullptr;
            scenes::check(clq_asset_build(library.context(), asset.get(), 0, &made));
            scenes::Own<clq_template> owner(made);
            clq_template_info info = clq_template_info_init();
            scenes::Character &shown = opened.options.character;
            if (shown.tmpl && clq_template_get_info(shown.tmpl, &info) == CLQ_OK && info.name == name) {
                shown.tmpl = made;
                painted.kept.push_back(std::move(owner));
                continue;
            }
            library.own(lod == scenes::Lod::on ? name + " in levels" : name, [&] { return std::move(owner); });
        }
    } catch (const scenes::Failure &failure) {
        painted.failure = failure.what();
    }
    return painted;
}

void World::propose(Model &model)
{
    Designer &designer = model.designer;
    designer.wishes.propose = false;
    if (!opened_.asset_of || !designer.picture) return;
    try {
        const scenes::Own<clq_asset> asset = opened_.asset_of(*library_, designer.tmpl);
        const auto most = static_cast<uint32_t>(std::lround(designer.brush.most_zones));
        set_zone_map(designer, proposed(asset.get(), *designer.picture->painted(), most), "");
    } catch (const scenes::Failure &failure) {
        designer.paint_failure = failure.what();
    }
}

void World::dress(Model &model)
{
    if (model.tint != Tint::nothing) return;
    if (dresser_.idle(model.designer)) {
        model.designer.why_not.clear();  // of a design that was undone when the crowd was made anew
        return;
    }
    const double start = now_s();
    const auto *social = dynamic_cast<const scenes::SocialClasses *>(scene_.get());
    const auto called = [&](size_t person) { return social ? social->class_of(person) : std::string(); };
    std::string why_not;
    const size_t changed =
        dresser_.dress(context(), crowd(), social ? scene_->actors() : everyone(), called, model.designer, why_not);
    if (changed == 0) return;
    model.designer.changed_people = changed;
    model.designer.changed_ms = ms_since(start);
    model.designer.why_not = why_not;
}

}  // namespace view
