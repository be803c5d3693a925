// What the written characters must load as, counted by hand from what makes them, and a motion capture file.
#include <cmath>
#include <cstdio>

#include "tests/support/written_files.h"

namespace claque::testing
{
namespace
{

struct ListedClip {
    const char *name;
    float start_s, end_s;
    int channels;
};

Json row(const char *file, int primitives, int vertices, int influences, int joints,
         const std::vector<ListedClip> &clips)
{
    Json out = {{"file", file},
                {"primitives", primitives},
                {"vertices", vertices},
                {"max_influences", influences},
                {"distinct_joints", joints},
                {"clips", Json::array()}};
    for (const ListedClip &clip : clips)
        out["clips"].push_back(
            {{"name", clip.name}, {"start", clip.start_s}, {"seconds", clip.end_s}, {"channels", clip.channels}});
    return out;
}

// The frame at 0 s is the T-pose, as conversions of the CMU's files have it; then two and a half seconds of a walk.
constexpr int walk_frames = 126;
constexpr float walk_frame_s = 0.02f;

struct WalkJoint {
    const char *name;
    int depth;
    float x, y, z;
};
constexpr WalkJoint walk_joints[] = {{"Hips", 0, 0, 0, 0},
                                     {"LHipJoint", 1, 0, 0, 0},
                                     {"LeftUpLeg", 2, 1.4f, -1.8f, 0.8f},
                                     {"LeftLeg", 3, 2.4f, -6.7f, 0},
                                     {"LeftFoot", 4, 2.6f, -7, 0},
                                     {"LeftToeBase", 5, 0.2f, -0.4f, 2.3f},
                                     {"RHipJoint", 1, 0, 0, 0},
                                     {"RightUpLeg", 2, -1.4f, -1.8f, 0.8f},
                                     {"RightLeg", 3, -2.4f, -6.7f, 0},
                                     {"RightFoot", 4, -2.6f, -7, 0},
                                     {"RightToeBase", 5, -0.2f, -0.4f, 2.3f},
                                     {"LowerBack", 1, 0, 0, 0},
                                     {"Spine", 2, 0, 2, -0.2f},
                                     {"Spine1", 3, 0.1f, 2, 0},
                                     {"Neck", 4, 0, 0, 0},
                                     {"Neck1", 5, -0.1f, 1.7f, 0.2f},
                                     {"Head", 6, 0.1f, 1.8f, -0.1f},
                                     {"LeftShoulder", 4, 0, 0, 0},
                                     {"LeftArm", 5, 3.4f, 1.2f, -0.3f},
                                     {"LeftForeArm", 6, 5, 0, 0},
                                     {"LeftHand", 7, 3.5f, 0, 0},
                                     {"RightShoulder", 4, 0, 0, 0},
                                     {"RightArm", 5, -3.4f, 1.2f, -0.3f},
                                     {"RightForeArm", 6, -5, 0, 0},
                                     {"RightHand", 7, -3.5f, 0, 0}};
constexpr int walk_joint_count = sizeof walk_joints / sizeof *walk_joints;

std::string number(float value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.5f", static_cast<double>(value));
    return text;
}

std::string hierarchy()
{
    std::string out = "HIERARCHY\n";
    for (int i = 0; i < walk_joint_count; ++i) {
        const WalkJoint &joint = walk_joints[i];
        out += (i == 0 ? "ROOT " : "JOINT ") + std::string(joint.name) + "\n{\nOFFSET " + number(joint.x) + " " +
               number(joint.y) + " " + number(joint.z) + "\n";
        out += i == 0 ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
                      : "CHANNELS 3 Zrotation Yrotation Xrotation\n";
        const int next = i + 1 < walk_joint_count ? walk_joints[i + 1].depth : 0;
        if (next <= joint.depth) out += "End Site\n{\nOFFSET 0 1 0\n}\n";
        for (int depth = joint.depth; depth >= next; --depth) out += "}\n";
    }
    return out;
}

}  // namespace

Json written_inventory()
{
    const std::vector<ListedClip> person = {{"walk", 0.25f, 1.25f, 6}, {"wave", 0, 1.5f, 5}, {"stand", 0.5f, 0.5f, 2}};
    const auto and_more = [&](const ListedClip &clip) {
        std::vector<ListedClip> all = person;
        all.push_back(clip);
        return all;
    };
    // Meshes on several nodes are counted on each of them.
    return {row("WrittenPerson.glb", 7, 488, 4, 16, person),
            row("WrittenRigid.glb", 7, 256, 0, 0, {{"roll", 0, 1, 5}, {"jolt", 0, 2, 3}}),
            row("WrittenMorph.gltf", 3, 168, 2, 2, {{"talk", 0, 1.2f, 3}, {"gasp", 0.5f, 1.5f, 3}}),
            row("WrittenSkins.glb", 4, 411, 5, 16, person),
            row("WrittenSparse.gltf", 3, 387, 4, 16, and_more({"nod", 0, 1, 2})),
            row("WrittenQuantised.glb", 4, 411, 4, 16, and_more({"shrug", 0, 0.9f, 2})),
            row("WrittenOdd.gltf", 5, 83, 2, 2, {{"turn over", 0, 1, 3}, {"hop", 1, 2, 3}}),
            row("WrittenClips.glb", 0, 0, 0, 0, {{"bow", 0, 0.8f, 16}, person[0], person[1], person[2]}),
            row("WrittenLines.gltf", 3, 12, 0, 0, {{"spin", 0, 2, 1}})};
}

WrittenFiles written_walk()
{
    std::string out =
        hierarchy() + "MOTION\nFrames: " + std::to_string(walk_frames) + "\nFrame Time: " + number(walk_frame_s) + "\n";
    for (int frame = 0; frame < walk_frames; ++frame) {
        const float moving = frame == 0 ? 0.0f : 1.0f, phase = 0.12f * static_cast<float>(frame);
        out += number(0) + " " + number(17) + " " + number(moving * 0.4f * static_cast<float>(frame));
        for (int joint = 0; joint < walk_joint_count; ++joint) {
            const float most = moving * (joint == 0 ? 3.0f : 12.0f);
            for (int axis = 0; axis < 3; ++axis)
                out += " " + number(most * std::sin(phase + static_cast<float>(joint + axis)));
        }
        out += "\n";
    }
    return {{"WrittenWalk.bvh", Bytes(out.begin(), out.end())}};
}

}  // namespace claque::testing
