// Names of limbs as common tools write them: Mixamo, Unreal, Rigify, VRM, VRChat, KayKit, Quaternius, Daz, Poser, Maya
// and claque's own.
#pragma once

#include <vector>

#include "lib/model/rig.h"

namespace claque::model
{

enum class Side { left, right, unknown };

// Lower case without separators, and without what stands before a colon.
std::pmr::string plain_name(std::string_view name, std::pmr::memory_resource *memory);
bool has(std::string_view text, std::string_view part);

// A side is a word ("LeftFoot", "foot_left"), a letter between separators or at the end ("foot.L", "l_foot"), or a
// small letter before a capital one ("lFoot").
Side side_of(std::string_view name, std::string_view plain);

// Whether a name is the word and a side alone: "leftleg", "armr".
bool is_with_side(std::string_view plain, std::string_view word);
// Whether a node named "leg" moves a thigh: its next joint is a knee, as in avatars of VRChat, and no thigh is above
// it. Else it moves a shin, as in Mixamo's.
bool is_above_knee(const Rig &rig, uint32_t node);

// Whether a node of this name moves others, or ends a chain, and is no limb itself.
bool is_control(std::string_view plain);

bool is_below(const Rig &rig, uint32_t node, uint32_t above);  // or the same

// Among nodes of like names, by node: 0 for a skin's joint, 1 for a node that draws nothing, 2 for a rigid mesh.
std::vector<uint8_t> ranks_of(const Rig &rig);

// Thigh, shin, foot and toes of the left and the right leg, by their names; none where no node has one. A mesh may hang
// on a joint and have a limb's name too: joints of skins come first, then nodes that draw nothing, and among equals one
// below the joint before.
void find_limbs(const Rig &rig, uint32_t (&legs)[2][4]);

}  // namespace claque::model
