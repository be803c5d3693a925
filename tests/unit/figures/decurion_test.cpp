// The decurion: mesh, toga, weights, texture and colours.
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "puppet.h"

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

using Place = std::tuple<float, float, float>;
Place place(uint32_t v) { return {part().positions[v].x, part().positions[v].y, part().positions[v].z}; }

uint8_t key_at(uint32_t vertex)
{
    const glm::vec2 at = part().uvs[vertex] * 512.0f;
    return decurion().images[0].rgba[4 * (size_t(at.y) * 512 + size_t(at.x)) + 3];
}
uint8_t key_of(const std::string &zone)
{
    for (const model::Zone &z : decurion().zones)
        if (z.name == zone) return z.key;
    return 255;
}

// How far the trunk's cloth reaches ahead between two heights, of either character: arms hang beside it.
float ahead(const model::Part &of, float low, float high)
{
    float farthest = 0;
    for (const glm::vec3 p : of.positions)
        if (p.y > low && p.y < high && std::fabs(p.x) < 0.20f) farthest = std::max(farthest, p.z);
    return farthest;
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

TEST(Decurion, IsABuiltInCharacterFoundByName)
{
    bool found = false;
    for (const figures::Builtin &builtin : figures::builtins()) found |= std::string(builtin.name) == "decurion";
    EXPECT_TRUE(found);
    EXPECT_NO_THROW(model::check(decurion()));
}

TEST(Decurion, HasAbout1040Triangles33BonesAndAtMost4Influences)
{
    ASSERT_EQ(decurion().parts.size(), 1u);
    EXPECT_GE(model::triangles_of(part()).size(), 950u);
    EXPECT_LE(model::triangles_of(part()).size(), 1100u);
    EXPECT_EQ(part().influence_count, 4u);
    EXPECT_EQ(decurion().rig.node_names, figures::citizen().rig.node_names) << "clips are shared";
    for (size_t v = 0; v < part().positions.size(); ++v) {
        float sum = 0;
        for (size_t k = 0; k < 4; ++k) sum += part().weights[4 * v + k];
        EXPECT_NEAR(sum, 1, 1e-5f);
    }
}

TEST(Decurion, HasTheClipsOfEveryCharacter)
{
    const model::Model man = figures::citizen();
    EXPECT_EQ(decurion().rig.clips.size(), man.rig.clips.size());
    EXPECT_EQ(decurion().rig.clip_names, man.rig.clip_names);
}

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

TEST(Decurion, HasNoDegenerateTriangleAndNormalsThatAgree)
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

// Open edges: arms and boots inside the cloth, the roots of thumbs and index fingers inside the palm, the ears' edges
// against the head, and roll and umbo where they lie in the dress.
TEST(Decurion, IsClosedButForEdgesThatAreHidden)
{
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto &t : model::triangles_of(part()))
        for (size_t k = 0; k < 3; ++k) ++edges[{place(t[k]), place(t[(k + 1) % 3])}];
    for (const auto &[edge, count] : edges) {
        EXPECT_EQ(count, 1) << "an edge is used twice the same way";
        if (edges.count({edge.second, edge.first})) continue;
        const auto [x, y, z] = edge.first;
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_toga = std::fabs(y - 0.165f) < 0.001f && at.x < 0.14f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.07f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.060f && y > 1.57f && y < 1.67f;
        const bool in_dress = y > 0.80f && y < 1.46f && at.x < 0.20f;
        EXPECT_TRUE(under_toga || in_sleeve || in_palm || ear || in_dress) << "open at " << x << ' ' << y << ' ' << z;
    }
}

TEST(Decurion, KeepsWeightsEqualWhereverVerticesShareAPosition)
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

TEST(Decurion, IsMadeOfTheSameBytesEveryTime)
{
    const model::Model again = figures::decurion_man();
    const model::Part &b = again.parts[0];
    EXPECT_EQ(decurion().images[0].rgba, again.images[0].rgba);
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

TEST(DecurionTexture, ShowsEachOfHisNineZonesAndNoOtherKey)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(part()))
        texels(t, [&](size_t i) { ++shown[decurion().images[0].rgba[4 * i + 3]]; });
    std::set<std::string> names;
    for (const model::Zone &z : decurion().zones) {
        names.insert(z.name);
        EXPECT_GT(shown[z.key], 60) << z.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "border", "sandals", "outer",
                                            "jewellery"}));
    EXPECT_EQ(shown.size(), 9u);
}

TEST(DecurionTexture, NeverLaysOneTriangleOverAnother)
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

TEST(DecurionTexture, IsGreyAndLightSoThatColoursReachTheEye)
{
    const std::vector<uint8_t> &pixels = decurion().images[0].rgba;
    size_t bright = 0;
    for (size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_EQ(pixels[i], pixels[i + 1]);
        ASSERT_EQ(pixels[i], pixels[i + 2]);
        bright += pixels[i] >= 150;
    }
    EXPECT_GT(bright, pixels.size() / 4 * 7 / 10);
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
