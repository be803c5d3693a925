// Built-in characters that fly, in rigid parts: nodes and degrees of freedom, levels of detail, textures, and clips (S0
// 3, 5.1, 5.2, 7.1).
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/figures/figure.h"

namespace
{

using namespace claque;
using glm::vec3;
using model::Model;
using model::Part;

constexpr float for_ever = std::numeric_limits<float>::infinity();

const Model &flyer(const std::string &name)
{
    static std::map<std::string, Model> made;
    if (made.find(name) == made.end())
        for (const figures::Builtin &builtin : figures::builtins())
            if (builtin.name == name) made[name] = builtin.make();
    return made.at(name);
}

// Position of a node in the rest pose.
vec3 joint(const Model &m, uint32_t node)
{
    vec3 at(0);
    for (; node != model::none; node = m.rig.parents[node]) at += m.rig.rest[node].translation;
    return at;
}

std::set<float> distances(const Model &m)
{
    std::set<float> out = {0};
    for (const Part &part : m.parts) out.insert(part.lod_min_m);
    return out;
}

std::vector<const Part *> drawn_at(const Model &m, float distance)
{
    std::vector<const Part *> out;
    for (const Part &part : m.parts)
        if (part.lod_min_m <= distance && distance < part.lod_max_m) out.push_back(&part);
    return out;
}

size_t triangles_at(const Model &m, float distance)
{
    size_t count = 0;
    for (const Part *part : drawn_at(m, distance)) count += part->indices.size() / 3;
    return count;
}

struct Box {
    vec3 low = vec3(1e9f), high = vec3(-1e9f);
};

Box box_at(const Model &m, float distance)
{
    Box box;
    for (const Part *part : drawn_at(m, distance))
        for (const vec3 &p : part->positions) {
            const vec3 q = p + joint(m, part->node);
            box.low = glm::min(box.low, q), box.high = glm::max(box.high, q);
        }
    return box;
}

float stop_of(const Model &m, uint32_t node)
{
    float stop = for_ever;
    for (; node != model::none; node = m.rig.parents[node]) stop = std::min(stop, m.rig.deactivation_of(node));
    return stop;
}

class Flyer : public testing::TestWithParam<const char *>
{
protected:
    const Model &m = flyer(GetParam());
};

TEST_P(Flyer, Has13NodesThatMoveAnd19DegreesOfFreedom)
{
    std::set<uint32_t> moving;
    for (const model::Dof &dof : m.rig.dofs) moving.insert(dof.node);
    EXPECT_EQ(moving.size(), 13u);
    EXPECT_EQ(m.rig.dofs.size(), 19u);
    EXPECT_EQ(m.rig.node_count(), 14u) << "with the body, which only clips move";
    EXPECT_EQ(m.rig.node_names[0], "body");
}

TEST_P(Flyer, HasDegreesOfFreedomWithTheNamesThatMechanismsBindTo)
{
    for (const char *name :
         {"spine_yaw", "spine_pitch", "neck_yaw", "neck_pitch", "head_roll", "eye_left_yaw", "eye_left_pitch",
          "eye_right_yaw", "eye_right_pitch", "lids", "jaw", "brow", "wing_left_flap", "wing_left_sweep",
          "wing_right_flap", "wing_right_sweep", "arm_left", "arm_right", "legs"}) {
        const uint32_t at = m.rig.find_dof(name);
        ASSERT_NE(at, model::none) << name;
        EXPECT_LE(m.rig.dofs[at].min, 0) << name;
        EXPECT_GT(m.rig.dofs[at].max, 0) << name;
        EXPECT_EQ(m.rig.dofs[at].rest, 0) << name;
    }
}

vec3 turned(const Model &m, const char *dof, vec3 what)
{
    const model::Dof &d = m.rig.dofs[m.rig.find_dof(dof)];
    const float a = d.max / 2;
    return glm::quat(std::cos(a), d.axis * std::sin(a)) * what;
}

TEST_P(Flyer, TurnsInTheDirectionOfItsDegreesOfFreedom)
{
    const vec3 ahead(0, 0, 1), up(0, 1, 0), left(1, 0, 0);
    for (const char *yaw : {"spine_yaw", "neck_yaw", "eye_left_yaw", "eye_right_yaw"})
        EXPECT_GT(turned(m, yaw, ahead).x, 0.1f) << yaw << " is positive to its left";
    for (const char *pitch : {"spine_pitch", "neck_pitch", "eye_left_pitch", "eye_right_pitch"})
        EXPECT_GT(turned(m, pitch, ahead).y, 0.1f) << pitch << " is positive upwards";
    EXPECT_GT(turned(m, "head_roll", up).x, 0.1f);
    EXPECT_LT(turned(m, "lids", ahead).y, -0.5f);
    EXPECT_LT(turned(m, "jaw", ahead).y, -0.1f);
    EXPECT_LT(turned(m, "wing_left_flap", left).z, -0.5f) << "it lies on the air, so up is behind its back";
    EXPECT_LT(turned(m, "wing_right_flap", -left).z, -0.5f);
    EXPECT_LT(turned(m, "wing_left_sweep", left).y, -0.3f);
    EXPECT_LT(turned(m, "wing_right_sweep", -left).y, -0.3f);
    EXPECT_GT(turned(m, "arm_left", -up).z, 0.3f);
    EXPECT_LT(turned(m, "legs", -up).z, -0.1f);
}

TEST_P(Flyer, HasFewerTrianglesFromLevelToLevel)
{
    size_t before = 1401;
    for (const float distance : distances(m)) {
        EXPECT_LT(triangles_at(m, distance), before) << "from " << distance << " m";
        before = triangles_at(m, distance);
    }
    EXPECT_GE(triangles_at(m, 0), 900u);
    EXPECT_LE(triangles_at(m, 30), 700u);
    EXPECT_LE(triangles_at(m, 64), 320u);
    EXPECT_LE(triangles_at(m, 200), 130u);
    EXPECT_LE(triangles_at(m, 500), 36u);
}

TEST_P(Flyer, KeepsItsOutlineAtEveryLevel)
{
    const Box fine = box_at(m, 0);
    for (const float distance : distances(m)) {
        const Box box = box_at(m, distance);
        // A pixel at 768 lines and 60 degrees, or a tenth of its size.
        const float pixel = 0.0015f * distance;
        for (int k = 0; k < 3; ++k) {
            const float room = std::max(pixel, 0.10f * (fine.high[k] - fine.low[k]));
            EXPECT_NEAR(box.low[k], fine.low[k], room) << "axis " << k << " from " << distance << " m";
            EXPECT_NEAR(box.high[k], fine.high[k], room) << "axis " << k << " from " << distance << " m";
        }
    }
}

TEST_P(Flyer, HasPiecesWhoseLevelsAdjoinFrom0UntilTheirNodeStops)
{
    std::map<std::string, std::vector<const Part *>> pieces;
    for (const Part &part : m.parts) pieces[part.name].push_back(&part);
    std::set<float> ends = {0};
    for (const Part &part : m.parts)
        if (part.lod_max_m == stop_of(m, part.node)) ends.insert(part.lod_max_m);
    std::set<size_t> counts;
    for (const auto &[name, levels] : pieces) {
        // A replacing part begins where another part ends.
        EXPECT_TRUE(ends.count(levels.front()->lod_min_m) || levels.front()->lod_min_m == 160) << name;
        for (size_t i = 1; i < levels.size(); ++i) {
            EXPECT_EQ(levels[i]->lod_min_m, levels[i - 1]->lod_max_m) << name;
            EXPECT_LT(levels[i]->indices.size(), levels[i - 1]->indices.size()) << name;
            EXPECT_EQ(levels[i]->node, levels[0]->node) << name;
        }
        counts.insert(levels.size());
    }
    EXPECT_GE(counts.size(), 3u) << "pieces have levels of their own";
}

TEST_P(Flyer, EndsPartsWhereTheirNodesStopAndLetsOthersBeginThere)
{
    EXPECT_EQ(stop_of(m, 0), for_ever);
    for (const Part &part : m.parts) {
        const float stop = stop_of(m, part.node);
        EXPECT_LE(part.lod_max_m, stop) << part.name;
        if (part.lod_max_m != stop || stop == for_ever) continue;
        EXPECT_TRUE(
            std::any_of(m.parts.begin(), m.parts.end(),
                        [&](const Part &next) { return next.lod_min_m == stop && stop_of(m, next.node) > stop; }))
            << part.name << " ends at " << stop << " m";
    }
    for (const char *name : {"eye_left", "eye_right", "lids", "jaw", "brow"})
        EXPECT_EQ(stop_of(m, m.rig.find_node(name)), 35) << name;
}

TEST_P(Flyer, IsDrawnByRigidPartsAlone)
{
    for (const Part &part : m.parts) {
        EXPECT_FALSE(part.skinned) << part.name;
        EXPECT_EQ(part.influence_count, 1u) << part.name;
        for (const uint32_t entry : part.joints) ASSERT_EQ(m.rig.palette[entry].node, part.node) << part.name;
    }
}

TEST_P(Flyer, IsPaintedWithTheKeysOfItsZonesAlone)
{
    ASSERT_EQ(m.images.size(), 1u);
    ASSERT_EQ(m.images[0].alpha, model::AlphaMeaning::zone_keys);
    std::map<int, size_t> texels;
    for (size_t i = 3; i < m.images[0].rgba.size(); i += 4) ++texels[m.images[0].rgba[i]];
    EXPECT_GE(m.zones.size(), 6u);
    EXPECT_EQ(texels.size(), m.zones.size());
    for (const model::Zone &zone : m.zones) EXPECT_GT(texels[zone.key], 30u) << zone.name;
}

TEST_P(Flyer, HasTextureCoordinatesAndUnitNormals)
{
    for (const Part &part : m.parts)
        for (size_t i = 0; i < part.positions.size(); ++i) {
            ASSERT_GT(std::min(part.uvs[i].x, part.uvs[i].y), 0) << part.name;
            ASSERT_LT(std::max(part.uvs[i].x, part.uvs[i].y), 1) << part.name;
            ASSERT_NEAR(glm::length(part.normals[i]), 1, 1e-4f) << part.name;
        }
}

// Vertex normals look to the same side as the faces of the vertex, except for folds of under a fiftieth.
TEST_P(Flyer, HasNormalsOnTheOutsideOfItsFaces)
{
    for (const Part &part : m.parts) {
        size_t wrong = 0;
        for (const auto &t : model::triangles_of(part)) {
            const vec3 *p = part.positions.data();
            const vec3 face = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
            const vec3 sum = part.normals[t[0]] + part.normals[t[1]] + part.normals[t[2]];
            wrong += glm::dot(face, sum) <= 0;
        }
        EXPECT_LE(wrong * 50, part.indices.size() / 3) << part.name << " from " << part.lod_min_m << " m";
    }
}

TEST_P(Flyer, IsMadeOfPiecesThatAreVisibleFromOutside)
{
    // Wings at coarse levels are two faces without space between them.
    for (const char *name : {"head", "chest", "wing_left", "wing_right", "legs", "eye_left"})
        for (const Part &part : m.parts) {
            if (part.name != name) continue;
            float volume = 0;
            vec3 middle(0);
            for (const vec3 &p : part.positions) middle += p / static_cast<float>(part.positions.size());
            for (const auto &t : model::triangles_of(part))
                volume += glm::dot(part.positions[t[0]] - middle,
                                   glm::cross(part.positions[t[1]] - middle, part.positions[t[2]] - middle));
            EXPECT_GT(volume, -1e-6f) << name << " from " << part.lod_min_m << " m";
        }
}

TEST_P(Flyer, HasClipsThatClose)
{
    for (const char *name : {"fly", "glide", "hover"}) {
        const uint32_t c = m.rig.find_clip(name);
        ASSERT_NE(c, model::none) << name;
        const model::Clip &clip = m.rig.clips[c];
        for (uint32_t i = 0; i < clip.channel_count; ++i) {
            const model::Channel &channel = m.rig.channels[clip.first_channel + i];
            const float *v = m.rig.values.data() + channel.first_value;
            const size_t n = channel.component_count, last = n * (channel.key_count - 1);
            float seam = 0, most = 0;
            for (size_t k = 0; k < n; ++k) {
                ASSERT_EQ(v[k], v[last + k]) << name;
                seam = std::max(seam, std::fabs(v[last + k] - v[last - n + k]));
                for (size_t key = 1; key < channel.key_count; ++key)
                    most = std::max(most, std::fabs(v[key * n + k] - v[(key - 1) * n + k]));
            }
            EXPECT_LE(seam, most) << name << ": a jump at the loop's seam";
            EXPECT_LT(most, 0.35f) << name << ": a jump within the clip";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Flyer, testing::Values("herald", "owl"),
                         [](const auto &i) { return std::string(i.param); });

}  // namespace
