// The spheres of characters that were read from files: as those of the built-in ones they are proved over all moments
// of all clips and over all blends (S0 4.1, S2 3.3), so that dense random samples stay inside; and they are snug.
#include <gtest/gtest.h>

#include "collected.h"
#include "meshsplit/blend_reach.h"
#include "models.h"
#include "reach_sampling.h"

namespace claque::test
{

namespace
{

// Per character: moments of clips, and as many blends of clips.
constexpr uint32_t moment_count = 10000, blend_count = 10000;

// How many times the farthest sample a sphere may be. Samples miss the one extreme moment of a file with many clips.
constexpr double snug = 1.05;

const std::vector<std::string> people_and_animals = {"humanoids/kaykit/Barbarian.glb",
                                                     "humanoids/quaternius-ultimate/Suit_Female.gltf",
                                                     "humanoids/quaternius-modular/Man_Suit.glb",
                                                     "humanoids/quaternius-fbx/PlatformerCharacter.glb",
                                                     "humanoids/gdquest/gdbot.glb",
                                                     "humanoids/kenney/character.glb",
                                                     "humanoids/khronos/CesiumMan.glb",
                                                     "animals/khronos/Fox.glb"};

void expect_moments_held(const model::Template &tmpl, const std::string &name, double most)
{
    const Sampled found = sample_reach(tmpl, glm::dvec3(tmpl.sklsroot.centre), moment_count);
    const double radius = double(tmpl.sklsroot.radius);
    EXPECT_LE(found.vertex, radius);
    EXPECT_LE(radius, most * found.vertex);
    for (size_t n = 0; n < found.node.size(); ++n) {
        EXPECT_LE(found.node[n], double(tmpl.node_reach[n].distance) * (1 + 1e-6) + 1e-6) << "node " << n;
        EXPECT_LE(found.stretch[n], double(tmpl.node_reach[n].scale) * (1 + 1e-6)) << "node " << n;
    }
    ::testing::Test::RecordProperty(name, std::to_string(radius / found.vertex));
}

void expect_blends_held(const model::Template &tmpl, const std::string &name)
{
    for (const float added : {0.0f, model::max_additive_weight}) {
        SCOPED_TRACE(added);
        const Sampled found = sample_blends(tmpl, glm::dvec3(tmpl.sklsroot.centre), blend_count / 2, added);
        const double radius = double(tmpl.blend_radius.at(added));
        EXPECT_LE(found.vertex, radius);
        for (size_t n = 0; n < found.node.size(); ++n)
            EXPECT_LE(found.node[n], double(tmpl.blend_reach[n].distance.at(added)) * (1 + 1e-6) + 1e-6)
                << "node " << n;
        ::testing::Test::RecordProperty(name + " blended, " + std::to_string(added),
                                        std::to_string(radius / found.vertex));
    }
}

// What a template gets whose clips are too long to be searched (allowance.h): larger, and as certain.
void expect_lengths_hold(model::Template &tmpl, const std::string &name)
{
    const double searched = double(tmpl.sklsroot.radius);
    meshsplit::bound_by_lengths(meshsplit::key_extents(tmpl.rig), tmpl);
    const Sampled found = sample_reach(tmpl, glm::dvec3(tmpl.sklsroot.centre), moment_count / 10);
    EXPECT_LE(found.vertex, double(tmpl.sklsroot.radius));
    for (size_t n = 0; n < found.node.size(); ++n)
        EXPECT_LE(found.node[n], double(tmpl.node_reach[n].distance) * (1 + 1e-6) + 1e-6) << "node " << n;
    ::testing::Test::RecordProperty(name + " by lengths", std::to_string(double(tmpl.sklsroot.radius) / searched));
}

void expect_proved(const std::vector<std::string> &names, double most)
{
    for (const std::string &name : names) {
        SCOPED_TRACE(name);
        const auto tmpl = built(loaded(name), 64);
        expect_moments_held(*tmpl, name, most);
        expect_blends_held(*tmpl, name);
        expect_lengths_hold(*tmpl, name);
    }
}

}  // namespace

TEST(ReachCharacters, ThatWereCollectedStayInTheirSpheres)
{
    if (!collected_are_there()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR;
    expect_proved(people_and_animals, snug);
}

TEST(ReachCharacters, ThatWereWrittenStayInTheirSpheres) { expect_proved(written::characters(), snug); }

}  // namespace claque::test
