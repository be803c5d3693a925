#include "lib/api/assets/kept_template.h"

#include <cstdint>
#include <new>
#include <vector>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/assets/installed_people.h"
#include "lib/api/boundary.h"
#include "lib/api/build_id.h"
#include "lib/model/template_file.h"

namespace claque::api
{

namespace
{

Template from_disk(clq_context *context, const std::string &folder, const std::string &name)
{
    clq_template *loaded = nullptr;
    const std::vector<uint8_t> bytes = asset::read_cached(folder, name);
    if (bytes.empty()) return nullptr;
    // What cannot be loaded is made anew. Without memory that would take longer, and fail as well.
    if (clq_template_load(context, bytes.data(), bytes.size(), &loaded) == CLQ_OUT_OF_MEMORY) throw std::bad_alloc();
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
    pass_on(status);
    return asset::write_cached(folder, name, saved.bytes);
}

}  // namespace

asset::ContentHash start_of_name()
{
    asset::ContentHash all;
    all.add(std::string(assets_sources()));
    all.add(uint64_t(model::template_file_version));
    return all;
}

void add_options(const clq_asset_options &options, asset::ContentHash &all)
{
    all.add(uint64_t(options.hidden_node_count));
    for (uint32_t i = 0; options.hidden_nodes && i < options.hidden_node_count; ++i)
        all.add(std::string(name_of(options.hidden_nodes[i])));
    all.add(options.bvh_metres_per_unit);
    all.add(uint64_t(options.strict));
    for (const double value : {options.turn_deg, options.height_m, options.scale}) all.add(value);
    all.add(uint64_t(number_of(options.blend) == CLQ_BLEND_OPAQUE));
    all.add(uint64_t(number_of(options.colours)));
}

KeptTemplate kept_template(clq_context *context, bool installed, const std::string &folder,
                           const asset::ContentHash &hash, const std::function<Template()> &make)
{
    KeptTemplate kept;
    const std::string build = start_of_name().hex().substr(0, 16), name = build + "-" + hash.hex() + ".clq";
    if (installed) kept.tmpl = installed_template(context, build, name);
    if (!kept.tmpl && !folder.empty()) kept.tmpl = from_disk(context, folder, name);
    kept.from_disk = kept.tmpl != nullptr;
    if (kept.from_disk) return kept;
    kept.tmpl = make();
    if (folder.empty()) return kept;
    kept.why_not_stored = keep(*kept.tmpl, folder, name);
    kept.stored = kept.why_not_stored.empty();
    return kept;
}

}  // namespace claque::api
