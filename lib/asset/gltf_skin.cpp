#include "lib/asset/gltf_skin.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

using base::fail;

namespace
{

math::Affine affine_of(const float *m, const JsonView &view, size_t joint)
{
    // An accessor without data means zeros; a joint that collapses its vertices is then what the file says.
    const bool zero = std::all_of(m, m + 16, [](float x) { return x == 0; });
    if (!zero && std::fabs(m[3]) + std::fabs(m[7]) + std::fabs(m[11]) + std::fabs(m[15] - 1) > 1e-3f)
        fail(CLQ_FORMAT, "%s: the last row of matrix %zu is not 0 0 0 1", view.path().c_str(), joint);
    math::Affine out;
    for (int k = 0; k < 4; ++k) out.set_column(k, glm::vec3(m[4 * k], m[4 * k + 1], m[4 * k + 2]));
    return out;
}

Skin read_skin(const JsonView &view, File &file, const NodeTree &tree)
{
    Skin skin;
    const JsonView joints = view["joints"], binds = view["inverseBindMatrices"];
    if (joints.count() == 0) fail(CLQ_FORMAT, "%s is missing or empty", joints.path().c_str());
    view["skeleton"].index_or_none(tree.file_count, "node");
    for (size_t i = 0; i < joints.count(); ++i) skin.joints.push_back(joints.at(i).index(tree.file_count, "node"));
    skin.inverse_binds.resize(skin.joints.size());
    if (!binds.exists()) return skin;
    const uint32_t index = file.accessors.reference(binds);
    const Accessor &accessor = file.accessors.at(index);
    if (accessor.count < skin.joints.size())
        fail(CLQ_FORMAT, "%s has %u matrices for %zu joints", binds.path().c_str(), accessor.count, skin.joints.size());
    if (accessor.component != Component::f32) fail(CLQ_FORMAT, "%s are not floats", binds.path().c_str());
    if (accessor.view != none && file.buffers.view(accessor.view).stride)
        file.warn(
            base::text_of("%s reads a buffer view with a byteStride, which glTF has for vertices alone: the "
                          "matrices are read %u bytes apart",
                          binds.path().c_str(), file.buffers.view(accessor.view).stride));
    const std::vector<float> values = file.accessors.floats(index, 16, binds.path());
    for (size_t i = 0; i < skin.joints.size(); ++i) skin.inverse_binds[i] = affine_of(&values[16 * i], binds, i);
    return skin;
}

}  // namespace

std::vector<Skin> read_skins(File &file, const NodeTree &tree)
{
    std::vector<Skin> skins;
    const JsonView list = file.root["skins"];
    skins.reserve(list.count());
    for (size_t i = 0; i < list.count(); ++i) skins.push_back(read_skin(list.at(i), file, tree));
    return skins;
}

uint32_t Palette::entry(uint32_t rig_node, const math::Affine &inverse_bind)
{
    Key key;
    key.first = rig_node;
    // Adding zero turns -0 into 0, so that equal matrices have equal keys.
    for (size_t k = 0; k < 12; ++k) key.second[k] = inverse_bind.c[k] + 0.0f;
    const auto [place, is_new] = entries_.emplace(key, static_cast<uint32_t>(rig_.palette.size()));
    if (is_new) {
        model::PaletteEntry entry;
        entry.node = rig_node;
        entry.inverse_bind = inverse_bind;
        rig_.palette.push_back(entry);
    }
    return place->second;
}

}  // namespace claque::asset
