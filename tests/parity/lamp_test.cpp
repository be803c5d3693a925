// A character that is lit, glows, emits over a lit colour and is unlit: another renderer shows all of it, or fails.
#include <algorithm>

#include "tests/parity/peer_trial.h"
#include "tests/support/gltf_maker.h"

namespace parity_test
{
namespace
{

// Four plates side by side.
std::string lamp()
{
    using claque::testing::Maker;
    using GltfJson = claque::testing::Json;
    Maker maker;
    const auto material = [](std::array<double, 4> base, std::array<double, 3> emission) {
        return GltfJson{
            {"pbrMetallicRoughness", {{"baseColorFactor", base}}}, {"emissiveFactor", emission}, {"doubleSided", true}};
    };
    maker.json["materials"] = {material({0.3, 0.2, 0.1, 1}, {0, 0, 0}), material({0, 0, 0, 1}, {0.1, 0.6, 0.8}),
                               material({0.2, 0.05, 0.05, 1}, {0.02, 0.2, 0}), material({0.1, 0.5, 0.1, 1}, {0, 0, 0})};
    maker.json["materials"][3]["extensions"]["KHR_materials_unlit"] = GltfJson::object();
    maker.add("nodes", {{"mesh", 0}});
    maker.json["scenes"] = GltfJson::array({{{"nodes", {0}}}});
    maker.json["meshes"] = GltfJson::array({{{"primitives", GltfJson::array()}}});
    const int indices = maker.accessor<uint16_t>(claque::testing::u16, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
    for (int i = 0; i < 4; ++i) {
        const float left = 0.3f * float(i) - 0.6f, right = left + 0.3f;
        const int at = maker.floats("VEC3", 4, {left, 0, 0, right, 0, 0, right, 1.8f, 0, left, 1.8f, 0});
        maker.json["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", at}}}, {"indices", indices}, {"material", i}});
    }
    const claque::testing::Bytes bytes = maker.glb();
    return {bytes.begin(), bytes.end()};
}

class Lamp : public PeerTrial
{
protected:
    void SetUp() override { begin("parade", 3, lamp()); }
};

TEST_F(Lamp, IsShownByAPeerAsItIsExported)
{
    EXPECT_EQ(broken(draw(scene(), {Limiting::zones, 0}), "gpu"), "");
    EXPECT_EQ(std::count_if(scene().materials.begin(), scene().materials.end(),
                            [](const Material &material) { return material.unlit; }),
              1);
}

TEST_F(Lamp, LeftOutOfLightIsCaught)
{
    for (const bool emission : {true, false}) {
        SceneIn changed = scene();
        for (Material &material : changed.materials) {
            if (emission) material.emission = {};
            else material.unlit = false;
        }
        EXPECT_NE(broken(draw(changed, {Limiting::zones, 0}), "gpu").find("colour."), std::string::npos) << emission;
    }
}

}  // namespace
}  // namespace parity_test
