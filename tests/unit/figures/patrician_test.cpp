// The patrician: mesh, gown, weights, texture and colours.
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "lib/figures/figure.h"

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

using Place = std::tuple<float, float, float>;
Place place(uint32_t v) { return {part().positions[v].x, part().positions[v].y, part().positions[v].z}; }

uint8_t key_at(uint32_t vertex)
{
    const glm::vec2 at = part().uvs[vertex] * 512.0f;
    return patrician().images[0].rgba[4 * (size_t(at.y) * 512 + size_t(at.x)) + 3];
}
uint8_t key_of(const std::string &zone)
{
    for (const model::Zone &z : patrician().zones)
        if (z.name == zone) return z.key;
    return 255;
}

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

float cross2(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

// Calls with the index of every texel whose centre lies inside the triangle.
template <class Visit>
void texels(const std::array<uint32_t, 3> &t, Visit visit)
{
    glm::vec2 p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = part().uvs[t[k]] * 512.0f;
    const float area = cross2(p[1] - p[0], p[2] - p[0]);
    if (area == 0) return;
    const glm::vec2 low = min(p[0], min(p[1], p[2])), high = max(p[0], max(p[1], p[2]));
    for (int y = int(low.y); y <= std::min(511, int(high.y)); ++y)
        for (int x = int(low.x); x <= std::min(511, int(high.x)); ++x) {
            const glm::vec2 c(float(x) + 0.5f, float(y) + 0.5f);
            const float a = cross2(p[1] - c, p[2] - c) / area, b = cross2(p[2] - c, p[0] - c) / area;
            constexpr float inside = 1e-3f;
            if (a > inside && b > inside && 1 - a - b > inside) visit(size_t(y) * 512 + size_t(x));
        }
}

}  // namespace

TEST(Patrician, IsABuiltInCharacterFoundByName)
{
    bool found = false;
    for (const figures::Builtin &builtin : figures::builtins()) found |= std::string(builtin.name) == "patrician";
    EXPECT_TRUE(found);
    EXPECT_NO_THROW(model::check(patrician()));
}

TEST(Patrician, HasAbout1040Triangles33BonesAndAtMost4Influences)
{
    ASSERT_EQ(patrician().parts.size(), 1u);
    EXPECT_GE(model::triangles_of(part()).size(), 950u);
    EXPECT_LE(model::triangles_of(part()).size(), 1100u);
    EXPECT_EQ(part().influence_count, 4u);
    EXPECT_EQ(patrician().rig.node_names, figures::citizen().rig.node_names) << "clips are shared";
    for (size_t v = 0; v < part().positions.size(); ++v) {
        float sum = 0;
        for (size_t k = 0; k < 4; ++k) sum += part().weights[4 * v + k];
        EXPECT_NEAR(sum, 1, 1e-5f);
    }
}

TEST(Patrician, HasTheClipsOfEveryCharacter)
{
    const model::Model man = figures::citizen();
    EXPECT_EQ(patrician().rig.clips.size(), man.rig.clips.size());
    EXPECT_EQ(patrician().rig.clip_names, man.rig.clip_names);
}

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

TEST(Patrician, HasNoDegenerateTriangleAndNormalsThatAgree)
{
    size_t against = 0;
    for (const auto &t : model::triangles_of(part())) {
        const glm::vec3 a = part().positions[t[0]];
        const glm::vec3 n = glm::cross(part().positions[t[1]] - a, part().positions[t[2]] - a);
        EXPECT_GT(glm::length(n), 2e-6f) << "near " << a.x << ' ' << a.y << ' ' << a.z;
        for (const uint32_t v : t) against += glm::dot(n, part().normals[v]) < 0;
    }
    EXPECT_LE(against, 16u) << "a few corners of thin fingers and ears may look away";
}

// Open edges: arms and feet inside the cloth, the roots of thumbs and index fingers inside the palm, the ears' edges
// against the head, the bun's against the hair, and the band of the palla where it lies in the dress.
TEST(Patrician, IsClosedButForEdgesThatAreHidden)
{
    struct Edge {
        int count = 0;
        uint32_t vertex = 0;
    };
    std::map<std::pair<Place, Place>, Edge> edges;
    for (const auto &t : model::triangles_of(part()))
        for (size_t k = 0; k < 3; ++k) {
            Edge &edge = edges[{place(t[k]), place(t[(k + 1) % 3])}];
            ++edge.count, edge.vertex = t[k];
        }
    for (const auto &[edge, found] : edges) {
        EXPECT_EQ(found.count, 1) << "an edge is used twice the same way";
        if (edges.count({edge.second, edge.first})) continue;
        const auto [x, y, z] = edge.first;
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_gown = std::fabs(y - 0.150f) < 0.001f && at.x < 0.14f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.06f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.055f && y > 1.58f && y < 1.66f;
        const bool under_bun = z < -0.02f && y > 1.64f && y < 1.78f && at.x < 0.06f;
        const glm::vec2 texel = part().uvs[found.vertex] * 512.0f;
        const bool in_dress = texel.x > 270 && texel.y > 344 && texel.y < 408;  // the band's chart
        EXPECT_TRUE(under_gown || in_sleeve || in_palm || ear || under_bun || in_dress)
            << "open at " << x << ' ' << y << ' ' << z;
    }
}

TEST(Patrician, KeepsWeightsEqualWhereverVerticesShareAPosition)
{
    std::map<Place, uint32_t> first;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const auto [at, fresh] = first.try_emplace(place(v), v);
        if (fresh) continue;
        const auto total = [](uint32_t vertex, uint32_t bone) {
            float sum = 0;
            for (size_t k = 0; k < 4; ++k)
                if (part().joints[4 * vertex + k] == bone) sum += part().weights[4 * vertex + k];
            return sum;
        };
        for (uint32_t bone = 0; bone < 33; ++bone)
            EXPECT_NEAR(total(v, bone), total(at->second, bone), 1e-5f) << "seam would tear at vertex " << v;
    }
}

TEST(Patrician, IsMadeOfTheSameBytesEveryTime)
{
    const model::Model again = figures::patrician_woman();
    const model::Part &b = again.parts[0];
    EXPECT_EQ(patrician().images[0].rgba, again.images[0].rgba);
    EXPECT_EQ(part().indices, b.indices);
    EXPECT_EQ(part().joints, b.joints);
    EXPECT_EQ(part().weights, b.weights);
    const auto same = [](const auto &x, const auto &y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    EXPECT_TRUE(same(part().positions, b.positions));
    EXPECT_TRUE(same(part().normals, b.normals));
    EXPECT_TRUE(same(part().uvs, b.uvs));
}

TEST(PatricianTexture, ShowsEachOfHerTenZonesAndNoOtherKey)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(part()))
        texels(t, [&](size_t i) { ++shown[patrician().images[0].rgba[4 * i + 3]]; });
    std::set<std::string> names;
    for (const model::Zone &z : patrician().zones) {
        names.insert(z.name);
        EXPECT_GT(shown[z.key], 100) << z.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "belt", "border", "sandals",
                                            "outer", "jewellery"}));
    EXPECT_EQ(shown.size(), 10u);
}

TEST(PatricianTexture, NeverLaysOneTriangleOverAnother)
{
    std::vector<uint8_t> taken(512 * 512, 0);
    size_t overlaps = 0;
    glm::vec3 where(0);
    for (const auto &t : model::triangles_of(part()))
        texels(t, [&](size_t i) {
            if (taken[i]) ++overlaps, where = part().positions[t[0]];
            taken[i] = 1;
        });
    EXPECT_EQ(overlaps, 0u) << "last near " << where.x << ' ' << where.y << ' ' << where.z;
}

TEST(PatricianTexture, IsGreyAndLightSoThatColoursReachTheEye)
{
    const std::vector<uint8_t> &pixels = patrician().images[0].rgba;
    size_t bright = 0;
    for (size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_EQ(pixels[i], pixels[i + 1]);
        ASSERT_EQ(pixels[i], pixels[i + 2]);
        bright += pixels[i] >= 150;
    }
    EXPECT_GT(bright, pixels.size() / 4 * 7 / 10);
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
