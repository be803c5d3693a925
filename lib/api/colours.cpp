// Colour maps, and the colours that individuals get from them.
#include <claque/colours.h>

#include <cstring>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"
#include "lib/crowd/colour_map.h"

using namespace claque;

struct clq_colour_map {
    clq_colour_map(clq_context *owner, const clq_colour_map_def &def) : context(owner), map(&owner->memory, def) {}
    clq_context *context;
    crowd::ColourMap map;
};

namespace
{

template <class Same>
uint32_t find_class(const clq_colour_map *map, const char *name, const Same &name_of)
{
    if (!map || !name) return CLQ_NONE;
    const clq_colour_map_def &def = map->map.def();
    for (uint32_t i = 0; i < def.class_count; ++i)
        if (std::strcmp(api::name_of(name_of(def.classes[i])), name) == 0) return i;
    return CLQ_NONE;
}

void require_zones(uint32_t zone_count, const model::Template &tmpl)
{
    if (zone_count != tmpl.zone_count())
        base::fail(CLQ_ARGUMENT, "room for %u zones was given; template '%s' has %u", zone_count, tmpl.name.c_str(),
                   tmpl.zone_count());
}

}  // namespace

extern "C" {

clq_status clq_colour_map_create(clq_context *context, const clq_colour_map_def *def, clq_colour_map **out)
{
    return api::boundary("clq_colour_map_create", [&] {
        api::require(context && def && out, "context, def or out is NULL");
        const clq_colour_map_def wanted = api::read_def(def, clq_colour_map_def_init, "clq_colour_map_def_init");
        *out = api::Making<clq_colour_map>(context, context, wanted).release();
    });
}

void clq_colour_map_destroy(clq_colour_map *map)
{
    if (map) api::unmake(map->context, map);
}

clq_status clq_colour_map_get_def(const clq_colour_map *map, clq_colour_map_def *out)
{
    return api::boundary("clq_colour_map_get_def", [&] {
        api::require(map && out, "map or out is NULL");
        api::require_size(*out, "clq_colour_map_def_init");
        api::write_out(out, map->map.def());
    });
}

uint32_t clq_colour_map_find(const clq_colour_map *map, const char *class_name)
{
    return find_class(map, class_name, [](const clq_colour_class &one) { return one.name; });
}

uint32_t clq_colour_map_find_template(const clq_colour_map *map, const char *template_name)
{
    if (template_name && !*template_name) return CLQ_NONE;
    return find_class(map, template_name, [](const clq_colour_class &one) { return one.tmpl; });
}

clq_status clq_crowd_randomise_colours(clq_crowd *crowd, const clq_colour_map *map, uint32_t colour_class,
                                       const clq_actor *actors, uint32_t actor_count)
{
    return api::boundary("clq_crowd_randomise_colours", [&] {
        api::require(crowd && map, "crowd or map is NULL");
        api::require_array(actors, actor_count, "actors");
        const api::Busy busy(crowd);
        std::pmr::vector<crowd::Id> ids(&crowd->context->memory);
        ids.reserve(actor_count);
        for (uint32_t i = 0; i < actor_count; ++i) ids.push_back(api::id_of(actors[i]));
        crowd::randomise_colours(crowd->crowd, ids.data(), actor_count, map->map, colour_class);
        api::changed_by(crowd, [&](api::Recorder &to) { to.colours(actors, actor_count); });
    });
}

clq_status clq_colour_map_sample(const clq_colour_map *map, const clq_colour_sample_def *def, float *out_rgb,
                                 uint32_t zone_count)
{
    return api::boundary("clq_colour_map_sample", [&] {
        api::require(map && def && (out_rgb || zone_count == 0), "map, def or out_rgb is NULL");
        const clq_colour_sample_def wanted =
            api::read_def(def, clq_colour_sample_def_init, "clq_colour_sample_def_init");
        api::require(wanted.tmpl != nullptr, "tmpl is NULL");
        require_zones(zone_count, *wanted.tmpl);
        const crowd::ColourRecipe recipe(&map->context->memory, map->map, wanted.colour_class, *wanted.tmpl);
        for (uint32_t zone = 0; zone < zone_count; ++zone) {
            double rgb[3];
            recipe.sample(zone, wanted.crowd_seed, wanted.actor_seed, rgb);
            for (int k = 0; k < 3; ++k) out_rgb[3 * zone + k] = static_cast<float>(rgb[k]);
        }
    });
}

clq_status clq_actor_get_colours(const clq_crowd *crowd, clq_actor actor, float *out_rgb, uint32_t zone_count)
{
    return api::boundary("clq_actor_get_colours", [&] {
        api::require(crowd && (out_rgb || zone_count == 0), "crowd or out_rgb is NULL");
        const api::Reading reading(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const model::Template &tmpl = crowd->crowd.template_of(row);
        require_zones(zone_count, tmpl);
        const uint8_t *own = crowd->crowd.zone_rgb(row);
        for (uint32_t zone = 0; zone < zone_count; ++zone)
            for (uint32_t k = 0; k < 3; ++k)
                out_rgb[3 * zone + k] =
                    own ? static_cast<float>(own[3 * zone + k]) / 255.0f : tmpl.zone_colours[zone][k];
    });
}

}  // extern "C"
