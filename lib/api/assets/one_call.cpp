// Characters in one call, with levels of detail and kept on disk: clq_template_load_gltf and clq_template_builtin.
#include <claque/levels.h>

#include <string>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/assets/kept_template.h"
#include "lib/api/boundary.h"
#include "lib/figures/figure.h"

using namespace claque;

namespace
{

// A character that has levels of its own keeps them. One whose levels would take too much is shown without.
api::Template built_in_levels(clq_context *context, clq_asset *asset)
{
    const clq_status status = clq_asset_make_levels(context, asset, nullptr, nullptr);
    if (status == CLQ_LIMIT)
        clq_context_log(context, CLQ_LOG_WARNING, (std::string("no levels of detail: ") + clq_last_error()).c_str());
    else if (status != CLQ_ARGUMENT) api::pass_on(status);
    clq_template *made = nullptr;
    api::pass_on(clq_asset_build(context, asset, 0, &made));
    return api::Template(made);
}

}  // namespace

extern "C" clq_status clq_template_load_gltf(clq_context *context, const void *bytes, size_t size_bytes,
                                             const clq_asset_options *options, clq_template **out)
{
    return api::boundary("clq_template_load_gltf", [&] {
        api::require(context && bytes && out, "context, bytes or out is NULL");
        const clq_asset_options wanted = api::read_def(options, clq_asset_options_init, "clq_asset_options_init");
        asset::ContentHash name = api::start_of_name();
        name.add(std::string("clq_template_load_gltf"));
        asset::add_bytes(bytes, size_bytes, api::name_of(wanted.base_folder), api::limit_of(wanted), name);
        api::add_options(wanted, name);
        const auto make = [&] {
            clq_asset *loaded = nullptr;
            api::pass_on(clq_asset_load(context, bytes, size_bytes, options, &loaded));
            return built_in_levels(context, api::Asset(loaded).get());
        };
        *out = api::kept_template(context, false, asset::user_cache_folder(), name, make).tmpl.release();
    });
}

extern "C" clq_status clq_template_builtin(clq_context *context, const char *name, clq_template **out)
{
    return api::boundary("clq_template_builtin", [&] {
        api::require(context && name && out, "context, name or out is NULL");
        const clq_levels_def levels = clq_levels_def_init();
        clq_prepare_def def = clq_prepare_def_init();
        def.builtin = name;
        for (const figures::Builtin &person : figures::people())  // the others have levels of their own
            if (std::string(name) == person.name) def.levels = &levels;
        api::pass_on(clq_template_prepare(context, &def, out, nullptr));
    });
}
