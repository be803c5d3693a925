#include "lib/retarget/human_bones.h"

#include <algorithm>
#include <map>
#include <string_view>

#include <glm/geometric.hpp>

#include "lib/model/limb_names.h"

namespace claque::retarget
{

using model::has;
using model::is_below;
using model::none;

namespace
{

struct Body {
    std::map<std::string, uint32_t> bones;  // by VRM's names, without those of spine and neck
    std::vector<uint32_t> spine, neck;      // upwards
};

bool ends(std::string_view text, std::string_view part)
{
    return text.size() >= part.size() && text.substr(text.size() - part.size()) == part;
}

std::string plain(std::string_view name)
{
    return std::string(model::plain_name(name, std::pmr::get_default_resource()));
}

// "left", "right" or "".
std::string side_of(std::string_view name, std::string_view plain_name)
{
    const model::Side side = model::side_of(name, plain_name);
    return side == model::Side::left ? "left" : side == model::Side::right ? "right" : "";
}

bool has_any(std::string_view text, std::initializer_list<const char *> parts)
{
    return std::any_of(parts.begin(), parts.end(), [&](const char *part) { return has(text, part); });
}

// The part of a limb as VRM names it, without its side; "" for others, such as fingers and controls.
std::string limb_of(std::string_view p)
{
    if (has_any(p, {"twist", "ik", "pole", "roll", "control", "ctrl", "target", "end", "helper", "nub", "thumb",
                    "index", "middle", "ring", "pinky", "little", "finger", "skirt"}))
        return "";
    if (has_any(p, {"thigh", "upleg", "upperleg", "legupper"})) return "UpperLeg";
    if (has_any(p, {"shin", "calf", "lowerleg", "leglower"})) return "LowerLeg";
    if (has_any(p, {"toe", "ball"})) return "Toes";
    if (has_any(p, {"foot", "ankle"})) return "Foot";
    if (has_any(p, {"clavicle", "collar", "shoulder"})) return "Shoulder";
    if (has_any(p, {"forearm", "lowerarm", "armlower", "elbow"})) return "LowerArm";
    if (has_any(p, {"upperarm", "armupper", "uparm", "shldr"})) return "UpperArm";
    if (has_any(p, {"wrist", "hand", "palm"})) return "Hand";
    if (model::is_with_side(p, "leg")) return "LowerLeg";
    if (model::is_with_side(p, "arm")) return "UpperArm";
    return "";
}

bool is_middle(std::string_view p) { return !has_any(p, {"end", "nub", "top", "ik", "control", "ctrl", "twist"}); }

// Skeletons of Maya users: a hip, a knee and a shoulder move thigh, shin and upper arm.
void add_limb_by_joint_name(const model::Rig &rig, const std::vector<std::string> &names, uint32_t node, Body &body)
{
    const std::string &p = names[node], side = side_of(rig.node_names[node], p);
    if (side.empty() || model::is_control(p)) return;
    if (has(p, "hip") && !has(p, "hips")) body.bones.emplace(side + "UpperLeg", node);
    if (has(p, "knee")) body.bones.emplace(side + "LowerLeg", node);
    const auto lower = body.bones.find(side + "LowerArm");
    if (has(p, "shoulder") && lower != body.bones.end() && rig.parents[lower->second] == node &&
        body.bones.emplace(side + "UpperArm", node).second)
        body.bones.erase(side + "Shoulder");
}

// Joints of skins come first: nodes of meshes and of other rigs may have names of limbs too.
void add_limbs(const model::Rig &rig, Body &body)
{
    const std::vector<uint8_t> ranks = model::ranks_of(rig);
    std::vector<std::string> names;
    for (uint32_t i = 0; i < rig.node_count(); ++i) names.push_back(plain(rig.node_names[i]));
    for (int rank = 0; rank < 3; ++rank) {
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            if (ranks[i] != rank) continue;
            const std::string side = side_of(rig.node_names[i], names[i]);
            std::string limb = side.empty() ? "" : limb_of(names[i]);
            if (model::is_with_side(names[i], "leg") && model::is_above_knee(rig, i)) limb = "UpperLeg";
            if (!limb.empty()) body.bones.emplace(side + limb, i);
        }
        for (uint32_t i = 0; i < rig.node_count(); ++i)
            if (ranks[i] == rank) add_limb_by_joint_name(rig, names, i, body);
    }
}

// The lowest node above both thighs; none: nothing is.
uint32_t above_legs(const model::Rig &rig, const Body &body)
{
    const auto left = body.bones.find("leftUpperLeg"), right = body.bones.find("rightUpperLeg");
    if (left == body.bones.end() || right == body.bones.end()) return none;
    uint32_t node = rig.parents[left->second];
    while (node != none && !is_below(rig, right->second, node)) node = rig.parents[node];
    return node;
}

// Hips: the joint of that name if the legs hang on it, else the joint on which they hang. Some pelvises carry the spine
// alone.
void add_hips(const model::Rig &rig, Body &body)
{
    const uint32_t legs = above_legs(rig, body);
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::string p = plain(rig.node_names[i]);
        if (!side_of(rig.node_names[i], p).empty() || !is_middle(p)) continue;
        if (!ends(p, "hips") && !ends(p, "pelvis") && p != "hip") continue;
        if (legs == none || i == legs || is_below(rig, legs, i)) body.bones.emplace("hips", i);
        else if (is_below(rig, i, legs)) body.spine.push_back(i);
        break;
    }
    if (legs != none) body.bones.emplace("hips", legs);
}

void add_middle(const model::Rig &rig, uint32_t node, std::string_view p, Body &body)
{
    const auto hips = body.bones.find("hips");
    if (!is_middle(p) || hips == body.bones.end() || !is_below(rig, node, hips->second)) return;
    const auto extend = [&](std::vector<uint32_t> &chain) {
        if (chain.empty() || is_below(rig, node, chain.back())) chain.push_back(node);
    };
    if (has(p, "head")) body.bones.emplace("head", node);
    else if (has(p, "neck")) extend(body.neck);
    else if (has_any(p, {"spine", "chest", "torso", "abdomen", "waist", "lowerback"})) extend(body.spine);
}

// Swaps left and right of a skeleton that an exporter mirrored without its names: toes point ahead, and the left thigh
// lies to the left of that. A rest whose legs do not hang, such as one with all bones along an axis, changes nothing.
void swap_mirrored_sides(const model::Rig &rig, Body &body)
{
    const GlobalPose rest = rest_pose(rig);
    const auto way = [&](const char *from, const char *to) {
        const auto a = body.bones.find(from), b = body.bones.find(to);
        return a == body.bones.end() || b == body.bones.end() ? glm::dvec3(0)
                                                              : rest.positions[b->second] - rest.positions[a->second];
    };
    for (const char *side : {"left", "right"}) {
        const std::string name = side;
        const glm::dvec3 leg = way((name + "UpperLeg").c_str(), (name + "Foot").c_str());
        if (!(-leg.y > 0.7 * glm::length(leg))) return;
    }
    const glm::dvec3 ahead = way("leftFoot", "leftToes") + way("rightFoot", "rightToes"),
                     left = way("rightUpperLeg", "leftUpperLeg");
    // The sine of the angle by which left is to the left, times lengths.
    const double sine = left.x * ahead.z - left.z * ahead.x;
    const double lengths = (ahead.x * ahead.x + ahead.z * ahead.z) * (left.x * left.x + left.z * left.z);
    if (!(sine < 0 && sine * sine > 0.25 * lengths)) return;
    std::map<std::string, uint32_t> swapped;
    for (const auto &[bone, node] : body.bones) {
        const bool is_left = bone.compare(0, 4, "left") == 0, is_right = bone.compare(0, 5, "right") == 0;
        swapped[is_left ? "right" + bone.substr(4) : is_right ? "left" + bone.substr(5) : bone] = node;
    }
    body.bones = std::move(swapped);
}

Body body_of(const model::Rig &rig, const std::vector<HumanBone> &listed)
{
    Body body;
    for (const char *part : {"spine", "chest", "upperChest"})
        for (const HumanBone &bone : listed)
            if (bone.first == part) body.spine.push_back(bone.second);
    for (const HumanBone &bone : listed)
        if (bone.first == "neck") body.neck.push_back(bone.second);
        else if (std::find(body.spine.begin(), body.spine.end(), bone.second) == body.spine.end())
            body.bones.emplace(bone.first, bone.second);
    if (!listed.empty()) return body;
    add_limbs(rig, body);
    swap_mirrored_sides(rig, body);
    add_hips(rig, body);
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::string name = plain(rig.node_names[i]);
        if (side_of(rig.node_names[i], name).empty()) add_middle(rig, i, name, body);
    }
    return body;
}

// Binds the ends of two chains, and between them as many joints as the shorter has. Of one joint the last.
void bind_chain(const std::vector<uint32_t> &target, const std::vector<uint32_t> &source, std::vector<JointMatch> &out)
{
    const size_t count = std::min(target.size(), source.size());
    for (size_t i = 0; i < count; ++i) {
        const auto at = [&](const std::vector<uint32_t> &chain) {
            if (count == 1) return chain.back();
            return chain[(2 * i * (chain.size() - 1) + count - 1) / (2 * (count - 1))];
        };
        out.push_back({at(source), at(target), RestAlignment::keep, none});
    }
}

// The topmost joints of skirts, which no clip of another skeleton moves.
std::vector<Follower> skirts(const model::Rig &rig, const Body &body)
{
    std::vector<Follower> out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::string name = plain(rig.node_names[i]), side = side_of(rig.node_names[i], name);
        const uint32_t parent = rig.parents[i];
        if (side.empty() || !has(name, "skirt") || (parent != none && has(plain(rig.node_names[parent]), "skirt")))
            continue;
        const std::string joint(rig.node_names[i]);
        for (const char *leg : {"left", "right"})
            out.push_back({joint, std::string(rig.node_names[body.bones.at(std::string(leg) + "UpperLeg")]),
                           side == leg ? 0.9 : 0.4});
    }
    return out;
}

}  // namespace

HumanBinding bind_human(const model::Rig &target, const model::Rig &source, const Options &options)
{
    const Body own = body_of(target, options.target_bones), other = body_of(source, options.source_bones);
    const auto earlier = [](const JointMatch &a, const JointMatch &b) { return a.target < b.target; };
    const auto same = [](const JointMatch &a, const JointMatch &b) { return a.target == b.target; };
    HumanBinding out;
    for (const char *bone : {"hips", "leftUpperLeg", "leftLowerLeg", "rightUpperLeg", "rightLowerLeg"})
        if (own.bones.count(bone) == 0 || other.bones.count(bone) == 0) return out;
    for (const auto &[bone, node] : own.bones) {
        const auto found = other.bones.find(bone);
        if (found == other.bones.end()) continue;
        const bool limb = has_any(bone, {"UpperArm", "LowerArm", "UpperLeg", "LowerLeg"}) || ends(bone, "Hand");
        out.matches.push_back({found->second, node, limb ? RestAlignment::align : RestAlignment::keep, none});
    }
    bind_chain(own.spine, other.spine, out.matches);
    bind_chain(own.neck, other.neck, out.matches);
    // A file may list a joint twice.
    std::stable_sort(out.matches.begin(), out.matches.end(), earlier);
    out.matches.erase(std::unique(out.matches.begin(), out.matches.end(), same), out.matches.end());
    if (out.matches.size() < 10) return {};
    out.followers = skirts(target, own);
    const auto expect = [&](const std::string &bone) {
        if (own.bones.count(bone) == 0 || other.bones.count(bone) == 0) out.unbound.push_back(bone);
    };
    expect("head");
    for (const std::string side : {"left", "right"})
        for (const char *limb : {"UpperArm", "LowerArm", "Hand", "Foot"}) expect(side + limb);
    return out;
}

}  // namespace claque::retarget
