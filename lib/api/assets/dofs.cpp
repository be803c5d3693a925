// Adds degrees of freedom to an asset.
#include <claque/assets.h>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/dof_def.h"
#include "lib/base/near_names.h"

using namespace claque;

namespace
{

void add(const clq_asset_dof &def, uint32_t index, model::Rig &rig)
{
    const uint32_t node = rig.find_node(api::name_of(def.node_name));
    if (node == model::none)
        base::fail(CLQ_ARGUMENT, "degree of freedom %u '%s' is of the node '%s', which does not exist%s", index,
                   api::name_of(def.dof.name), api::name_of(def.node_name),
                   base::names_near(api::name_of(def.node_name), rig.node_names).c_str());
    rig.dofs.push_back(api::dof_of(def.dof, rig, node, index));
    rig.dof_names.emplace_back(api::name_of(def.dof.name));
}

}  // namespace

extern "C" clq_status clq_asset_add_dofs(clq_context *context, clq_asset *asset, const clq_asset_dof *dofs,
                                         uint32_t dof_count)
{
    return api::boundary("clq_asset_add_dofs", [&] {
        api::require(context && asset, "context or asset is NULL");
        api::require_array(dofs, dof_count, "degrees of freedom");
        model::Rig &rig = asset->model.rig;
        const size_t before = rig.dofs.size();
        try {
            for (uint32_t i = 0; i < dof_count; ++i) add(dofs[i], i, rig);
            model::check(rig);
        } catch (...) {
            rig.dofs.resize(before), rig.dof_names.resize(before);
            throw;
        }
    });
}
