// Characters of several nodes and parts, for the tests of levels, parts and skeletons.
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/pose/pose.h"
#include "models.h"

namespace claque::test
{

constexpr float for_ever = std::numeric_limits<float>::infinity();

inline uint32_t add_node(model::Model &m, uint32_t parent, const char *name, glm::vec3 at)
{
    m.rig.parents.push_back(parent);
    m.rig.rest.push_back({at, glm::quat(1, 0, 0, 0), glm::vec3(1)});
    m.rig.node_names.emplace_back(name);
    return m.rig.node_count() - 1;
}

inline uint32_t add_entry(model::Model &m, uint32_t node, const math::Affine &inverse_bind = {})
{
    m.rig.palette.push_back({node, inverse_bind});
    return static_cast<uint32_t>(m.rig.palette.size() - 1);
}

// root - spine - arm - hand - finger and root - leg, each 1 above the last, leg beside; without geometry.
struct Puppet : model::Model {
    uint32_t root, spine, arm, hand, finger, leg;
    Puppet()
    {
        name = "puppet";
        root = add_node(*this, model::none, "root", {0, 0, 0});
        spine = add_node(*this, root, "spine", {0, 1, 0});
        arm = add_node(*this, spine, "arm", {0, 1, 0});
        hand = add_node(*this, arm, "hand", {0, 1, 0});
        finger = add_node(*this, hand, "finger", {0, 1, 0});
        leg = add_node(*this, root, "leg", {1, 0, 0});
    }
    void stop(uint32_t node, float distance_m)
    {
        if (rig.deactivation_m.empty()) rig.deactivation_m.assign(rig.node_count(), for_ever);
        rig.deactivation_m[node] = distance_m;
    }
    // A flat grid of n * n * 2 triangles, 1 by 1, rigid on a node.
    model::Part &hang(uint32_t node, const char *part_name, float first_m = 0, float last_m = for_ever, uint32_t n = 1)
    {
        model::Part part = sheet_part(n, n);
        part.name = part_name;
        part.material = model::none;
        part.node = node;
        part.lod_min_m = first_m, part.lod_max_m = last_m;
        std::fill(part.joints.begin(), part.joints.end(), add_entry(*this, node));
        parts.push_back(part);
        return parts.back();
    }
    math::Affine inverse_rest(uint32_t node) const
    {
        pose::Workspace workspace(rig);
        workspace.pose(model::none, 0);
        return math::inverse(workspace.global(node));
    }
    // A sheet 1 wide from y = 0 to 5, each row of vertices shared by the two nearest of these nodes.
    model::Part &skin(const std::vector<uint32_t> &nodes, const char *part_name, float first_m = 0,
                      float last_m = for_ever)
    {
        model::Part part = sheet_part(2, 20);
        part.name = part_name;
        part.material = model::none;
        part.node = root;
        part.skinned = true;
        part.lod_min_m = first_m, part.lod_max_m = last_m;
        std::vector<uint32_t> entries;
        for (const uint32_t node : nodes) entries.push_back(add_entry(*this, node, inverse_rest(node)));
        part.influence_count = 2;
        part.joints.clear(), part.weights.clear();
        for (glm::vec3 &p : part.positions) {
            p.y *= 5;
            const float along = p.y / 5 * float(nodes.size() - 1);
            const uint32_t k = std::min(uint32_t(along), uint32_t(nodes.size() - 2));
            const float second = along - float(k);
            part.joints.insert(part.joints.end(), {entries[k], entries[k + 1]});
            part.weights.insert(part.weights.end(), {1 - second, second});
        }
        parts.push_back(part);
        return parts.back();
    }
    // Swings nodes about z.
    void swing(const std::vector<uint32_t> &nodes)
    {
        rig.clips.push_back({static_cast<uint32_t>(rig.channels.size()), static_cast<uint32_t>(nodes.size()), 0, 2});
        rig.clip_names.emplace_back("swing");
        const uint32_t first_time = static_cast<uint32_t>(rig.times.size());
        for (const float t : {0.0f, 1.0f, 2.0f}) rig.times.push_back(t);
        for (const uint32_t node : nodes) {
            const uint32_t first = static_cast<uint32_t>(rig.values.size());
            const float s = std::sin(0.4f + 0.1f * float(node)), c = std::cos(0.4f + 0.1f * float(node));
            for (const float side : {1.0f, -1.0f, 1.0f})
                for (const float v : {0.0f, 0.0f, side * s, c}) rig.values.push_back(v);
            rig.channels.push_back(
                {node, model::ChannelTarget::rotation, model::Interpolation::linear, 4, first_time, 3, first});
        }
    }
};

inline std::string refused(const model::Model &m, clq_status status = CLQ_ARGUMENT)
{
    try {
        built(m);
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), status);
        return error.what();
    }
    return "";
}

inline ::testing::AssertionResult says(const std::string &text, const std::vector<const char *> &words)
{
    for (const char *word : words)
        if (text.find(word) == std::string::npos)
            return ::testing::AssertionFailure() << "'" << word << "' is not in: " << text;
    return ::testing::AssertionSuccess();
}

// Source vertices of the triangles of a level, each triangle once, in the order of surfaces and bins.
inline std::vector<uint32_t> corners_of(const model::Level &level)
{
    std::vector<uint32_t> out;
    const auto add = [&](model::IndexRange range) {
        for (uint32_t i = 0; i < range.count; ++i) out.push_back(level.indices[range.first + i]);
    };
    for (const model::Surface &surface : level.surfaces) {
        for (const model::Bin &bin : surface.clean) add(bin.range);
        add(surface.dirty);
    }
    return out;
}

}  // namespace claque::test
