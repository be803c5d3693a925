// The decurion: mesh, toga, weights, texture and colours.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "person.h"

using namespace claque;

namespace decurion_test
{

namespace
{

const model::Model &decurion()
{
    static const model::Model made = figures::decurion_man();
    return made;
}
const model::Part &part() { return decurion().parts[0]; }

uint8_t key_at(uint32_t vertex) { return puppet::key_at(decurion(), part().uvs[vertex]); }
uint8_t key_of(const std::string &zone) { return puppet::key_of(decurion(), zone); }

// How far the trunk's cloth reaches ahead between two heights, of either character: arms hang beside it.
float ahead(const model::Part &of, float low, float high)
{
    float farthest = 0;
    for (const glm::vec3 p : of.positions)
        if (p.y > low && p.y < high && std::fabs(p.x) < 0.20f) farthest = std::max(farthest, p.z);
    return farthest;
}

}  // namespace

TEST(Decurion, IsAManInATogaToTheShinsWithABelly)
{
    const model::Model citizen = figures::citizen();
    float low = 1e9f, hem = 1e9f, top = 0;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const float y = part().positions[v].y;
        low = std::min(low, y), top = std::max(top, y);
        if (key_at(v) == key_of("border")) hem = std::min(hem, y);
    }
    EXPECT_FLOAT_EQ(low, 0);
    EXPECT_NEAR(top, 1.75f, 0.02f);
    EXPECT_GT(hem, 0.08f) << "the boots show";
    EXPECT_LT(hem, 0.25f);
    EXPECT_GT(ahead(part(), 0.95f, 1.08f), ahead(citizen.parts[0], 0.95f, 1.08f) + 0.04f);
}

TEST(Decurion, WearsTheTogaOverHisLeftShoulderAndTheTunicOnHisRight)
{
    size_t toga_left = 0, toga_right = 0, tunic_left = 0, tunic_right = 0;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const glm::vec3 p = part().positions[v];
        if (p.y < 1.20f || std::fabs(p.x) < 0.14f) continue;
        toga_left += p.x > 0 && key_at(v) == key_of("outer");
        toga_right += p.x < 0 && key_at(v) == key_of("outer");
        tunic_left += p.x > 0 && key_at(v) == key_of("tunic");
        tunic_right += p.x < 0 && key_at(v) == key_of("tunic");
    }
    EXPECT_GT(toga_left, 20u);
    EXPECT_EQ(toga_right, 0u);
    EXPECT_EQ(tunic_left, 0u);
    EXPECT_GT(tunic_right, 15u);
}

// The great fold's border hangs lower before the right thigh than beside the left hip.
TEST(Decurion, CarriesABorderThatRisesFromRightToLeft)
{
    float right = 1e9f, left = 1e9f;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const glm::vec3 p = part().positions[v];
        if (p.y < 0.45f || p.y > 1.0f || p.z < 0 || std::fabs(p.x) < 0.09f || key_at(v) != key_of("border")) continue;
        float &least = p.x < 0 ? right : left;
        least = std::min(least, p.y);
    }
    EXPECT_LT(right, 0.66f);
    EXPECT_GT(left, right + 0.03f);
    EXPECT_LT(left, 1.0f) << "there is a border on the left as well";
}

// Open edges: arms and boots inside the cloth, the roots of thumbs and index fingers inside the palm, the ears' edges
// against the head, and roll and umbo where they lie in the dress.
TEST(Decurion, IsClosedButForEdgesThatAreHidden)
{
    const int doubled = puppet::for_open_edges(part(), [](uint32_t v) {
        const auto [x, y, z] = puppet::place(part(), v);
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_toga = std::fabs(y - 0.165f) < 0.001f && at.x < 0.14f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.07f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.060f && y > 1.57f && y < 1.67f;
        const bool in_dress = y > 0.80f && y < 1.46f && at.x < 0.20f;
        EXPECT_TRUE(under_toga || in_sleeve || in_palm || ear || in_dress) << "open at " << x << ' ' << y << ' ' << z;
    });
    EXPECT_EQ(doubled, 0) << "an edge is used twice the same way";
}

// Raised arms lift the cloth below the armpits by a hand's width; cloth further down stays with the trunk in every
// pose.
TEST(Decurion, TearsNoClothInAnyClip)
{
    for (const char *name : puppet::clip_names) {
        const uint32_t clip = decurion().rig.find_clip(name);
        ASSERT_LT(clip, decurion().rig.clips.size()) << name;
        for (int frame = 0; frame < puppet::frames(decurion(), clip); frame += 6) {
            const puppet::Posed posed = puppet::pose(decurion(), clip, float(frame) * puppet::frame_s);
            float longest = 0;
            glm::vec3 where(0);
            for (const auto &t : model::triangles_of(part()))
                for (size_t k = 0; k < 3; ++k) {
                    const uint32_t a = t[k], b = t[(k + 1) % 3];
                    const float rest = glm::distance(part().positions[a], part().positions[b]);
                    const float grown = glm::distance(posed.vertices[a], posed.vertices[b]) - rest;
                    const bool trunk = part().positions[a].y < 1.30f && part().positions[a].y > 0.95f &&
                                       std::fabs(part().positions[a].x) < 0.24f;
                    if (trunk && grown > longest) longest = grown, where = part().positions[a];
                }
            EXPECT_LT(longest, 0.16f) << name << " frame " << frame << " near " << where.x << ' ' << where.y << ' '
                                      << where.z;
        }
    }
}

TEST(DecurionTexture, ShowsEachOfHisNineZonesAndNoOtherKey)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(part()))
        puppet::for_texels(part(), t, [&](size_t i) { ++shown[decurion().images[0].rgba[4 * i + 3]]; });
    std::set<std::string> names;
    for (const model::Zone &z : decurion().zones) {
        names.insert(z.name);
        EXPECT_GT(shown[z.key], 60) << z.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "border", "sandals", "outer",
                                            "jewellery"}));
    EXPECT_EQ(shown.size(), 9u);
}

TEST(DecurionColours, AreRichBelowATogaFromCreamToDyed)
{
    for (const model::Zone &z : decurion().zones) {
        if (z.name == "tunic" || z.name == "border") {
            EXPECT_GE(z.range.saturation_min, 0.40f) << z.name;
            EXPECT_LE(z.range.saturation_max, 0.80f) << z.name;
            EXPECT_LE(z.range.brightness_max, 0.85f) << z.name;
        }
        if (z.name == "outer") {
            EXPECT_LE(z.range.saturation_min, 0.10f);
            EXPECT_GE(z.range.saturation_max, 0.50f);
        }
        if (z.name == "hair") {
            EXPECT_LE(z.range.saturation_max, 0.30f) << "grey";
        }
    }
}

}  // namespace decurion_test
