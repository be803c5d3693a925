#include "lib/asset/vrm_bones.h"

namespace claque::asset
{

namespace
{

using Json = nlohmann::json;

constexpr size_t max_bones = 256;  // VRM has 55

const Json *member(const Json *from, const char *name)
{
    if (!from || !from->is_object()) return nullptr;
    const auto found = from->find(name);
    return found == from->end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::pair<std::string, uint32_t>> read_vrm_bones(const JsonView &root,
                                                             const std::vector<uint32_t> &rig_node, Budget &budget)
{
    std::vector<std::pair<std::string, uint32_t>> out;
    const auto add = [&](const std::string &bone, const Json *node) {
        if (!node || !node->is_number_unsigned() || out.size() >= max_bones || bone.size() > 64) return;
        const uint64_t index = node->get<uint64_t>();
        if (index >= rig_node.size() || rig_node[index] == 0xffffffffu) return;
        budget.charge(sizeof out[0], "the bones of a human body");
        out.emplace_back(bone, rig_node[index]);
    };
    const Json *extensions = member(&root.object(), "extensions");
    for (const char *name : {"VRMC_vrm", "VRMC_vrm_animation", "VRM"}) {
        const Json *bones = member(member(member(extensions, name), "humanoid"), "humanBones");
        if (!bones || !out.empty()) continue;
        if (bones->is_object())
            for (const auto &[bone, value] : bones->items()) add(bone, member(&value, "node"));
        if (bones->is_array())
            for (const Json &value : *bones) {
                const Json *bone = member(&value, "bone");
                if (bone && bone->is_string()) add(bone->get<std::string>(), member(&value, "node"));
            }
    }
    return out;
}

}  // namespace claque::asset
