#include "lib/asset/gltf_build.h"

#include <algorithm>
#include <map>

#include "lib/asset/gltf_clip.h"
#include "lib/asset/gltf_dofs.h"
#include "lib/asset/gltf_mesh.h"
#include "lib/asset/gltf_skin.h"
#include "lib/asset/vrm_bones.h"
#include "lib/base/near_names.h"

namespace claque::asset
{

using base::fail;

namespace
{

class Builder
{
public:
    Builder(File &file, model::Model &model)
        : file_(file),
          model_(model),
          tree_(read_nodes(file)),
          skins_(read_skins(file, tree_)),
          materials_(file),
          shown_(tree_.shown()),
          meshes_(read_meshes(file, materials_, shown_meshes())),
          palette_(model.rig)
    {
        places_.node.assign(tree_.nodes.size(), none);
        places_.morph_set.assign(tree_.nodes.size(), none);
    }

    void run()
    {
        check_weights();
        add_nodes(shown_);
        add_joint_trees();
        hide();
        for (const uint32_t node : shown_)
            if (tree_.nodes[node].mesh != none) add_mesh(node);
        add_dofs(tree_, places_, model_.rig);
        TargetCounts targets;
        for (const FileNode &node : tree_.nodes)
            targets.push_back(node.mesh == none ? 0 : meshes_[node.mesh].target_count);
        read_clips(file_, tree_, targets, places_, model_.rig);
        model_.human_bones = read_vrm_bones(file_.root, places_.node, file_.budget);
        std::vector<bool> used(materials_.count(), false);
        for (const model::Part &part : model_.parts)
            if (!part.hidden) used[part.material] = true;
        materials_.finish(used, model_);
    }

private:
    std::vector<bool> shown_meshes() const
    {
        std::vector<bool> out(file_.root["meshes"].count(), false);
        for (const uint32_t node : shown_)
            if (tree_.nodes[node].mesh != none) out[tree_.nodes[node].mesh] = true;
        return out;
    }

    void check_weights() const
    {
        for (size_t i = 0; i < tree_.nodes.size(); ++i) {
            const FileNode &node = tree_.nodes[i];
            if (node.mesh == none || node.morph_weights.empty()) continue;
            if (node.morph_weights.size() != meshes_[node.mesh].target_count)
                fail(CLQ_FORMAT, "nodes[%zu].weights has %zu numbers, its mesh has %u morph targets", i,
                     node.morph_weights.size(), meshes_[node.mesh].target_count);
        }
    }

    void add_nodes(const std::vector<uint32_t> &order)
    {
        model::Rig &rig = model_.rig;
        file_.budget.charge(order.size() * (sizeof(math::Trs) + sizeof(std::pmr::string) + 8), "the rig");
        for (const uint32_t i : order) {
            const FileNode &node = tree_.nodes[i];
            places_.node[i] = rig.node_count();
            rig.parents.push_back(node.parent == none ? none : places_.node[node.parent]);
            rig.rest.push_back(node.rest);
            rig.node_names.emplace_back(node.name.c_str());
        }
    }

    // Joints may lie outside the scene; their transforms in the world count all the same.
    void add_joint_trees()
    {
        std::vector<bool> done(skins_.size());
        for (const uint32_t node : shown_) {
            const uint32_t skin = tree_.nodes[node].skin;
            if (skin == none || done[skin]) continue;
            done[skin] = true;
            for (const uint32_t joint : skins_[skin].joints)
                if (places_.node[joint] == none) add_nodes(tree_.below({tree_.root_of(joint)}));
        }
    }

    void hide()
    {
        const std::vector<std::string> &names = file_.options.hidden_nodes;
        hidden_.assign(tree_.nodes.size(), false);
        if (names.empty()) return;
        for (const uint32_t i : shown_) {
            const FileNode &node = tree_.nodes[i];
            hidden_[i] = (node.parent != none && hidden_[node.parent]) ||
                         std::find(names.begin(), names.end(), node.name) != names.end();
        }
        for (const std::string &name : names)
            if (model_.rig.find_node(name) == none)
                file_.warn(base::text_of("no node is named '%.100s': nothing to hide%s", name.c_str(),
                                         base::names_near(name, model_.rig.node_names).c_str()));
    }

    uint32_t add_morph_set(uint32_t node)
    {
        const Mesh &mesh = meshes_[tree_.nodes[node].mesh];
        const std::vector<float> &own = tree_.nodes[node].morph_weights;
        const std::vector<float> &weights = own.empty() ? mesh.morph_weights : own;
        model::Rig &rig = model_.rig;
        places_.morph_set[node] = static_cast<uint32_t>(rig.morph_sets.size());
        model::MorphSet set;
        set.node = places_.node[node];
        set.first_weight = static_cast<uint32_t>(rig.rest_weights.size());
        set.target_count = mesh.target_count;
        file_.budget.charge(sizeof set + 4ull * weights.size(), "morph weights");
        rig.morph_sets.push_back(set);
        rig.rest_weights.insert(rig.rest_weights.end(), weights.begin(), weights.end());
        return places_.morph_set[node];
    }

    void add_mesh(uint32_t node)
    {
        const FileNode &from = tree_.nodes[node];
        const Mesh &mesh = meshes_[from.mesh];
        if (from.is_instanced && mesh.target_count != 0)
            file_.warn(
                base::text_of("nodes[%u] '%.60s' has instances of a mesh with morph targets: clips do not move "
                              "these",
                              node, from.name.c_str()));
        if (from.is_instanced) return;
        const uint32_t morph_set = mesh.target_count ? add_morph_set(node) : none;
        static const std::vector<uint32_t> no_entries;
        const std::vector<uint32_t> &entries = from.skin != none ? entries_of(from.skin) : no_entries;
        for (const Primitive &primitive : mesh.primitives) {
            file_.budget.charge(bytes_of(primitive.part) + 8 * primitive.part.positions.size(), "a mesh on its nodes");
            model::Part part = primitive.part;
            part.name = mesh.name.empty() ? from.name : mesh.name;
            part.node = places_.node[node];
            part.hidden = hidden_[node];
            part.morph_set = morph_set;
            if (from.extras) part.lod_min_m = from.extras->lod_min_m, part.lod_max_m = from.extras->lod_max_m;
            if (from.skin != none && !primitive.has_joints)
                file_.warn(
                    base::text_of("nodes[%u] '%.60s' has a skin, a primitive of its mesh has no joints: it "
                                  "moves with the node",
                                  node, from.name.c_str()));
            if (from.skin != none && primitive.has_joints) bind(part, entries, node, from.skin);
            else hang(part);
            model_.parts.push_back(std::move(part));
        }
    }

    // Many nodes may share a skin.
    const std::vector<uint32_t> &entries_of(uint32_t index)
    {
        const Skin &skin = skins_[index];
        const auto [place, is_new] = skin_entries_.emplace(index, std::vector<uint32_t>());
        std::vector<uint32_t> &out = place->second;
        if (!is_new) return out;
        file_.budget.charge(skin.joints.size() * 3 * sizeof(model::PaletteEntry), "the matrix palette");
        out.reserve(skin.joints.size());
        for (size_t i = 0; i < skin.joints.size(); ++i)
            out.push_back(palette_.entry(places_.node[skin.joints[i]], skin.inverse_binds[i]));
        return out;
    }

    // The place in a skin's list of the joint that is a node of the file or the nearest above it, else the first.
    uint32_t joint_above(uint32_t node, uint32_t skin)
    {
        const auto [place, is_new] = joints_above_.emplace(skin, std::vector<uint32_t>());
        std::vector<uint32_t> &above = place->second;
        if (is_new) {
            file_.budget.charge(4ull * tree_.nodes.size(), "the joints above meshes");
            above.assign(tree_.nodes.size(), none);
            const std::vector<uint32_t> &joints = skins_[skin].joints;
            for (uint32_t i = 0; i < joints.size(); ++i) above[joints[i]] = i;
            for (const uint32_t one : shown_) {
                const uint32_t parent = tree_.nodes[one].parent;
                if (above[one] == none && parent != none) above[one] = above[parent];
            }
        }
        return above[node] == none ? 0 : above[node];
    }

    void bind(model::Part &part, const std::vector<uint32_t> &entries, uint32_t node, uint32_t skin)
    {
        part.skinned = true;
        for (size_t i = 0; i < part.joints.size(); ++i) {
            uint32_t &joint = part.joints[i];
            if (joint == none) joint = joint_above(node, skin);  // of a vertex without weights
            if (joint >= entries.size())
                fail(CLQ_FORMAT, "vertex %zu of a mesh on nodes[%u] names joint %u, its skin has %zu",
                     i / part.influence_count, node, joint, entries.size());
            joint = entries[joint];
        }
    }

    void hang(model::Part &part)
    {
        part.influence_count = 1;
        part.joints.assign(part.positions.size(), palette_.entry(part.node, math::Affine()));
        part.weights.assign(part.positions.size(), 1.0f);
    }

    File &file_;
    model::Model &model_;
    const NodeTree tree_;
    const std::vector<Skin> skins_;
    Materials materials_;
    const std::vector<uint32_t> shown_;  // visible nodes, depth first
    const std::vector<Mesh> meshes_;
    Palette palette_;
    RigMapping places_;
    std::vector<bool> hidden_;
    std::map<uint32_t, std::vector<uint32_t>> skin_entries_, joints_above_;  // by skin
};

}  // namespace

void build_model(File &file, model::Model &model) { Builder(file, model).run(); }

}  // namespace claque::asset
