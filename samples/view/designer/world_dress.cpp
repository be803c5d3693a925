// How a world follows its designer.
#include "samples/scenes/social_classes.h"
#include "samples/view/designer/line_up.h"
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

void World::dress(Model &model)
{
    if (model.tint != Tint::nothing || dresser_.idle(model.designer)) return;
    const double start = now_s();
    const auto *social = dynamic_cast<const scenes::SocialClasses *>(scene_.get());
    const auto called = [&](size_t who) { return social ? social->class_of(who) : std::string(); };
    std::string why_not;
    const size_t changed =
        dresser_.dress(context(), crowd(), social ? scene_->actors() : everyone(), called, model.designer, why_not);
    if (changed == 0) return;
    model.designer.changed_people = changed;
    model.designer.changed_ms = ms_since(start);
    if (!why_not.empty()) model.message = why_not;
}

}  // namespace view
