// The bones that a VRM file lists are those of a human body, whatever its nodes are called.
#include <map>

#include <gtest/gtest.h>

#include "lib/asset/gltf.h"
#include "lib/retarget/retarget.h"
#include "resting_rigs.h"
#include "tests/support/gltf_maker.h"
#include "tests/support/written_motion.h"

namespace claque::testing
{

namespace
{

// The bones of person().
const std::map<std::string, std::string> bones = {
    {"hips", "hips"},           {"spine", "spine"},           {"head", "head"},
    {"arm.l", "leftUpperArm"},  {"elbow.l", "leftLowerArm"},  {"hand.l", "leftHand"},
    {"arm.r", "rightUpperArm"}, {"elbow.r", "rightLowerArm"}, {"hand.r", "rightHand"},
    {"leg.l", "leftUpperLeg"},  {"knee.l", "leftLowerLeg"},   {"foot.l", "leftFoot"},
    {"leg.r", "rightUpperLeg"}, {"knee.r", "rightLowerLeg"},  {"foot.r", "rightFoot"}};

std::vector<retarget::HumanBone> bones_of(const model::Rig &rig)
{
    std::vector<retarget::HumanBone> out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) out.emplace_back(bones.at(std::string(rig.node_names[i])), i);
    return out;
}

// The joints of person() as nodes without telling names, with a bow of the spine, and bones by `extension`.
Bytes vrm(const char *extension, bool as_list)
{
    Maker maker;
    const std::vector<Bone> body = person(1, 0);
    Json listed = as_list ? Json::array() : Json::object();
    for (size_t i = 0; i < body.size(); ++i) {
        Json node = {{"name", std::string(1, static_cast<char>('A' + static_cast<int>(i)))},
                     {"translation", {body[i].offset.x, body[i].offset.y, body[i].offset.z}}};
        for (size_t k = 0; k < body.size(); ++k)
            if (std::string(body[k].parent) == body[i].name) node["children"].push_back(k);
        maker.add("nodes", node);
        if (as_list) listed.push_back({{"bone", bones.at(body[i].name)}, {"node", i}});
        else listed[bones.at(body[i].name)] = {{"node", i}};
    }
    // Left out: nodes that are none, and other kinds of values.
    if (as_list)
        listed.push_back({{"bone", "jaw"}, {"node", -1}}), listed.push_back(7), listed.push_back({{"bone", 3}});
    else listed["jaw"] = {{"node", 99}}, listed["leftEye"] = "none", listed["rightEye"] = Json::object();
    maker.json["scenes"] = Json::array({{{"nodes", {0}}}});
    maker.json["extensionsUsed"] = Json::array({extension});
    maker.json["extensions"][extension]["humanoid"]["humanBones"] = listed;
    ClipMaker clip(maker, "bow");
    clip.add(1, "rotation", "LINEAR", times_from(0, 0.5f, 3), turns({1, 0, 0}, {0, 40, 10}));
    clip.finish();
    return maker.glb();
}

}  // namespace

TEST(VrmBones, AreReadFromEachExtension)
{
    for (const auto &[extension, as_list] : std::vector<std::pair<const char *, bool>>{
             {"VRMC_vrm_animation", false}, {"VRMC_vrm", false}, {"VRM", true}}) {
        const Bytes bytes = vrm(extension, as_list);
        const model::Model model = asset::load_gltf(bytes.data(), bytes.size(), {});
        ASSERT_EQ(model.human_bones.size(), 15u) << extension;
        retarget::Options options;
        options.source_bones = model.human_bones;
        model::Rig target = rig_of(person(1, 0));
        options.target_bones = bones_of(target);
        const retarget::Report report = retarget::add_clips(target, model.rig, options);
        EXPECT_EQ(report.joint_count, 15u) << extension;
        // The head is 0.4 m above the joint that bows, which is 0.2 m above the hips.
        const double bowed = 40 * 0.01745329251994;
        const glm::dvec3 head = posed(target, 0, 1).of(target, "head") - posed(target, 0, 1).of(target, "hips");
        EXPECT_LT(glm::distance(head, glm::dvec3(0, 0.2 + 0.4 * std::cos(bowed), 0.4 * std::sin(bowed))), 1e-5);
    }
}

}  // namespace claque::testing
