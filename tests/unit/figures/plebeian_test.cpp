// The plebeian: requirements of every built-in character, and differences from the citizen.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "person.h"

using namespace claque;

namespace plebeian_test
{

namespace
{

const model::Model &plebeian()
{
    static const model::Model made = figures::plebeian_man();
    return made;
}
const model::Part &part() { return plebeian().parts[0]; }

uint8_t key_at(glm::vec2 uv) { return puppet::key_at(plebeian(), uv); }
uint8_t key_of(const std::string &zone) { return puppet::key_of(plebeian(), zone); }

// The zone key of the surface nearest to a point.
uint8_t nearest_key(glm::vec3 at)
{
    float least = 1e9f;
    uint8_t key = 0;
    for (const auto &t : model::triangles_of(part())) {
        const glm::vec3 middle = (part().positions[t[0]] + part().positions[t[1]] + part().positions[t[2]]) / 3.0f;
        if (glm::distance(middle, at) >= least) continue;
        least = glm::distance(middle, at);
        key = key_at((part().uvs[t[0]] + part().uvs[t[1]] + part().uvs[t[2]]) / 3.0f);
    }
    return key;
}

float lowest_of(const model::Model &model, const std::string &zone)
{
    uint8_t key = 255;
    for (const model::Zone &z : model.zones)
        if (z.name == zone) key = z.key;
    float low = 1e9f;
    const model::Part &p = model.parts[0];
    for (const auto &t : model::triangles_of(p)) {
        const glm::vec2 middle = (p.uvs[t[0]] + p.uvs[t[1]] + p.uvs[t[2]]) / 3.0f;
        for (const uint32_t v : t) {
            const glm::vec2 uv = (p.uvs[v] * 0.9f + middle * 0.1f) * 512.0f;  // just inside
            if (model.images[0].rgba[4 * (size_t(uv.y) * 512 + size_t(uv.x)) + 3] == key)
                low = std::min(low, p.positions[v].y);
        }
    }
    return low;
}

}  // namespace

// Open edges: the legs inside the skirt, the left arm inside the sleeve, the roots of thumbs and index fingers inside
// the palm, the ears' edges against the head, and the cloak's edges, which lie in the tunic.
TEST(Plebeian, IsClosedButForEdgesThatAreHidden)
{
    const int doubled = puppet::for_open_edges(part(), [](uint32_t v) {
        const auto [x, y, z] = puppet::place(part(), v);
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_skirt = y > 0.70f && y < 0.80f && at.x < 0.17f;
        const bool in_sleeve = x > 0 && glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.06f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.058f && y > 1.575f && y < 1.66f;
        const bool cloak = key_at(part().uvs[v]) == key_of("outer") && x > 0;
        EXPECT_TRUE(under_skirt || in_sleeve || in_palm || ear || cloak) << "open at " << x << ' ' << y << ' ' << z;
    });
    EXPECT_EQ(doubled, 0) << "an edge is used twice the same way";
}

TEST(Plebeian, KeepsNormalsEqualWhereTheBareNeckHasASeam)
{
    std::map<puppet::Place, uint32_t> first;
    int neck = 0;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const auto [at, fresh] = first.try_emplace(puppet::place(part(), v), v);
        const glm::vec3 p = part().positions[v];
        if (fresh || p.y < 1.41f || p.y > 1.48f || p.x > 0.1f || p.x < -0.1f) continue;
        EXPECT_LT(glm::distance(part().normals[v], part().normals[at->second]), 1e-4f) << "neck at vertex " << v;
        ++neck;
    }
    EXPECT_GT(neck, 4);
}

TEST(Plebeian, IsBareOnTheRightBreastAndShoulderAndDressedOnTheLeft)
{
    EXPECT_EQ(nearest_key({-0.10f, 1.39f, 0.10f}), key_of("skin"));
    EXPECT_EQ(nearest_key({-0.22f, 1.40f, 0.0f}), key_of("skin"));
    EXPECT_EQ(nearest_key({-0.11f, 1.40f, -0.11f}), key_of("skin"));
    EXPECT_EQ(nearest_key({0.25f, 1.39f, 0.0f}), key_of("tunic"));
    EXPECT_EQ(nearest_key({0.08f, 1.30f, 0.16f}), key_of("outer"));
    EXPECT_EQ(nearest_key({-0.10f, 1.15f, 0.10f}), key_of("tunic"));
}

TEST(Plebeian, WearsHisHemAboveTheKneeUnlikeTheCitizen)
{
    EXPECT_FLOAT_EQ(lowest_of(plebeian(), "sandals"), 0);
    EXPECT_GT(lowest_of(plebeian(), "border"), 0.56f);
    EXPECT_LT(lowest_of(puppet::citizen(), "border"), 0.53f);
}

TEST(Plebeian, HasPlainerColoursThanACitizen)
{
    for (const model::Zone &z : plebeian().zones) {
        if (z.name != "tunic" && z.name != "outer" && z.name != "border") continue;
        EXPECT_GE(z.range.saturation_min, 0.05f) << z.name;
        EXPECT_LE(z.range.saturation_max, 0.35f) << z.name;
        EXPECT_GE(z.range.brightness_min, 0.35f) << z.name;
        EXPECT_LE(z.range.brightness_max, 0.70f) << z.name;
    }
}

TEST(PlebeianTexture, ShowsAllNineZonesOnTrianglesThatDoNotOverlap)
{
    std::set<std::string> names;
    for (const model::Zone &z : plebeian().zones) names.insert(z.name);
    EXPECT_EQ(names,
              (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "belt", "border", "sandals", "outer"}));
    const std::vector<uint8_t> &pixels = plebeian().images[0].rgba;
    std::vector<uint8_t> taken(512 * 512, 0);
    std::map<int, int> shown;
    int overlaps = 0;
    for (const auto &t : model::triangles_of(part()))
        puppet::for_texels(part(), t, [&](size_t i) {
            overlaps += taken[i];
            taken[i] = 1;
            ++shown[pixels[4 * i + 3]];
        });
    EXPECT_EQ(overlaps, 0);
    EXPECT_EQ(shown.size(), plebeian().zones.size());
    for (const model::Zone &z : plebeian().zones) EXPECT_GT(shown[z.key], 60) << z.name;
}

// No edge of the surface is stretched to much more than twice its length.
TEST(Plebeian, DoesNotTearInAnyClip)
{
    for (uint32_t c = 0; c < plebeian().rig.clips.size(); ++c)
        for (int k = 0; k < puppet::frames(plebeian(), c); k += 6) {
            const puppet::Posed p = puppet::pose(plebeian(), c, float(k) * puppet::frame_s);
            for (const auto &t : model::triangles_of(part()))
                for (size_t i = 0; i < 3; ++i) {
                    const uint32_t a = t[i], b = t[(i + 1) % 3];
                    const float rest = glm::distance(part().positions[a], part().positions[b]);
                    EXPECT_LT(glm::distance(p.vertices[a], p.vertices[b]), 2.0f * rest + 0.03f)
                        << plebeian().rig.clip_names[c] << " frame " << k << " near " << part().positions[a].x << ' '
                        << part().positions[a].y << ' ' << part().positions[a].z;
                }
        }
}

// Seats are 0.65 m wide: no part of a sitter reaches onto the next seat.
TEST(Plebeian, KeepsToHisSeat)
{
    for (const char *name : puppet::seated_clips) {
        const uint32_t c = plebeian().rig.find_clip(name);
        ASSERT_NE(c, model::none) << name;
        for (int k = 0; k < puppet::frames(plebeian(), c); k += 5)
            for (const glm::vec3 v : puppet::pose(plebeian(), c, float(k) * puppet::frame_s).vertices)
                EXPECT_LT(std::fabs(v.x), 0.325f) << name << " frame " << k << " at height " << v.y;
    }
}

}  // namespace plebeian_test
