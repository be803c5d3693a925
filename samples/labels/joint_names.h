// The joints that people have in common, by the names that the conventions of Mixamo, VRM, Quaternius, KayKit, Daz,
// Poser, 3ds Max and claque's own characters give them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace labels
{

// A node's name without prefixes, separators and case, as the next functions compare it.
std::string plain_name(const std::string &name);

// The node of a joint, as "head" or "left_elbow"; CLQ_NONE: the skeleton lacks the joint. nodes: by plain name.
uint32_t find_joint(const std::map<std::string, uint32_t> &nodes, const std::string &joint);

// All joints: those in the middle, and of the others the left and the right one.
const std::vector<std::string> &joint_names();

}  // namespace labels
