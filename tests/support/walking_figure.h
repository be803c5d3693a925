// A figure of boxes that walks in place, with the traits of other people's files: where it faces, and what it lacks.
#pragma once

#include <cmath>
#include <string>

#include "tests/support/written_encoding.h"
#include "tests/support/written_motion.h"

namespace claque::testing
{

struct FigureTraits {
    float heading_deg = 0;  // 0: +z, 90: +x; written into the root node
    bool toes = true, eyes = true;
    bool walks_backwards = false;  // its clips, in its own eyes
    bool lies = false;             // on its face
    float feet_deg = 0;            // both are turned by this from where it faces
    bool runs = true;              // or its clip 'Run' only stands
    bool has_run = true;           // or its only clip is 'Walk'
    float offset_m = 0;            // its clips move it behind its origin by this
    bool strange_names = false;    // of the legs' nodes
    bool knees = true;             // or each leg is one node
    bool feet = true;              // or they have the names of controls
    float rest_deg = 0;            // it is turned by this at rest, and not in its clips
    float turns_deg = 0;           // in its clips
    float walk_deg = 0;            // it is turned by this in its clip 'Walk' alone
    float size = 1;
    bool arms = false;
    float alpha = 1;                                   // below 1 it blends
    const char *before_clips = "", *after_clips = "";  // of the names of its clips
    const char *walk = "Walk";
};

class WalkingFigure
{
public:
    explicit WalkingFigure(const FigureTraits &traits) : traits_(traits)
    {
        material_ = add_material(maker_, "cloth", -1, {0.5f, 0.4f, 0.3f, traits.alpha});
        if (traits.alpha < 1) maker_.json["materials"][static_cast<size_t>(material_)]["alphaMode"] = "BLEND";
        const int hips = bone("Hips", {0, 0.87f, 0}, {0, 0.1f, 0}, {0.15f, 0.12f, 0.1f});
        const int head = bone("Head", {0, 0.6f, 0}, {0, 0.12f, 0.02f}, {0.09f, 0.12f, 0.1f});
        children(hips, {head});
        if (traits.eyes) {
            const int left = bone("LeftEye", {0.03f, 0.1f, 0.1f}, {0, 0, 0}, {0.01f, 0.01f, 0.01f});
            const int right = bone("RightEye", {-0.03f, 0.1f, 0.1f}, {0, 0, 0}, {0.01f, 0.01f, 0.01f});
            children(head, {left, right});
        }
        for (int side = 0; side < 2; ++side) leg(side, hips);
        if (traits.arms) {
            const int left = bone("LeftArm", {0.2f, 0.45f, 0}, {0, -0.2f, 0}, {0.04f, 0.2f, 0.04f});
            const int right = bone("RightArm", {-0.2f, 0.45f, 0}, {0, -0.2f, 0}, {0.04f, 0.2f, 0.04f});
            children(hips, {left, right});
        }
        const Four about_y = turn({0, 1, 0}, traits.heading_deg + traits.rest_deg), flat = turn({1, 0, 0}, 90);
        const float size = traits.size;
        root_ = maker_.add("nodes", {{"name", "Root"},
                                     {"children", {hips}},
                                     {"rotation", traits.lies ? flat : about_y},
                                     {"scale", {size, size, size}}});
        maker_.json["scenes"] = Json::array({{{"nodes", {root_}}}});
        gait(traits.walk, 1, true);
        if (traits.has_run) gait("Run", 0.5f, traits.runs);
    }

    Bytes glb() const { return maker_.glb(); }

private:
    int bone(const std::string &name, const Triple &at, const Triple &centre, const Triple &half)
    {
        const int mesh = maker_.add(
            "meshes",
            {{"primitives", Json::array({primitive_of(maker_, box(centre, half, {0, 0, 1, 1}), material_)})}});
        return maker_.add("nodes", {{"name", name}, {"translation", at}, {"mesh", mesh}});
    }
    void children(int node, const std::vector<int> &list)
    {
        Json &all = maker_.json["nodes"][static_cast<size_t>(node)]["children"];
        for (const int child : list) all.push_back(child);
    }
    void leg(int side, int hips)
    {
        const std::string left = side == 0 ? "Left" : "Right", strange = side == 0 ? "A" : "B";
        const auto name = [&](const char *usual, const char *other) {
            return traits_.strange_names ? strange + other : left + usual;
        };
        const float x = side == 0 ? 0.1f : -0.1f;
        if (!traits_.knees) {
            thighs_[side] = bone("leg-" + std::string(side == 0 ? "left" : "right"), {x, 0, 0}, {0, -0.43f, 0},
                                 {0.06f, 0.43f, 0.06f});
            children(hips, {thighs_[side]});
            return;
        }
        const int thigh = bone(name("UpLeg", "1"), {x, 0, 0}, {0, -0.2f, 0}, {0.06f, 0.2f, 0.06f});
        const int shin = bone(name("Leg", "2"), {0, -0.42f, 0}, {0, -0.2f, 0}, {0.05f, 0.2f, 0.05f});
        const int foot =
            bone(name(traits_.feet ? "Foot" : "FootIK", "3"), {0, -0.4f, 0}, {0, -0.03f, 0.05f}, {0.04f, 0.02f, 0.11f});
        children(hips, {thigh}), children(thigh, {shin}), children(shin, {foot});
        maker_.json["nodes"][static_cast<size_t>(foot)]["rotation"] = turn({0, 1, 0}, traits_.feet_deg);
        if (traits_.toes)
            children(foot, {bone(name("ToeBase", "4"), {0, -0.03f, 0.1f}, {0, 0, 0.03f}, {0.04f, 0.02f, 0.03f})});
        thighs_[side] = thigh, shins_[side] = shin;
    }
    // A leg goes back straight in the first half of its cycle, and forward bent in the second one.
    void gait(const char *name, float length_s, bool moves)
    {
        const std::string whole = traits_.before_clips + std::string(name) + traits_.after_clips;
        ClipMaker clip(maker_, whole.c_str());
        constexpr size_t keys = 25;
        const std::vector<float> times = times_from(0, length_s / (keys - 1), keys);
        for (int side = 0; side < 2; ++side) {
            std::vector<float> thigh, shin;
            for (size_t k = 0; k < keys; ++k) {
                double phase = double(k) / (keys - 1) + 0.5 * side;
                if (traits_.walks_backwards) phase = -phase;
                phase -= std::floor(phase);
                const double angle = 6.283185307179586 * phase;
                thigh.push_back(moves ? static_cast<float>(-25 * std::cos(angle)) : 0);
                shin.push_back(moves && phase > 0.5 ? static_cast<float>(-50 * std::sin(angle)) : 0);
            }
            clip.add(thighs_[side], "rotation", "LINEAR", times, turns({1, 0, 0}, thigh));
            if (traits_.knees) clip.add(shins_[side], "rotation", "LINEAR", times, turns({1, 0, 0}, shin));
        }
        const float walk = name == traits_.walk ? traits_.walk_deg : 0;
        const float from = traits_.heading_deg + walk, turned = traits_.turns_deg;
        if (traits_.rest_deg != 0 || traits_.walk_deg != 0 || turned != 0)
            clip.add(root_, "rotation", "LINEAR", {0, length_s / 2, length_s},
                     turns({0, 1, 0}, {from - turned / 2, from, from + turned / 2}));
        const float z = -traits_.offset_m;
        if (z != 0) clip.add(root_, "translation", "LINEAR", {0, length_s}, {0, 0, z, 0, 0, z});
        clip.finish();
    }

    FigureTraits traits_;
    Maker maker_;
    int material_ = 0, root_ = 0, thighs_[2] = {0, 0}, shins_[2] = {0, 0};
};

inline Bytes walking_figure(const FigureTraits &traits = {}) { return WalkingFigure(traits).glb(); }

}  // namespace claque::testing
