// The skin weights of a point. At each joint of its region's chain the bones are blended over a length that suits the
// joint; then weights are smoothed along the surface, so that cloth and shoulders do not tear.
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

using BoneWeights = std::array<float, bone_count>;  // before reduction to the strongest four

inline void add_weight(BoneWeights &w, Bone bone, float weight) { w[static_cast<size_t>(bone)] += weight; }

// Distributes `whole` along a chain: at each joint a share passes on to the next bone.
struct Link {
    Bone bone;
    float share;  // the share of what reaches this bone that passes on to the next
};
void chain(BoneWeights &w, float whole, std::initializer_list<Link> links);

// The weights of the shared regions, for weighers that mix them; each adds `whole` in total.
void weigh_trunk(BoneWeights &w, glm::vec3 p, float whole);
void weigh_shoulder(BoneWeights &w, glm::vec3 p, Side side, float whole);
void weigh_gown(BoneWeights &w, glm::vec3 p, float whole);
void weigh_arm(BoneWeights &w, glm::vec3 p, Side side, float whole);

// The weights of a point in a region of the figure's own; they sum to 1.
using Weigher = BoneWeights (*)(const Point &point);

// One binding per point of the mesh: at most four bones, weights in descending order that sum to 1.
std::vector<Binding> bind(const Mesh &mesh, Weigher weigher);

}  // namespace claque::figures
