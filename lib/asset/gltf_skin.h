// Turns skins into entries of the matrix palette.
#pragma once

#include <map>

#include "lib/asset/gltf_nodes.h"

namespace claque::asset
{

struct Skin {
    std::vector<uint32_t> joints;  // nodes of the file
    std::vector<math::Affine> inverse_binds;
};

// Reads and checks all skins of the file. A skin without inverse bind matrices has identities.
std::vector<Skin> read_skins(File &file, const NodeTree &tree);

// Builds rig.palette: each pair of node and inverse bind matrix occurs once, however many skins and parts use it.
class Palette
{
public:
    explicit Palette(model::Rig &rig) : rig_(rig) {}
    uint32_t entry(uint32_t rig_node, const math::Affine &inverse_bind);

private:
    using Key = std::pair<uint32_t, std::array<float, 12>>;
    model::Rig &rig_;
    std::map<Key, uint32_t> entries_;
};

}  // namespace claque::asset
