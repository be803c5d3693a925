#include "lib/asset/gltf_dofs.h"

#include <cmath>
#include <unordered_set>

namespace claque::asset
{

using base::fail;

namespace
{

class FreedomAdder
{
public:
    FreedomAdder(const NodeTree &tree, const RigMapping &mapping, model::Rig &rig)
        : tree_(tree), mapping_(mapping), rig_(rig)
    {
    }

    void run()
    {
        std::vector<uint32_t> node_of(rig_.node_count(), none);
        for (uint32_t i = 0; i < tree_.nodes.size(); ++i)
            if (tree_.nodes[i].extras && mapping_.node[i] != none) node_of[mapping_.node[i]] = i;
        for (uint32_t r = 0; r < node_of.size(); ++r) {
            if (node_of[r] == none) continue;
            const NodeExtras &extras = *tree_.nodes[node_of[r]].extras;
            for (size_t i = 0; i < extras.dofs.size(); ++i) add(node_of[r], extras, i);
            if (std::isinf(extras.deactivation_m)) continue;
            rig_.deactivation_m.resize(rig_.node_count(), std::numeric_limits<float>::infinity());
            rig_.deactivation_m[r] = extras.deactivation_m;
        }
    }

private:
    void add(uint32_t node, const NodeExtras &extras, size_t i)
    {
        model::Dof dof = extras.dofs[i];
        const char *path = extras.dof_paths[i].c_str();
        const std::string &name = extras.dof_names[i];
        if (!name.empty() && !names_.insert(name).second)
            fail(CLQ_FORMAT, "%s is named '%.60s' like another degree of freedom", path, name.c_str());
        const bool morphs = dof.kind == model::DofKind::morph;
        dof.node = morphs ? mapping_.morph_set[node] : mapping_.node[node];
        const uint32_t targets = morphs && dof.node != none ? rig_.morph_sets[dof.node].target_count : 0;
        if (morphs && dof.morph_target >= targets)
            fail(CLQ_FORMAT, "%s moves morph target %u: the mesh that nodes[%u] shows has %u", path, dof.morph_target,
                 node, targets);
        rig_.dofs.push_back(dof);
        rig_.dof_names.emplace_back(name.c_str());
    }

    const NodeTree &tree_;
    const RigMapping &mapping_;
    model::Rig &rig_;
    std::unordered_set<std::string> names_;
};

}  // namespace

void add_dofs(const NodeTree &tree, const RigMapping &mapping, model::Rig &rig)
{
    FreedomAdder(tree, mapping, rig).run();
}

}  // namespace claque::asset
