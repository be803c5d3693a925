// The patrician: mesh, gown, weights, texture and colours.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "person.h"

using namespace claque;

namespace patrician_test
{

namespace
{

const model::Model &patrician()
{
    static const model::Model made = figures::patrician_woman();
    return made;
}
const model::Part &part() { return patrician().parts[0]; }

uint8_t key_at(uint32_t vertex) { return puppet::key_at(patrician(), part().uvs[vertex]); }
uint8_t key_of(const std::string &zone) { return puppet::key_of(patrician(), zone); }

// The leftmost cloth between two heights.
float half_width(float low, float high)
{
    float widest = 0;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const glm::vec3 p = part().positions[v];
        const uint8_t key = key_at(v);
        if (p.y > low && p.y < high && key != key_of("skin") && key != key_of("jewellery") && p.x < 0.30f)
            widest = std::max(widest, p.x);
    }
    return widest;
}

}  // namespace

TEST(Patrician, IsAWomanInALongGownWithAWaistAndHighHair)
{
    const model::Model man = figures::citizen();
    float low = 1e9f, hem = 1e9f, top = 0, mans_top = 0;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const float y = part().positions[v].y;
        low = std::min(low, y), top = std::max(top, y);
        if (key_at(v) == key_of("border")) hem = std::min(hem, y);
    }
    for (const glm::vec3 p : man.parts[0].positions) mans_top = std::max(mans_top, p.y);
    EXPECT_FLOAT_EQ(low, 0);
    EXPECT_LT(hem, 0.10f);
    EXPECT_GT(top, mans_top + 0.015f);
    const float girdle = half_width(1.18f, 1.21f), hips = half_width(0.85f, 0.95f), feet = half_width(0.02f, 0.10f);
    EXPECT_GT(girdle, 0.10f);
    EXPECT_GT(hips, 1.3f * girdle);
    EXPECT_GT(feet, hips);
}

TEST(Patrician, HasABreastAboveHerGirdle)
{
    float breast = 0, girdle = 0;
    for (const glm::vec3 p : part().positions) {
        if (std::fabs(p.x + 0.07f) > 0.03f) continue;
        if (std::fabs(p.y - 1.275f) < 0.02f) breast = std::max(breast, p.z);
        if (std::fabs(p.y - 1.196f) < 0.02f) girdle = std::max(girdle, p.z);
    }
    EXPECT_GT(girdle, 0.05f);
    EXPECT_GT(breast, girdle + 0.03f);
}

// Open edges: arms and feet inside the cloth, the roots of thumbs and index fingers inside the palm, the ears' edges
// against the head, the bun's against the hair, and the band of the palla where it lies in the dress.
TEST(Patrician, IsClosedButForEdgesThatAreHidden)
{
    const int doubled = puppet::for_open_edges(part(), [](uint32_t v) {
        const auto [x, y, z] = puppet::place(part(), v);
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_gown = std::fabs(y - 0.150f) < 0.001f && at.x < 0.14f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.06f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.055f && y > 1.58f && y < 1.66f;
        const bool under_bun = z < -0.02f && y > 1.64f && y < 1.78f && at.x < 0.06f;
        const glm::vec2 texel = part().uvs[v] * 512.0f;
        const bool in_dress = texel.x > 270 && texel.y > 344 && texel.y < 408;  // the band's chart
        EXPECT_TRUE(under_gown || in_sleeve || in_palm || ear || under_bun || in_dress)
            << "open at " << x << ' ' << y << ' ' << z;
    });
    EXPECT_EQ(doubled, 0) << "an edge is used twice the same way";
}

TEST(PatricianTexture, ShowsEachOfHerTenZonesAndNoOtherKey)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(part()))
        puppet::for_texels(part(), t, [&](size_t i) { ++shown[patrician().images[0].rgba[4 * i + 3]]; });
    std::set<std::string> names;
    for (const model::Zone &z : patrician().zones) {
        names.insert(z.name);
        EXPECT_GT(shown[z.key], 100) << z.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "belt", "border", "sandals",
                                            "outer", "jewellery"}));
    EXPECT_EQ(shown.size(), 10u);
}

TEST(PatricianColours, OfClothAreRich)
{
    for (const model::Zone &z : patrician().zones) {
        if (z.name != "tunic" && z.name != "outer") continue;
        EXPECT_GE(z.range.saturation_min, 0.40f) << z.name;
        EXPECT_LE(z.range.saturation_max, 0.80f) << z.name;
        EXPECT_GE(z.range.brightness_min, 0.45f) << z.name;
    }
}

}  // namespace patrician_test
