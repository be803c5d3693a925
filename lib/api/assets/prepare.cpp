// Prepared templates: found on disk by a hash of what they were made from, or made and stored.
#include <claque/prepare.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/boundary.h"
#include "lib/api/build_id.h"
#include "lib/asset/file_cache.h"
#include "lib/model/template_file.h"

using namespace claque;

namespace
{

constexpr uint64_t usual_limit = uint64_t(1) << 30;

struct Destroy {
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
    void operator()(clq_template *tmpl) const { clq_template_destroy(tmpl); }
};
using Asset = std::unique_ptr<clq_asset, Destroy>;
using Template = std::unique_ptr<clq_template, Destroy>;

void check(const clq_prepare_def &def)
{
    api::require((def.builtin != nullptr) != (def.path != nullptr), "either builtin or path is wanted, not both");
    api::require(def.builtin || def.clip_count == 0, "clip_count needs builtin");
    api::require(def.path || !def.options, "options go with path alone");
}

void add_options(const clq_asset_options &options, asset::ContentHash &all)
{
    all.add(uint64_t(options.hidden_node_count));
    for (uint32_t i = 0; options.hidden_nodes && i < options.hidden_node_count; ++i)
        all.add(std::string(api::name_of(options.hidden_nodes[i])));
    all.add(options.bvh_metres_per_unit);
    all.add(uint64_t(options.strict));
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

std::string name_of(const clq_prepare_def &def)
{
    asset::ContentHash all;
    all.add(std::string(api::assets_sources()));
    all.add(uint64_t(model::template_file_version));
    if (def.builtin) {
        all.add(std::string(def.builtin));
        all.add(uint64_t(def.clip_count));
    } else {
        const clq_asset_options options = api::read_def(def.options, clq_asset_options_init, "clq_asset_options_init");
        const std::string folder = options.base_folder ? options.base_folder : api::folder_of(def.path);
        asset::add_file(def.path, folder, options.memory_limit_bytes ? options.memory_limit_bytes : usual_limit, all);
        // the file name names the template
        all.add(std::string(def.path).substr(std::string(def.path).find_last_of('/') + 1));
        add_options(options, all);
    }
    all.add(uint64_t(def.levels != nullptr));
    if (def.levels) add_levels(api::read_def(def.levels, clq_levels_def_init, "clq_levels_def_init"), all);
    all.add(uint64_t(def.max_texture_px));
    return all.hex() + ".claque";
}

Asset asset_of(clq_context *context, const clq_prepare_def &def)
{
    clq_asset *made = nullptr;
    if (def.path) api::pass_on(clq_asset_load_file(context, def.path, def.options, &made));
    else if (def.clip_count) api::pass_on(clq_asset_builtin_varied(context, def.builtin, def.clip_count, &made));
    else api::pass_on(clq_asset_builtin(context, def.builtin, &made));
    return Asset(made);
}

Template made_anew(clq_context *context, const clq_prepare_def &def)
{
    const Asset asset = asset_of(context, def);
    if (def.levels) api::pass_on(clq_asset_make_levels(context, asset.get(), def.levels, nullptr));
    clq_template *made = nullptr;
    api::pass_on(clq_asset_build(context, asset.get(), def.max_texture_px, &made));
    return Template(made);
}

Template from_disk(clq_context *context, const std::string &folder, const std::string &name)
{
    clq_template *loaded = nullptr;
    const std::vector<uint8_t> bytes = asset::read_cached(folder, name);
    if (!bytes.empty()) (void)clq_template_load(context, bytes.data(), bytes.size(), &loaded);
    return Template(loaded);
}

std::string keep(const clq_template &made, const std::string &folder, const std::string &name)
{
    struct Saved {
        std::vector<uint8_t> bytes;
        bool without_memory = false;  // which would be reported as an exception of the host's
    } saved;
    const auto append = [](void *user, const void *more, size_t size) {
        Saved &all = *static_cast<Saved *>(user);
        const auto *first = static_cast<const uint8_t *>(more);
        try {
            all.bytes.insert(all.bytes.end(), first, first + size);
        } catch (const std::bad_alloc &) {
            all.without_memory = true;
        }
        return int(all.without_memory);
    };
    const clq_status status = clq_template_save(&made, append, &saved);
    if (saved.without_memory) throw std::bad_alloc();
    api::pass_on(status);
    return asset::write_cached(folder, name, saved.bytes);
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
        clq_prepare_report found = clq_prepare_report_init();
        const std::string folder = wanted.folder ? wanted.folder : asset::user_cache_folder();
        const std::string name = folder.empty() ? "" : name_of(wanted);
        Template made = folder.empty() ? nullptr : from_disk(context, folder, name);
        found.from_disk = made != nullptr;
        if (!made) {
            made = made_anew(context, wanted);
            const char *const no_folder =
                wanted.folder ? "no folder was given" : "neither XDG_CACHE_HOME nor HOME is an absolute path";
            const std::string why = folder.empty() ? no_folder : keep(*made, folder, name);
            found.stored = why.empty();
            std::snprintf(found.text, sizeof found.text, "%s", why.c_str());
        }
        if (out_report) api::write_out(out_report, found);
        *out = made.release();
    });
}
