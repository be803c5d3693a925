// Which bones a point follows: at each joint of its region's chain the bones are blended over a stretch that suits the
// joint, then everything is smoothed along the surface, so that cloth and shoulder do not tear.
#pragma once

#include <initializer_list>

#include "lib/figures/mesh.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

struct Binding {
    std::array<uint32_t, 4> bones{};
    std::array<float, 4> weights{};
};

using BoneWeights = std::array<float, bone_count>;  // before the strongest four are kept

inline void add_weight(BoneWeights &w, Bone bone, float weight) { w[static_cast<size_t>(bone)] += weight; }

// Hands `whole` down a chain: at each joint the part beyond it goes on to the next bone.
struct Link {
    Bone bone;
    float share;  // of what reaches this bone, how much passes on to the next
};
void chain(BoneWeights &w, float whole, std::initializer_list<Link> links);

// What the shared regions do, for weighers that mix them; each adds `whole` in sum.
void weigh_trunk(BoneWeights &w, glm::vec3 p, float whole);
void weigh_shoulder(BoneWeights &w, glm::vec3 p, Side side, float whole);
void weigh_gown(BoneWeights &w, glm::vec3 p, float whole);
void weigh_arm(BoneWeights &w, glm::vec3 p, Side side, float whole);

// The weights of a point of a region of the figure's own, summing to 1.
using Weigher = BoneWeights (*)(const Point &point);

// One a point of the mesh, at most four bones each, weights falling and summing to 1.
std::vector<Binding> bind(const Mesh &mesh, Weigher weigher);

}  // namespace claque::figures
