// Colours of individuals sampled from a class of a map, all or none (S2 5.2).
#include "lib/crowd/colour_map.h"
#include "lib/crowd/edits.h"
#include "lib/math/hsb.h"

namespace claque::crowd
{

namespace
{

// The class resolved for one template, and how many of its actors have no colours of their own yet.
struct TemplateRecipe {
    uint32_t tmpl;
    uint32_t new_slots;
    ColourRecipe recipe;
};

TemplateRecipe *recipe_for(std::pmr::vector<TemplateRecipe> &recipes, uint32_t tmpl)
{
    for (TemplateRecipe &one : recipes)
        if (one.tmpl == tmpl) return &one;
    return nullptr;
}

}  // namespace

void randomise_colours(Crowd &crowd, const Id *ids, uint32_t count, const ColourMap &map, uint32_t colour_class)
{
    // All that may fail comes first: ids and palettes, then room.
    Tables &tables = crowd.tables;
    std::pmr::vector<TemplateRecipe> recipes(crowd.memory());
    for (uint32_t i = 0; i < count; ++i) {
        const Actor &actor = crowd.actor(crowd.row_of(ids[i]));
        const model::Template &tmpl = *tables.templates[actor.tmpl];
        if (!recipe_for(recipes, actor.tmpl))
            recipes.push_back({actor.tmpl, 0, ColourRecipe(crowd.memory(), map, colour_class, tmpl)});
        if (actor.colours == model::none) ++recipe_for(recipes, actor.tmpl)->new_slots;
    }
    for (const TemplateRecipe &one : recipes)
        if (one.recipe.zone_count() > 0) tables.colours[one.tmpl].reserve(one.new_slots);

    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        const Actor &actor = crowd.actor(row);
        const ColourRecipe &recipe = recipe_for(recipes, actor.tmpl)->recipe;
        uint8_t *to = recipe.zone_count() > 0 ? make_colours(tables, row) : nullptr;
        for (uint32_t zone = 0; zone < recipe.zone_count(); ++zone) {
            double rgb[3];
            recipe.sample(zone, crowd.seed(), actor.seed, rgb);
            const math::Rgb8 rounded = math::rgb8_of(rgb);
            to[3 * zone] = rounded.r, to[3 * zone + 1] = rounded.g, to[3 * zone + 2] = rounded.b;
        }
    }
}

}  // namespace claque::crowd
