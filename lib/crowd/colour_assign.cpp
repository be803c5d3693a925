// Colours of individuals out of a class of a map, all or none (S2 5.2).
#include "lib/crowd/colour_map.h"
#include "lib/crowd/crowd.h"
#include "lib/math/hsb.h"

namespace claque::crowd
{

void Crowd::randomise_colours(const Id *ids, uint32_t count, const ColourMap &map, uint32_t colour_class)
{
    // Everything that may fail comes first: ids and recipes, then room.
    struct TemplateRecipe {
        uint32_t tmpl;
        ColourRecipe recipe;
    };
    std::pmr::vector<TemplateRecipe> recipes(memory());
    const auto recipe_of = [&](uint32_t tmpl) -> const ColourRecipe & {
        for (const TemplateRecipe &one : recipes)
            if (one.tmpl == tmpl) return one.recipe;
        recipes.push_back({tmpl, ColourRecipe(memory(), map, colour_class, *templates_[tmpl])});
        return recipes.back().recipe;
    };
    for (uint32_t i = 0; i < count; ++i) recipe_of(actors_[row_of(ids[i])].tmpl);
    std::pmr::vector<uint32_t> new_slots(memory());
    new_slots.reserve(count);
    try {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t row = ids[i].index1 - 1;
            if (actors_[row].colours != model::none || template_of(row).zone_count() == 0) continue;
            colour_slot(row);
            new_slots.push_back(row);
        }
    } catch (...) {
        for (const uint32_t row : new_slots) {
            colours_[actors_[row].tmpl].give_back(actors_[row].colours);
            actors_[row].colours = model::none;
        }
        throw;
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        const ColourRecipe &recipe = recipe_of(actors_[row].tmpl);
        for (uint32_t zone = 0; zone < recipe.zone_count(); ++zone) {
            double rgb[3];
            recipe.sample(zone, seed_, actors_[row].seed, rgb);
            const math::Rgb8 rounded = math::rgb8_of(rgb);
            uint8_t *to = colours_[actors_[row].tmpl].row(actors_[row].colours) + 3 * zone;
            to[0] = rounded.r, to[1] = rounded.g, to[2] = rounded.b;
        }
    }
}

}  // namespace claque::crowd
