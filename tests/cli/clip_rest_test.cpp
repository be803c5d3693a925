// Clips whose file rests in no pose: how the character stands, and how the command says it.
#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/cli/dumped.h"
#include "tests/support/collected_file.h"

namespace cli_test
{
namespace
{

using ClipRest = Command;

// As LAFAN1 writes people: the x axis of each joint points to the next, and angles of zero are no pose. This one stands
// with its arms 75 degrees down.
std::string standing_along_x()
{
    struct Joint {
        const char *name;
        int depth, x, y, turn_deg;  // about z
    };
    const std::vector<Joint> joints = {
        {"Hips", 0, 0, 0, 90},         {"Spine", 1, 20, 0, 0},        {"Head", 2, 40, 0, 0},
        {"LeftArm", 2, 25, -18, -165}, {"LeftForeArm", 3, 28, 0, 0},  {"LeftHand", 4, 25, 0, 0},
        {"RightArm", 2, 25, 18, 165},  {"RightForeArm", 3, 28, 0, 0}, {"RightHand", 4, 25, 0, 0},
        {"LeftUpLeg", 1, 0, -10, 180}, {"LeftLeg", 2, 42, 0, 0},      {"LeftFoot", 3, 42, 0, 0},
        {"RightUpLeg", 1, 0, 10, 180}, {"RightLeg", 2, 42, 0, 0},     {"RightFoot", 3, 42, 0, 0}};
    std::string text = "HIERARCHY\n", frame = "0 92 0";
    for (size_t i = 0; i < joints.size(); ++i) {
        const Joint &j = joints[i];
        text += std::string(i == 0 ? "ROOT " : "JOINT ") + j.name + "\n{\nOFFSET " + std::to_string(j.x) + " " +
                std::to_string(j.y) + " 0\n" + (i == 0 ? "CHANNELS 4 Xposition Yposition Zposition" : "CHANNELS 1") +
                " Zrotation\n";
        frame += " " + std::to_string(j.turn_deg);
        const int next = i + 1 < joints.size() ? joints[i + 1].depth : 0;
        for (int depth = j.depth; depth >= next; --depth) text += "}\n";
    }
    return text + "MOTION\nFrames: 3\nFrame Time: 0.1\n" + frame + "\n" + frame + "\n" + frame + "\n";
}

// Lowest and highest coordinate.
std::pair<float, float> box(const std::vector<float> &xyz, size_t axis)
{
    float low = 1e9f, high = -1e9f;
    for (size_t i = axis; i < xyz.size(); i += 3) low = std::min(low, xyz[i]), high = std::max(high, xyz[i]);
    return {low, high};
}

}  // namespace

TEST_F(ClipRest, OfASkeletonAlongOneAxisStandAndSayHow)
{
    std::ofstream(path("along.bvh")) << standing_along_x();
    std::ofstream(path("file.toml")) << "rest = \"file\"\n";
    std::ofstream(path("frame.toml")) << "rest = \"frame:2\"\n";
    const std::vector<std::string> along = {"citizen", "--clips", path("along.bvh"), "--clip", "along", "--time", "0"};
    const auto with_map = [&](const char *map) {
        std::vector<std::string> all = along;
        all.insert(all.end(), {"--map", path(map)});
        return dumped(all, path("out.npy"));
    };
    const auto [stands, said] = dumped(along, path("out.npy"));
    EXPECT_NEAR(box(stands, 1).second - box(stands, 1).first, 1.75, 0.05);
    EXPECT_LT(box(stands, 0).second, 0.55f) << "the arms hang";
    EXPECT_GT(box(stands, 0).second, 0.25f) << "outside of the body";
    EXPECT_NE(said.find("lie along x. Frame 0 of 'along' takes its place; rest = \"frame:N\""), std::string::npos)
        << said;
    EXPECT_EQ(said.find("unlike"), std::string::npos) << said;
    const auto [lies, warned] = with_map("file.toml");
    EXPECT_LT(box(lies, 1).second - box(lies, 1).first, 1.2f);
    EXPECT_NE(warned.find("rest = \"bones\" in the map"), std::string::npos) << warned;
    EXPECT_NEAR(box(with_map("frame.toml").first, 1).second, box(stands, 1).second, 0.05);
}

// The case says: hips at 0.95 m, head at 1.50 m, toes at 0.04 m, and legs that swing by 20 degrees once a second.
TEST_F(ClipRest, OfTheCaseWithItsMapIsThatOfAPersonWhoseLegsSwing)
{
    const std::string file = CLAQUE_ASSETS_DIR "/../cases/characters/bones_along_x.bvh";
    CLAQUE_NEEDS_FILE(file);
    const auto posed = [&](const char *time) {
        return dumped({"citizen", "--clips", file, "--map", file.substr(0, file.size() - 3) + "toml", "--clip",
                       "bones_along_x", "--time", time},
                      path("out.npy"));
    };
    const auto [together, said] = posed("0.5");
    EXPECT_EQ(said.find("unlike"), std::string::npos) << said;
    EXPECT_NEAR(box(together, 1).first, 0, 0.06);
    EXPECT_NEAR(box(together, 1).second, 1.75, 0.1);
    EXPECT_NEAR(box(together, 0).second, 0.25, 0.05) << "the arms hang";
    const auto depth = [&](const std::vector<float> &xyz) { return box(xyz, 2).second - box(xyz, 2).first; };
    EXPECT_LT(depth(together), 0.45f);
    // Legs of 0.85 m at 20 degrees to either side, and a foot.
    EXPECT_NEAR(depth(posed("0.25").first), 2 * 0.85f * std::sin(20 * 0.0174533f) + 0.25f, 0.12);
}

}  // namespace cli_test
