// prepare: zones for characters that have none, proposed and painted.
#include <fstream>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"
#include "tests/support/gltf_maker.h"

namespace cli_test
{
namespace
{

using Prepare = Command;

// A proposed map that is not edited gives the same map again.
TEST_F(Prepare, AProposedMapGivenBackAsAPaintedOneMakesTheSameZones)
{
    const Outcome proposed = claque({"prepare", "citizen", "--propose", "4", "--zone", "1=light", "--zone", "2=dark",
                                     "--reduce", "light", "--zones-out", path("map.png"), "--out", path("a.clq")});
    ASSERT_EQ(proposed.code, 0) << proposed.err;
    EXPECT_NE(proposed.err.find("light, light and dark"), std::string::npos) << proposed.err;
    EXPECT_NE(proposed.err.find("zone      picture  name\n1         "), std::string::npos) << proposed.err;
    const Picture map = picture_of(path("map.png"));
    ASSERT_EQ(map.width, 512);
    const Outcome painted = claque({"prepare", "citizen", "--zones", path("map.png"), "--out", path("b.clq")});
    ASSERT_EQ(painted.code, 0) << painted.err;
    const Outcome split = claque({"split", path("b.clq")});
    ASSERT_EQ(split.code, 0) << split.err;
    EXPECT_NE(split.out.find("#"), std::string::npos) << "zones are named by the colours that they are painted in";
    const std::string before = claque({"split", path("a.clq")}).out;
    EXPECT_NE(before.find("light"), std::string::npos);
    const auto counts = [](const std::string &said) { return said.substr(0, said.find("zones ") + 13); };
    EXPECT_EQ(counts(split.out), counts(before)) << "triangles, clean, dirty and the number of zones";
}

// Levels are those of the character with these zones; the second time they come from the cache folder.
TEST_F(Prepare, MakesLevelsOfACharacterWithPaintedZonesAndKeepsThem)
{
    setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    const std::vector<std::string> command = {"prepare", "citizen", "--propose", "3", "--lod", "on", "--out"};
    std::string made[2];
    for (const char *name : {"a.clq", "b.clq"}) {
        std::vector<std::string> words = command;
        words.push_back(path(name));
        const Outcome outcome = claque(words);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err.find("making levels"), std::string::npos) << "progress in a pipe";
        made[name[0] - 'a'] = file_text(path(name));
    }
    EXPECT_EQ(made[0], made[1]);
    EXPECT_EQ(contents("cache/claque").size(), 1u);
    const Outcome plain = claque({"prepare", command[1], "--propose", "3", "--out", path("c.clq")});
    ASSERT_EQ(plain.code, 0) << plain.err;
    EXPECT_LT(file_text(path("c.clq")).size(), made[0].size()) << "the finest level alone";
    EXPECT_EQ(claque({"split", path("a.clq")}).out, claque({"split", path("c.clq")}).out) << "the finest level's zones";
}

TEST_F(Prepare, NamesWhatIsWrongWithItsOptions)
{
    const auto refused = [&](std::vector<std::string> more, const char *why) {
        std::vector<std::string> all = {"prepare", "citizen", "--out", path("c.clq")};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = claque(all);
        EXPECT_NE(outcome.code, 0) << why;
        EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    };
    refused({"--reduce", "all"}, "need --zones or --propose");
    refused({"--propose", "3", "--zone", "9=skin"}, "there is no 9; there are 1, 2, 3");
    refused({"--propose", "3", "--zone", "skin"}, "is not KEY=NAME");
    refused({"--propose", "3", "--reduce", "hat"}, "--reduce hat: no zone has that name");
    refused({"--zones", path("nothing.png")}, "nothing.png");
    refused({"--image", "9", "--propose", "3"}, "image 9 does not exist: 'citizen' has 2");
    EXPECT_TRUE(left().empty()) << "nothing is written after an error";
}

TEST_F(Prepare, OfACharacterWithoutPicturesSaysThatMaterialsAreItsZones)
{
    claque::testing::Maker maker;
    maker.triangle();
    const claque::testing::Bytes bytes = maker.glb();
    std::ofstream(path("plain.glb"), std::ios::binary)
        .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const Outcome outcome = claque({"prepare", path("plain.glb"), "--propose", "3", "--out", path("c.clq")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("--propose divide a picture, and 'plain' has none: its zones are its materials (1)"),
              std::string::npos)
        << outcome.err;
}

TEST_F(Prepare, KeepsATextureWithinTheSizeThatItIsGiven)
{
    ASSERT_EQ(claque({"prepare", "citizen", "--texture-size", "64", "--out", path("small.clq")}).code, 0);
    const Outcome split = claque({"split", path("small.clq"), "--scale", "1", "--picture", path("split.png")});
    ASSERT_EQ(split.code, 0) << split.err;
    EXPECT_EQ(picture_of(path("split.png")).width, 64);
}

}  // namespace
}  // namespace cli_test
