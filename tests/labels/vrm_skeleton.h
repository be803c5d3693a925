// A person with the skeleton of VRM: bones in a T, a face of few triangles, and feet on the ground.
#pragma once

#include <functional>
#include <string>

#include "tests/support/gltf_maker.h"

namespace labels_test
{

// A GLB. `name`: what a bone of VRM is called in the file, as leftUpperArm.
inline claque::testing::Bytes vrm_skeleton(const std::function<std::string(const std::string &)> &name)
{
    using claque::testing::Json;
    claque::testing::Maker file;
    const auto mesh = [&](const std::vector<float> &xyz, const std::vector<uint16_t> &corners) {
        const int positions = file.floats("VEC3", xyz.size() / 3, xyz);
        const int indices = file.accessor(claque::testing::u16, "SCALAR", corners.size(), corners);
        return file.add("meshes", {{"primitives",
                                    Json::array({{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}})}});
    };
    const int face = mesh({0, 0.25f, 0, -0.08f, 0.1f, 0, 0.08f, 0.1f, 0, 0, 0.06f, 0.12f}, {0, 1, 3, 0, 3, 2});
    const int legs = mesh({-0.1f, -0.95f, 0, 0.1f, -0.95f, 0, 0, 0, 0}, {0, 1, 2});
    const auto bone = [&](int above, const std::string &vrm, double x, double y, double z) {
        const int node = file.add("nodes", {{"name", name(vrm)}, {"translation", {x, y, z}}});
        if (above >= 0) file.json["nodes"][static_cast<size_t>(above)]["children"].push_back(node);
        return node;
    };
    const int hips = bone(-1, "hips", 0, 0.95, 0), spine = bone(hips, "spine", 0, 0.1, 0),
              chest = bone(spine, "chest", 0, 0.15, 0), upper_chest = bone(chest, "upperChest", 0, 0.12, 0),
              neck = bone(upper_chest, "neck", 0, 0.12, 0), head = bone(neck, "head", 0, 0.08, 0);
    file.json["nodes"][static_cast<size_t>(head)]["mesh"] = face;
    file.json["nodes"][static_cast<size_t>(hips)]["mesh"] = legs;
    for (const std::string side : {"left", "right"}) {
        const double x = side == "left" ? 1 : -1;
        const int shoulder = bone(upper_chest, side + "Shoulder", 0.03 * x, 0.08, 0),
                  arm = bone(shoulder, side + "UpperArm", 0.12 * x, 0, 0),
                  forearm = bone(arm, side + "LowerArm", 0.25 * x, 0, 0),
                  hand = bone(forearm, side + "Hand", 0.24 * x, 0, 0);
        bone(hand, side + "MiddleProximal", 0.09 * x, 0, 0);
        const int thigh = bone(hips, side + "UpperLeg", 0.09 * x, -0.03, 0),
                  shin = bone(thigh, side + "LowerLeg", 0, -0.42, 0), foot = bone(shin, side + "Foot", 0, -0.42, 0);
        bone(foot, side + "Toes", 0, -0.05, 0.12);
    }
    file.json["scenes"] = Json::array({{{"nodes", {hips}}}});
    return file.glb();
}

}  // namespace labels_test
