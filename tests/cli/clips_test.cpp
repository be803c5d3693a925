// Clips for characters from other files: bound by joint name or by a joint map, and refusals.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/dumped.h"
#include "tests/support/collected_file.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;

// A pelvis that goes ahead and a thigh that swings: 11 frames at 20 Hz, half a second; a T-pose with lengths in inches.
constexpr const char *bow = R"(HIERARCHY
ROOT Hips
{
    OFFSET 0 37 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
    JOINT LeftUpLeg
    {
        OFFSET 3.5 -1 0
        CHANNELS 3 Zrotation Yrotation Xrotation
        End Site
        {
            OFFSET 0 -17 0
        }
    }
}
MOTION
Frames: 11
Frame Time: 0.05
)";

constexpr const char *bow_map = R"(unit_m = 0.0254
travel = "in-place"
follow_share = 0.85
[follow]
skirt_front_l = "thigh_l"
[joints]
Hips = "pelvis"
LeftUpLeg = "thigh_l"
)";

class Clips : public Command
{
protected:
    Clips()
    {
        std::string text = bow;
        for (int k = 0; k < 11; ++k)
            text += "0 37 " + std::to_string(2 * k) + " 0 0 0 0 0 " + std::to_string(30 * std::sin(0.6 * k)) + "\n";
        write("bow.bvh", text);
        write("bow.toml", bow_map);
    }
    void write(const std::string &name, const std::string &text) const { std::ofstream(path(name)) << text; }

    Outcome inspect(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "inspect");
        return claque(arguments);
    }
    Json report(std::vector<std::string> arguments) const
    {
        arguments.push_back("--json");
        const Outcome done = inspect(arguments);
        EXPECT_EQ(done.code, 0) << done.err;
        return Json::parse(done.out, nullptr, false);
    }
    // Positions of all vertices in the clip `bow` at a time.
    std::vector<float> dump(const std::string &time, std::vector<std::string> more) const
    {
        const std::vector<std::string> all = {"citizen", "--clips", path("bow.bvh"), "--map", path("bow.toml"),
                                              "--clip",  "bow",     "--time",        time};
        more.insert(more.begin(), all.begin(), all.end());
        return dumped(more, path("bow.npy")).first;
    }
    // Standard error, which must be one sentence.
    std::string failure(const std::vector<std::string> &arguments) const
    {
        const Outcome done = inspect(arguments);
        EXPECT_EQ(done.code, 1) << done.out << done.err;
        EXPECT_EQ(done.err.substr(0, 8), "claque: ") << done.err;
        EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
        return done.err;
    }
    int usage(const std::vector<std::string> &arguments) const { return inspect(arguments).code; }
};

Json last_clip(const Json &report)
{
    return report["split"]["clips"].empty() ? Json() : report["split"]["clips"].back();
}

TEST_F(Clips, OfAMotionFileComeBehindTheCharactersOwn)
{
    const size_t own = report({"citizen"})["split"]["clips"].size();
    const Json with = report({"citizen", "--clips", path("bow.bvh"), "--map", path("bow.toml")});
    ASSERT_EQ(with["split"]["clips"].size(), own + 1);
    EXPECT_EQ(last_clip(with)["name"], "bow");
    EXPECT_NEAR(last_clip(with)["duration_s"].get<double>(), 0.5, 1e-5);
    EXPECT_GT(last_clip(with)["bytes"].get<int>(), 0);
}

TEST_F(Clips, AreCutClosedAndSampledAsTheOptionsSay)
{
    const std::vector<std::string> all = {"citizen", "--clips", path("bow.bvh"), "--map", path("bow.toml")};
    const auto with = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = all;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return report(arguments);
    };
    const Json cut = with({"--from", "0.1", "--to", "0.35"});
    EXPECT_NEAR(last_clip(cut)["duration_s"].get<double>(), 0.25, 1e-5);
    EXPECT_NE(last_clip(with({"--rate", "120"}))["error_rad"], last_clip(with({"--rate", "5"}))["error_rad"]);
    const auto farthest = [](const std::vector<float> &a, const std::vector<float> &b, size_t axis) {
        float most = 0;
        for (size_t i = axis; i < std::min(a.size(), b.size()); i += 3) most = std::max(most, std::fabs(a[i] - b[i]));
        return most;
    };
    const std::vector<float> first = dump("0", {}), last = dump("0.5", {});
    ASSERT_GT(first.size(), 1000u);
    EXPECT_GT(farthest(first, last, 2), 0.01f) << "the thigh has swung";
    EXPECT_LT(farthest(first, dump("0.5", {"--close", "0.2"}), 2), 1e-5f) << "closed";
    // 20 of 37 units of hip height, for a man whose hips are about 0.95 m high.
    const std::vector<float> keeps = dump("0.5", {"--root-travel", "keep"});
    EXPECT_NEAR(farthest(keeps, last, 2), 0.95 * 20 / 37, 0.1);
}

TEST_F(Clips, OfAnotherCharacterAreBoundByJointName)
{
    const Json with = report({"citizen", "--clips", "plebeian"});
    const size_t own = report({"citizen"})["split"]["clips"].size();
    ASSERT_EQ(with["split"]["clips"].size(), 2 * own);
    EXPECT_EQ(last_clip(with)["name"], "stand_shift.2") << "a name that is taken gets a number";
    EXPECT_FALSE(with["loaded"]["warnings"].empty());
}

TEST_F(Clips, ThatAreInvalidAreRefusedInOneSentence)
{
    const std::string bvh = path("bow.bvh"), map = path("bow.toml");
    EXPECT_NE(failure({"citizen", "--clips", path("none.bvh")}).find("none.bvh"), std::string::npos);
    write("half.bvh", std::string(bow).substr(0, 200));
    EXPECT_NE(failure({"citizen", "--clips", path("half.bvh"), "--map", map}).find("half.bvh"), std::string::npos);
    write("short.bvh", std::string(bow) + "0 37 0 0 0 0 0 0 0\n");
    EXPECT_NE(failure({"citizen", "--clips", path("short.bvh"), "--map", map}).find("short.bvh"), std::string::npos);
    write("words.bvh", std::string(bow) + "a b c\n");
    EXPECT_NE(failure({"citizen", "--clips", path("words.bvh"), "--map", map}).find("words.bvh"), std::string::npos);
    EXPECT_NE(failure({"citizen", "--clips", bvh}).find("joint"), std::string::npos) << "names that do not answer";
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("none.toml")}).find("none.toml"), std::string::npos);
    write("bad.toml", "[joints]\nHips = \"tail\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("by the map"), std::string::npos);
    write("bad.toml", "align = [\"hand_l\"]\n[joints]\nHips = \"pelvis\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("hand_l"), std::string::npos);
    write("bad.toml", "travel = \"fly\"\n[joints]\nHips = \"pelvis\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("fly"), std::string::npos);
    write("bad.toml", "rest = \"sofa\"\n[joints]\nHips = \"pelvis\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("frame:0"), std::string::npos);
    write("bad.toml", "rest = \"frame:11\"\n[joints]\nHips = \"pelvis\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("0 to 10"), std::string::npos);
    write("bad.toml", "[follow]\nskirt_front_l = \"shin_l\"\n[joints]\nHips = \"pelvis\"\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("shin_l"), std::string::npos);
    write("bad.toml", "[joints\n");
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", path("bad.toml")}).find("bad.toml:1:"), std::string::npos);
    EXPECT_NE(failure({"citizen", "--clips", bvh, "--map", map, "--from", "7"}).find("7"), std::string::npos);
    EXPECT_NE(failure({"owl", "--vary", "150"}).find("owl"), std::string::npos);
}

TEST_F(Clips, OptionsThatDoNotGoTogetherAreCode2)
{
    const std::string bvh = path("bow.bvh"), map = path("bow.toml");
    EXPECT_EQ(usage({"citizen", "--map", map}), 2);
    EXPECT_EQ(usage({"citizen", "--from", "1"}), 2);
    EXPECT_EQ(usage({"citizen", "--clips", bvh, "--root-travel", "there"}), 2);
    EXPECT_EQ(usage({"citizen", "--clips", bvh, "--rate", "0.5"}), 2);
    EXPECT_EQ(usage({"citizen", "--clips", bvh, "--close", "-1"}), 2);
    EXPECT_EQ(usage({"citizen", "--unit", "0"}), 2);
    EXPECT_EQ(usage({"citizen", "--vary", "22"}), 2) << "it has more of its own";
    EXPECT_EQ(usage({"citizen", "--vary", "2001"}), 2);
    EXPECT_EQ(claque({"render", "--clips", bvh, "--out", path("x.png")}).code, 2) << "nobody to give them to";
}

TEST_F(Clips, AMotionFileAloneIsASkeletonWithoutAnythingToSplit)
{
    const Json alone = report({path("bow.bvh"), "--unit", "0.0254"});
    EXPECT_EQ(alone["loaded"]["nodes"].get<int>(), 3) << "two joints and an end";
    EXPECT_EQ(alone["loaded"]["clips"].size(), 1u);
    EXPECT_NE(alone.at("not_split").get<std::string>().find("clips alone: --clips "), std::string::npos);
}

// The least that the help names is the number of a person's own clips.
TEST_F(Clips, OfAPersonCanBeVariedFromAsManyAsItHas)
{
    const std::string help = claque({"prepare", "--help"}).out;
    const size_t at = help.find("--vary");
    ASSERT_NE(at, std::string::npos) << help;
    const size_t first = help.find('[', at) + 1;
    const std::string least = help.substr(first, help.find(' ', first) - first);
    for (const char *person : {"citizen", "patrician", "decurion", "plebeian"}) {
        EXPECT_EQ(std::to_string(report({person})["split"]["clips"].size()), least) << person;
        EXPECT_EQ(report({person, "--vary", least})["split"]["clips"].size(), std::stoul(least)) << person;
    }
}

TEST_F(Clips, AFileWithoutAMeshHasNoPositionsToDump)
{
    const Outcome outcome = claque({"dump", path("bow.bvh"), "--out", path("p.npy")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("bow.bvh has no mesh, so there are no positions to write: --clips"), std::string::npos)
        << outcome.err;
}

TEST_F(Clips, AHundredAndFiftyTakeASmallPartOfTheMeshesThatTheyMove)
{
    const Json varied = report({"citizen", "--vary", "150"});
    ASSERT_EQ(varied["split"]["clips"].size(), 150u);
    const Json &motion = varied["split"]["motion"];
    double bytes = 0, rows = 0, frames = 0;
    for (const Json &clip : varied["split"]["clips"]) {
        bytes += clip["bytes"].get<double>();
        rows += std::round(clip["duration_s"].get<double>() * clip["rate_hz"].get<double>()) + 1;
        frames += std::round(clip["duration_s"].get<double>() * 25) + 1;
    }
    const double vertex_bytes = 24 * varied["split"]["vertices"].get<double>();
    EXPECT_EQ(motion["bytes"].get<double>(), bytes);
    EXPECT_EQ(motion["as_meshes_bytes"].get<double>(), rows * vertex_bytes);
    EXPECT_EQ(motion["as_meshes_25_hz_bytes"].get<double>(), frames * vertex_bytes);
    EXPECT_GT(motion["times_less"].get<double>(), 50);
    EXPECT_GT(motion["times_less_25_hz"].get<double>(), 50);
}

// Motion capture that may lie beside this project, and a file of the same form that tests write.
class Mocap : public Clips, public testing::WithParamInterface<const char *>
{
protected:
    std::string file() const { return written::path_of(GetParam(), CLAQUE_ASSETS_DIR "/mocap"); }
    std::string map() const { return std::string(CLAQUE_SOURCE_DIR) + "/samples/maps/cmu-people.toml"; }
    void SetUp() override { CLAQUE_NEEDS_FILE(file()); }
};

TEST_P(Mocap, MovesABuiltInPerson)
{
    const Json with = report({"citizen", "--clips", file(), "--map", map(), "--to", "2", "--close", "0.3"});
    ASSERT_EQ(with["split"]["clips"].size(), report({"citizen"})["split"]["clips"].size() + 1);
    EXPECT_NEAR(last_clip(with)["duration_s"].get<double>(), 1.98, 1e-3) << "the map leaves the T-pose out";
    EXPECT_GT(last_clip(with)["channels"].get<int>(), 20);
    EXPECT_LT(last_clip(with)["error_mm"].get<double>(), 1);
    // In place, so that the character needs no larger sphere for it.
    EXPECT_LT(with["split"]["sklsroot_radius"].get<double>(), 1.4);
}

INSTANTIATE_TEST_SUITE_P(Files, Mocap,
                         testing::Values("01_01.bvh", "02_01.bvh", "cmu_12_01_walk.bvh", "WrittenWalk.bvh"),
                         [](const auto &test) {
                             const std::string name = test.param;
                             return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace cli_test
