// Prepared templates: found on disk by a hash of what they were made from, or made and stored.
#include <claque/prepare.h>

#include <cstdio>
#include <string>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/assets/kept_template.h"
#include "lib/api/boundary.h"

using namespace claque;

namespace
{

void check(const clq_prepare_def &def)
{
    api::require((def.builtin != nullptr) != (def.path != nullptr), "either builtin or path is wanted, not both");
    api::require(def.builtin || def.clip_count == 0, "clip_count needs builtin");
    api::require(def.path || !def.options, "options go with path alone");
    api::require_array(def.dofs, def.dof_count, "degrees of freedom");
    api::require_array(def.zone_maps, def.zone_map_count, "zone_maps");
    for (uint32_t i = 0; i < def.zone_map_count; ++i) {
        api::require(def.zone_maps[i] != nullptr, "a zone map is NULL");
        const clq_zone_map_def &map = *def.zone_maps[i];
        api::require_size(map, "clq_zone_map_def_init");
        api::require(map.texels != nullptr, "texels of a zone map are NULL");
        api::require_array(map.zones, map.zone_count, "zones of a zone map");
    }
}

void add_levels(const clq_levels_def &levels, asset::ContentHash &all)
{
    api::require_array(levels.targets, levels.target_count, "targets");
    all.add(levels.targets, levels.target_count * sizeof *levels.targets);
    all.add(double(levels.tolerance_px));
    all.add(double(levels.metres_per_unit));
    all.add(uint64_t(levels.proxy_max_triangles));
    all.add(uint64_t(levels.quadric_only));
}

void add_dofs(const clq_prepare_def &def, asset::ContentHash &all)
{
    all.add(uint64_t(def.dof_count));
    for (uint32_t i = 0; i < def.dof_count; ++i) {
        const clq_asset_dof &one = def.dofs[i];
        const clq_dof_def &dof = one.dof;
        all.add(std::string(api::name_of(one.node_name)));
        all.add(std::string(api::name_of(dof.name)));
        all.add(uint64_t(api::number_of(dof.kind)));
        all.add(uint64_t(dof.morph_target));
        for (const float value : {dof.axis[0], dof.axis[1], dof.axis[2], dof.min, dof.max, dof.rest})
            all.add(double(value));
    }
}

// Nothing where there is no map, so that templates without one keep their names.
void add_zone_maps(const clq_prepare_def &def, asset::ContentHash &all)
{
    for (uint32_t i = 0; i < def.zone_map_count; ++i) {
        const clq_zone_map_def &map = *def.zone_maps[i];
        all.add(uint64_t(map.image));
        all.add(uint64_t(map.width_px));
        all.add(map.texels, uint64_t(map.width_px) * map.height_px * sizeof *map.texels);
        all.add(uint64_t(map.zone_count));
        for (uint32_t z = 0; z < map.zone_count; ++z) {
            const clq_zone_map_zone &zone = map.zones[z];
            all.add(std::string(api::name_of(zone.name)));
            all.add(uint64_t(zone.reduced));
            all.add(zone.range, zone.range ? sizeof *zone.range : 0);
        }
    }
}

asset::ContentHash name_of(const clq_prepare_def &def)
{
    asset::ContentHash all = api::start_of_name();
    if (def.builtin) {
        all.add(std::string(def.builtin));
        all.add(uint64_t(def.clip_count));
    } else {
        const clq_asset_options options = api::read_def(def.options, clq_asset_options_init, "clq_asset_options_init");
        const std::string folder = options.base_folder ? options.base_folder : api::folder_of(def.path);
        asset::add_file(def.path, folder, api::limit_of(options), all);
        // the file name names the template
        all.add(std::string(def.path).substr(std::string(def.path).find_last_of('/') + 1));
        api::add_options(options, all);
    }
    all.add(uint64_t(def.levels != nullptr));
    if (def.levels) add_levels(api::read_def(def.levels, clq_levels_def_init, "clq_levels_def_init"), all);
    all.add(uint64_t(def.max_texture_px));
    if (def.dof_count) add_dofs(def, all);
    add_zone_maps(def, all);
    return all;
}

api::Asset asset_of(clq_context *context, const clq_prepare_def &def)
{
    clq_asset *made = nullptr;
    if (def.path) api::pass_on(clq_asset_load_file(context, def.path, def.options, &made));
    else if (def.clip_count) api::pass_on(clq_asset_builtin_varied(context, def.builtin, def.clip_count, &made));
    else api::pass_on(clq_asset_builtin(context, def.builtin, &made));
    return api::Asset(made);
}

api::Template made_anew(clq_context *context, const clq_prepare_def &def)
{
    const api::Asset asset = asset_of(context, def);
    if (def.dof_count) api::pass_on(clq_asset_add_dofs(context, asset.get(), def.dofs, def.dof_count));
    for (uint32_t i = 0; i < def.zone_map_count; ++i)
        api::pass_on(clq_asset_set_zone_map(context, asset.get(), def.zone_maps[i]));
    if (def.levels) api::pass_on(clq_asset_make_levels(context, asset.get(), def.levels, nullptr));
    clq_template *made = nullptr;
    api::pass_on(clq_asset_build(context, asset.get(), def.max_texture_px, &made));
    return api::Template(made);
}

}  // namespace

extern "C" clq_status clq_template_prepare(clq_context *context, const clq_prepare_def *def, clq_template **out,
                                           clq_prepare_report *out_report)
{
    return api::boundary("clq_template_prepare", [&] {
        api::require(context && def && out, "context, def or out is NULL");
        if (out_report) api::require_size(*out_report, "clq_prepare_report_init");
        const clq_prepare_def wanted = api::read_def(def, clq_prepare_def_init, "clq_prepare_def_init");
        check(wanted);
        if (wanted.options) api::require_size(*wanted.options, "clq_asset_options_init");
        if (wanted.levels) api::require_size(*wanted.levels, "clq_levels_def_init");
        const bool installed = wanted.builtin && !wanted.folder;
        const std::string folder = wanted.folder ? wanted.folder : asset::user_cache_folder();
        const auto make = [&] { return made_anew(context, wanted); };
        const bool has_name = installed || !folder.empty();
        api::KeptTemplate kept =
            api::kept_template(context, installed, folder, has_name ? name_of(wanted) : asset::ContentHash(), make);
        clq_prepare_report found = clq_prepare_report_init();
        found.from_disk = kept.from_disk, found.stored = kept.stored;
        const char *const no_folder =
            wanted.folder ? "no folder was given" : "neither XDG_CACHE_HOME nor HOME is an absolute path";
        const bool needs_folder = folder.empty() && !kept.from_disk;
        std::snprintf(found.text, sizeof found.text, "%s", needs_folder ? no_folder : kept.why_not_stored.c_str());
        if (out_report) api::write_out(out_report, found);
        *out = kept.tmpl.release();
    });
}
