// clq_asset_...: characters from files and built-in ones, and the templates built from them.
#include <claque/assets.h>

#include <memory>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/assets/assets_helpers.h"
#include "lib/api/assets/placement.h"
#include "lib/api/boundary.h"
#include "lib/api/build_id.h"
#include "lib/api/model_entry.h"
#include "lib/asset/bvh.h"
#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "lib/base/near_names.h"
#include "lib/figures/figure.h"

using namespace claque;

namespace
{

asset::LoadOptions options_of(const clq_asset_options &options)
{
    asset::LoadOptions out;
    api::check_placement(options);
    if (options.base_folder) out.base_folder = options.base_folder;
    api::require(options.hidden_nodes || options.hidden_node_count == 0, "hidden_nodes is NULL with a count");
    for (uint32_t i = 0; i < options.hidden_node_count; ++i) {
        api::require(options.hidden_nodes[i] != nullptr, "a hidden node's name is NULL");
        out.hidden_nodes.push_back(options.hidden_nodes[i]);
    }
    if (options.bvh_metres_per_unit != 0) out.motion_unit_m = options.bvh_metres_per_unit;
    out.strict = options.strict;
    api::require(api::number_of(options.blend) <= CLQ_BLEND_MASK, "blend is none of CLQ_BLEND_...");
    out.blend = static_cast<asset::Blend>(options.blend);
    api::require(api::number_of(options.colours) <= CLQ_COLOURS_OWN, "colours is none of CLQ_COLOURS_...");
    out.colours = static_cast<asset::Colours>(options.colours);
    if (options.memory_limit_bytes) out.memory_limit_bytes = options.memory_limit_bytes;
    return out;
}

// A character of a file.
struct Loaded {
    model::Model model;
    double own_turn_deg = 0;
};

// Makes the handle of a parsed model and logs the warnings of parsing. `of`: the file and a colon, or nothing.
clq_asset *finish(clq_context *context, model::Model &&model, const std::string &of = "")
{
    auto made = std::make_unique<clq_asset>(std::move(model));
    for (const std::string &warning : made->model.warnings)
        clq_context_log(context, CLQ_LOG_WARNING, (of + warning).c_str());
    return made.release();
}

clq_asset *finish(clq_context *context, Loaded &&loaded, const clq_asset_options &options, const std::string &of = "")
{
    const bool placed = api::place(loaded.model, loaded.own_turn_deg, options);
    clq_asset *asset = finish(context, std::move(loaded.model), of);
    asset->placed = placed;
    asset->colours = static_cast<asset::Colours>(options.colours);
    return asset;
}

Loaded load(const uint8_t *bytes, size_t size, const asset::LoadOptions &options)
{
    Loaded out;
    out.model = asset::is_bvh(bytes, size) ? asset::load_bvh(bytes, size, options)
                                           : asset::load_gltf(bytes, size, options, &out.own_turn_deg);
    return out;
}

model::Model made_of(const std::vector<figures::Builtin> &figures, const char *what, const char *name)
{
    std::vector<std::string_view> names;
    for (const figures::Builtin &figure : figures) {
        if (std::string_view(name) == figure.name) return figure.make();
        names.emplace_back(figure.name);
    }
    base::fail(CLQ_ARGUMENT, "there is no %s '%s'%s", what, name, base::names_near(name, names).c_str());
}

std::string stem_of(const std::string &path)
{
    const size_t slash = path.find_last_of('/');
    const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
    return file.substr(0, file.find_last_of('.'));
}

}  // namespace

extern "C" {

clq_status clq_asset_load(clq_context *context, const void *bytes, size_t size_bytes, const clq_asset_options *options,
                          clq_asset **out)
{
    return api::boundary("clq_asset_load", [&] {
        api::require(context && bytes && out, "context, bytes or out is NULL");
        const clq_asset_options wanted = api::read_def(options, clq_asset_options_init, "clq_asset_options_init");
        *out = finish(context, load(static_cast<const uint8_t *>(bytes), size_bytes, options_of(wanted)), wanted);
    });
}

clq_status clq_asset_load_file(clq_context *context, const char *path, const clq_asset_options *options,
                               clq_asset **out)
{
    return api::boundary("clq_asset_load_file", [&] {
        api::require(context && path && out, "context, path or out is NULL");
        const clq_asset_options given = api::read_def(options, clq_asset_options_init, "clq_asset_options_init");
        asset::LoadOptions wanted = options_of(given);
        if (wanted.base_folder.empty()) wanted.base_folder = api::folder_of(path);
        const std::vector<uint8_t> bytes = asset::read_file(path, wanted.memory_limit_bytes);
        try {
            Loaded loaded = load(bytes.data(), bytes.size(), wanted);
            if (loaded.model.name.empty()) loaded.model.name = stem_of(path);
            if (asset::is_bvh(bytes.data(), bytes.size()))
                for (std::pmr::string &name : loaded.model.rig.clip_names) name = stem_of(path).c_str();
            *out = finish(context, std::move(loaded), given, std::string(path) + ": ");
        } catch (const base::Error &error) {
            base::fail(error.status(), "%s: %s", path, error.what());
        }
    });
}

clq_status clq_asset_builtin(clq_context *context, const char *name, clq_asset **out)
{
    return api::boundary("clq_asset_builtin", [&] {
        api::require(context && name && out, "context, name or out is NULL");
        *out = finish(context, made_of(figures::builtins(), "built-in character", name));
    });
}

clq_status clq_asset_builtin_varied(clq_context *context, const char *name, uint32_t clip_count, clq_asset **out)
{
    return api::boundary("clq_asset_builtin_varied", [&] {
        api::require(context && name && out, "context, name or out is NULL");
        model::Model model = made_of(figures::people(), "built-in person", name);
        const uint32_t own = static_cast<uint32_t>(model.rig.clips.size());
        if (clip_count < own || clip_count > figures::max_clips)
            base::fail(CLQ_ARGUMENT, "%u clips: %u to %u are wanted", clip_count, own, figures::max_clips);
        figures::add_variants(model, clip_count);
        *out = finish(context, std::move(model));
    });
}

void clq_asset_destroy(clq_asset *asset) { delete asset; }

clq_status clq_asset_build(clq_context *context, const clq_asset *asset, uint32_t max_texture_px, clq_template **out)
{
    if (!context || !asset || !out) return clq_report(CLQ_ARGUMENT, "clq_asset_build: context, asset or out is NULL");
    clq_status status = CLQ_OK;
    const clq_status named = api::boundary("clq_asset_build", [&] {
        const std::string build_id = api::build_id_of(api::assets_sources());
        status = clq_private_template_from_model(context, build_id.c_str(), &asset->model, max_texture_px, out);
    });
    return named != CLQ_OK ? named : status;
}

}  // extern "C"
