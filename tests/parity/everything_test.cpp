// The scene `everything` has what the parity page describes, and a renderer that leaves one of these things out fails.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/parity/peer_trial.h"

namespace parity_test
{
namespace
{

constexpr PeerOptions zone_by_zone = {Limiting::zones, 0};

class Everything : public PeerTrial
{
protected:
    void SetUp() override
    {
        begin("everything", 9);
        if (IsSkipped()) return;
        // The mistakes below take these away.
        ASSERT_EQ(scene().lighting.lights.size(), 4u);
        for (const Mesh &mesh : scene().meshes) {
            ASSERT_EQ(mesh.joints.size(), 2u);
            ASSERT_EQ(mesh.targets.size(), 2u);
        }
    }

    // The peer's result of the scene with a mistake must exceed this limit.
    void expect_broken(const char *measure, const std::function<void(SceneIn &)> &mistake)
    {
        SceneIn changed = scene();
        mistake(changed);
        const std::string said = broken(draw(changed, zone_by_zone), "gpu");
        EXPECT_NE(said.find(measure), std::string::npos) << "said: " << said;
    }
    template <class Change>
    static std::function<void(SceneIn &)> each_mesh(Change change)
    {
        return [change](SceneIn &changed) {
            for (Mesh &mesh : changed.meshes) change(mesh);
        };
    }
};

bool mirrors(const float *rows)
{
    const auto m = [&](int r, int c) { return rows[4 * r + c]; };
    return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) - m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
               m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0)) <
           0;
}

TEST_F(Everything, IsInTheSceneOfThatName)
{
    const auto some = [](const auto &list, auto condition) { return std::any_of(list.begin(), list.end(), condition); };
    const std::vector<Individual> &all = scene().individuals;
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Individual &individual) { return individual.mirrored; }),
              3);
    for (const Individual &individual : all) {
        const float *m = individual.model_view.data();  // column after column, whose transpose has the same determinant
        EXPECT_EQ(mirrors(m), individual.mirrored);
        size_t mirroring = 0;
        for (size_t joint = 0; joint < individual.palette_count; ++joint)
            mirroring += mirrors(&scene().palettes[12 * (individual.first_palette + joint)]);
        EXPECT_EQ(mirroring, 1u) << "the left arm";
        EXPECT_EQ(individual.weight_count, 2u);
    }
    EXPECT_TRUE(some(all, [&](const Individual &individual) {
        return scene().json["meshes"][individual.mesh]["texture_set"] == 1;
    }));
    EXPECT_TRUE(some(scene().weights, [](float weight) { return weight > 0.1f; }));
    for (const Mesh &mesh : scene().meshes) {
        EXPECT_TRUE(mesh.normals_by_inverse);
        EXPECT_TRUE(some(mesh.weights[1], [](float weight) { return weight > 0; }));
        EXPECT_EQ(std::count_if(mesh.weights[0].begin(), mesh.weights[0].end(), [](float w) { return w == 1; }),
                  11 * 15 + 9 * 15 + 2 * 13 * 11 + 9 * 13 + 24)
            << "rigid parts";
        EXPECT_TRUE(some(mesh.colours, [](uint8_t channel) { return channel < 200; }));
    }
    EXPECT_TRUE(some(scene().materials, [](const Material &material) { return material.double_sided; }));
    EXPECT_TRUE(some(scene().materials, [](const Material &material) { return !material.double_sided; }));
    EXPECT_TRUE(some(scene().materials, [](const Material &material) { return material.holes; }));
    EXPECT_EQ(scene().fog.mode, "exp2");
    const std::vector<Light> &lights = scene().lighting.lights;
    EXPECT_EQ(lights[0].position[3], 0);
    EXPECT_EQ(lights[2].position[3], 1);
    EXPECT_FALSE(lights[2].spot);
    EXPECT_GT(lights[2].attenuation[2], 0);
    EXPECT_TRUE(lights[3].spot);
    EXPECT_GT(lights[3].spot_exponent, 1);
    EXPECT_LT(lights[3].spot_cutoff_deg, 45);
    EXPECT_EQ(limiting_for(scene().lighting), Limiting::zones);
}

TEST_F(Everything, IsDrawnAlikeZoneByZone) { EXPECT_EQ(broken(draw(scene(), zone_by_zone), "gpu"), ""); }

TEST_F(Everything, NeedsMoreThanFourKnots)
{
    EXPECT_NE(broken(draw(scene(), {Limiting::knots, 0}), "gpu").find("colour.over_2"), std::string::npos);
}

TEST_F(Everything, LeftOutOfSkinningIsCaught)
{
    expect_broken("positions.max_relative",
                  each_mesh([](Mesh &mesh) { mesh.joints.pop_back(), mesh.weights.pop_back(); }));
    // The first four made to sum to 1, as some loaders do.
    expect_broken("positions.max_relative", each_mesh([](Mesh &mesh) {
                      mesh.joints.pop_back(), mesh.weights.pop_back();
                      for (size_t i = 0; i < mesh.weights[0].size(); i += 4) {
                          float *w = &mesh.weights[0][i];
                          const float sum = w[0] + w[1] + w[2] + w[3];
                          for (int k = 0; k < 4; ++k) w[k] /= sum;
                      }
                  }));
    expect_broken("positions.max_relative", each_mesh([](Mesh &mesh) { mesh.targets.pop_back(); }));
    expect_broken("normals.max_deg", each_mesh([](Mesh &mesh) { mesh.normals_by_inverse = false; }));
}

TEST_F(Everything, LeftOutOfSurfacesIsCaught)
{
    expect_broken("zone_ids.", [](SceneIn &changed) {
        for (Individual &individual : changed.individuals) individual.mirrored = false;
    });
    expect_broken("_ids.", [](SceneIn &changed) {
        for (Material &material : changed.materials) material.double_sided = false;
    });
    expect_broken("colour.worst_zone", each_mesh([](Mesh &mesh) { mesh.colours.clear(); }));
    expect_broken("zone_ids.worst_zone", [](SceneIn &changed) {
        for (Individual &individual : changed.individuals) individual.mesh = 0;
    });
}

TEST_F(Everything, LeftOutOfLightIsCaught)
{
    for (size_t light = 0; light < 4; ++light)
        expect_broken("colour.", [&](SceneIn &changed) { changed.lighting.lights[light].diffuse = {}; });
    expect_broken("colour.", [](SceneIn &changed) { changed.lighting.lights[3].spot = false; });
    expect_broken("colour.", [](SceneIn &changed) { changed.lighting.lights[3].spot_exponent = 0; });
    expect_broken("colour.", [](SceneIn &changed) { changed.lighting.lights[2].attenuation = {1, 0, 0}; });
    expect_broken("colour.", [](SceneIn &changed) { changed.lighting.lights[2].position[3] = 0; });
    expect_broken("colour.", [](SceneIn &changed) { changed.fog.mode.clear(); });
    expect_broken("colour.", [](SceneIn &changed) { changed.fog.mode = "exp"; });
}

}  // namespace
}  // namespace parity_test
