#include "lib/asset/gltf_instances.h"

#include <cmath>

namespace claque::asset
{

using base::fail;

namespace
{

class Instances
{
public:
    Instances(File &file, const JsonView &attributes)
        : attributes_(attributes),
          translations_(read(file, "TRANSLATION", 3)),
          rotations_(read(file, "ROTATION", 4)),
          scales_(read(file, "SCALE", 3))
    {
    }
    size_t count() const { return count_; }

    math::Trs at(size_t i) const
    {
        math::Trs out;
        for (int k = 0; k < 3; ++k) {
            if (!translations_.empty()) out.translation[k] = translations_[3 * i + size_t(k)];
            if (!scales_.empty()) out.scale[k] = scales_[3 * i + size_t(k)];
        }
        if (!rotations_.empty()) out.rotation = rotation_at(i);
        return out;
    }

private:
    std::vector<float> read(File &file, const char *name, uint32_t width)
    {
        const JsonView view = attributes_[name];
        if (!view.exists()) return {};
        const uint32_t index = file.accessors.reference(view);
        const size_t count = file.accessors.at(index).count;
        if (has_any_ && count != count_)
            fail(CLQ_FORMAT, "%s has %zu instances, an attribute before it %zu", view.path().c_str(), count, count_);
        has_any_ = true, count_ = count;
        return file.accessors.floats(index, width, view.path());
    }

    // As the rotation of a node: of a length near 1.
    glm::quat rotation_at(size_t i) const
    {
        const float *q = &rotations_[4 * i];
        double squares = 0;
        for (int k = 0; k < 4; ++k) squares += double(q[k]) * double(q[k]);
        const double length = std::sqrt(squares);
        if (!(std::fabs(length - 1) < 0.1))
            fail(CLQ_FORMAT, "%s: the rotation of instance %zu has length %g instead of 1",
                 attributes_["ROTATION"].path().c_str(), i, length);
        const auto unit = [&](int k) { return static_cast<float>(double(q[k]) / length); };
        return glm::quat(unit(3), unit(0), unit(1), unit(2));
    }

    const JsonView attributes_;
    bool has_any_ = false;
    size_t count_ = 0;
    const std::vector<float> translations_, rotations_, scales_;
};

FileNode instance_of(const FileNode &node, uint32_t parent, const math::Trs &place)
{
    FileNode out;
    out.name = node.name;
    out.parent = parent;
    out.rest = place;
    out.mesh = node.mesh;
    out.morph_weights = node.morph_weights;
    if (!node.extras || !node.extras->has_lod) return out;
    out.extras = std::make_unique<NodeExtras>();
    out.extras->lod_min_m = node.extras->lod_min_m, out.extras->lod_max_m = node.extras->lod_max_m;
    out.extras->has_lod = true;
    return out;
}

}  // namespace

void add_instances(File &file, NodeTree &tree)
{
    const JsonView list = file.root["nodes"];
    for (uint32_t i = 0; i < tree.file_count; ++i) {
        const JsonView extension = list.at(i)["extensions"]["EXT_mesh_gpu_instancing"];
        if (!extension.exists() || tree.nodes[i].mesh == none) continue;
        extension.object();
        if (tree.nodes[i].skin != none) {
            file.warn(base::text_of("%s: its mesh has a skin: shown once", extension.path().c_str()));
            continue;
        }
        const Instances instances(file, extension["attributes"]);
        if (instances.count() == 0) continue;
        const size_t weights = tree.nodes[i].morph_weights.size() * sizeof(tree.nodes[i].morph_weights[0]);
        const size_t bytes = sizeof(FileNode) + tree.nodes[i].name.size() + weights;
        file.budget.charge(instances.count() * bytes, extension.path().c_str());
        tree.nodes[i].is_instanced = true;
        for (size_t k = 0; k < instances.count(); ++k) {
            tree.nodes[i].children.push_back(static_cast<uint32_t>(tree.nodes.size()));
            tree.nodes.push_back(instance_of(tree.nodes[i], i, instances.at(k)));
        }
    }
}

}  // namespace claque::asset
