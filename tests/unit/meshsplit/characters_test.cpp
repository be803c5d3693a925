// Skeletal levels and spheres of parts of the collected characters, where they are, and of the written ones.
#include <gtest/gtest.h>

#include "collected.h"
#include "lib/model/template_check.h"
#include "meshsplit/level_plan.h"
#include "posed.h"

namespace claque::test
{

namespace
{

const std::vector<std::string> collected = {"humanoids/kaykit/Barbarian.glb",
                                            "humanoids/quaternius-ultimate/Suit_Female.gltf",
                                            "humanoids/quaternius-modular/Man_Suit.glb",
                                            "humanoids/quaternius-fbx/PlatformerCharacter.glb",
                                            "humanoids/gdquest/gdbot.glb",
                                            "humanoids/kenney/character.glb",
                                            "humanoids/khronos/CesiumMan.glb",
                                            "machines/khronos/CesiumMilkTruck.glb",
                                            "machines/quaternius/Tank2.glb",
                                            "animals/quaternius/Spider.glb",
                                            "animals/khronos/Fox.glb"};

uint32_t depth_of(const model::Rig &rig, uint32_t node)
{
    uint32_t depth = 0;
    for (; rig.parents[node] != model::none; node = rig.parents[node]) ++depth;
    return depth;
}

// All nodes of the deeper half stop at 20 m; rigid parts on them are hidden, everything else goes on. Whether anything
// skinned loses a node by that.
bool stop_half(model::Model &m)
{
    uint32_t deepest = 0;
    for (const model::PaletteEntry &entry : m.rig.palette) deepest = std::max(deepest, depth_of(m.rig, entry.node));
    m.rig.deactivation_m.assign(m.rig.node_count(), for_ever);
    for (uint32_t i = 1; i < m.rig.node_count(); ++i)
        if (depth_of(m.rig, i) > deepest / 2) m.rig.deactivation_m[i] = 20;
    bool any = false;
    for (model::Part &part : m.parts) {
        const uint32_t entry = meshsplit::rigid_entry(part);
        if (entry != model::none && m.rig.deactivation_of(m.rig.palette[entry].node) < for_ever) part.hidden = true;
        any = any || (entry == model::none && !part.hidden);
    }
    return any;
}

// Returns how many had skinned surfaces to compare.
size_t expect_the_same_at_rest(const std::vector<std::string> &names)
{
    size_t compared = 0;
    for (const std::string &name : names) {
        model::Model m = loaded(name);
        if (!stop_half(m)) continue;
        const auto tmpl = built(m);
        EXPECT_EQ(tmpl->levels.size(), 2u) << name;
        if (tmpl->levels.size() != 2) continue;
        model::check(*tmpl);
        const std::vector<glm::vec3> near = posed(*tmpl, 0, model::none, 0), far = posed(*tmpl, 1, model::none, 0);
        if (near.size() != far.size()) continue;  // triangles between stopped nodes have lost their area
        ++compared;
        EXPECT_LT(largest_difference(near, far), 2e-5f * tmpl->sklsroot.radius) << name;
        EXPECT_LT(tmpl->levels[1].nodes.size(), tmpl->rig.node_count()) << name;
        EXPECT_LT(tmpl->levels[1].entries.size(), tmpl->levels[0].entries.size() + 1) << name;
    }
    return compared;
}

void expect_inside_spheres(const std::vector<std::string> &names)
{
    for (const std::string &name : names) {
        SCOPED_TRACE(name);
        const auto tmpl = built(loaded(name));
        pose::Workspace workspace(tmpl->rig);
        const uint32_t clips = std::min<uint32_t>(3, static_cast<uint32_t>(tmpl->rig.clips.size()));
        for (uint32_t clip = 0; clip < clips; ++clip)
            for (int i = 0; i < 6; ++i) {
                const model::Clip &c = tmpl->rig.clips[clip];
                const auto palette = workspace.pose(clip, double(c.start_s) + double(c.duration_s) * i / 5.3);
                expect_held(*tmpl, tmpl->levels[0], palette.data, workspace.weights().data);
            }
    }
}

}  // namespace

TEST(Characters, WithHalfOfTheirNodesStoppedStandAtRestAsTheyDid)
{
    if (!collected_are_there()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR;
    EXPECT_GE(expect_the_same_at_rest(collected), 5u);
}

TEST(Characters, StayInsideTheSpheresOfTheirPartsInEveryClip)
{
    if (!collected_are_there()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR;
    expect_inside_spheres(collected);
}

TEST(WrittenCharacters, WithHalfOfTheirNodesStoppedStandAtRestAsTheyDid)
{
    EXPECT_GE(expect_the_same_at_rest(written::characters()), 5u);
}

TEST(WrittenCharacters, StayInsideTheSpheresOfTheirPartsInEveryClip) { expect_inside_spheres(written::characters()); }

}  // namespace claque::test
