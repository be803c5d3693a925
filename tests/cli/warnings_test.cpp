// Whatever reads a character says its warnings: each once, on stderr alone, and none with --quiet.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/help.h"
#include "tests/cli/run.h"
#include "tests/support/gltf_maker.h"
#include "tests/support/written_motion.h"

namespace cli_test
{
namespace
{

using claque::testing::Maker;
using Json = nlohmann::json;

size_t times(const std::string &text, const std::string &part)
{
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

// A triangle whose picture is not there.
class Warnings : public Drawing
{
protected:
    Warnings()
    {
        Maker maker;
        maker.triangle();
        maker.add("images", {{"uri", "lost.png"}});
        maker.add("textures", {{"source", 0}});
        maker.add("materials", {{"name", "m"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        maker.primitive()["material"] = 0;
        maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
        const auto bytes = maker.glb();
        std::ofstream(file_, std::ios::binary).write(reinterpret_cast<const char *>(bytes.data()), long(bytes.size()));
        write("walk.csv", "id,frame,x,y\n1,0,0,0\n1,1,0.1,0\n1,2,0.2,0\n1,20,2,0\n");
        write("people.toml", "name = \"one\"\n[[characters]]\nname = \"one\"\ncharacter = \"" + file_ +
                                 "\"\n[tracks]\nfile = \"walk.csv\"\ncolumns = \"id,frame,x,y\"\nrate_hz = 10.0\n"
                                 "unit = \"m\"\n");
        write("steps.toml", "steps = ['wait 0.1']\n");
        write("guest.toml", "machine = \"guest\"\n[states.stands]\nenter = [ { look = [4.0, 1.0, 4.0] } ]\n");
        write("stage.toml", "name = \"one\"\n[stage]\nseconds = 1.0\n[[characters]]\nname = \"one\"\ncharacter = \"" +
                                file_ +
                                "\"\n[navigation]\nrectangle = [-3, -3, 3, 3]\n[[agents]]\nclass = \"one\"\n"
                                "machine = \"guest.toml\"\ncount = 2\narea = [-2, -2, 2, 2]\n");
    }
    void write(const std::string &name, const std::string &text) const { std::ofstream(path(name)) << text; }

    // What the command said besides, so that a failure can be understood.
    void expect_said(std::vector<std::string> words, size_t wanted) const
    {
        const Outcome done = claque(words);
        std::string all;
        for (const std::string &word : words) all += word + " ";
        EXPECT_EQ(times(done.err, "warning: " + file_ + ": the picture images[0]"), wanted) << all << done.err;
        EXPECT_EQ(times(done.out, "lost.png"), 0u) << all << done.out;
    }
    const std::string file_ = path("person.glb");
    // A triangle cannot walk, and has one level: some of these fail, after their warning.
    const std::vector<std::vector<std::string>> commands_ = {
        {"render", file_, "--count", "2", "--size", "64x48", "--out", path("a.png")},
        {"render", file_, "--count", "2", "--size", "64x48", "--frames", "0:3", "--processes", "3", "--out",
         path("f-%03d.png")},
        {"render", file_, "--count", "2", "--size", "64x48", "--processes", "2", "--divide", "tiles", "--out",
         path("t.png")},
        {"render", "--scenario", path("people.toml"), "--size", "64x48", "--out", path("s.png")},
        {"sheet", "--scenario", path("people.toml"), "--path", CLAQUE_SOURCE_DIR "/samples/scenes/odeon/path.toml",
         "--size", "64x48", "--out", path("sheet.png")},
        {"inspect", file_},
        {"dump", file_, "--out", path("d.npy")},
        {"split", file_},
        {"variety", file_, "--count", "2", "--size", "320x200", "--out", path("v.png")},
        {"colours", "save", file_, "--out", path("c.toml")},
        {"lods", file_},
        {"blend", file_, "--out", path("b.png")},
        {"prepare", file_, "--out", path("p.clq")},
        {"bench", file_, "--count", "2", "--frames", "2", "--size", "64x48"},
        {"play", path("walk.csv"), "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m", "--characters", file_,
         "--time", "1", "--size", "64x48", "--out", path("w.png")},
        {"tracks", path("walk.csv"), "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m", "--characters", file_},
        {"stage", path("stage.toml"), "--json", "-"},
        {"labels", path("people.toml"), "--size", "64x48", "--frames", "0:1", "--out", path("labels")},
        {"parity", "export", file_, "--size", "64x48", "--out", path("parity")},
    };
};

TEST_F(Warnings, OfACharacterAreSaidOnceByEveryCommandThatReadsIt)
{
    for (const std::vector<std::string> &words : commands_) expect_said(words, 1);
#ifdef CLAQUE_VIEWED
    expect_said({"view", file_, "--script", path("steps.toml"), "--size", "640x480"}, 1);
#endif
}

TEST_F(Warnings, AreSilencedByQuiet)
{
    for (std::vector<std::string> words : {commands_[0], commands_[1], commands_[5]}) {
        words.emplace_back("--quiet");
        expect_said(words, 0);
    }
}

TEST_F(Warnings, AreInTheReportsToo)
{
    const Outcome inspected = claque({"inspect", file_, "--json", "--quiet"});
    EXPECT_EQ(inspected.err, "");
    EXPECT_EQ(Json::parse(inspected.out)["loaded"]["warnings"].size(), 1u);
}

TEST_F(Warnings, OfClipsAreSaidOnceThoughTheyAreReadTwice)
{
    write("bow.bvh",
          "HIERARCHY\nROOT pelvis\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT wing\n{\n"
          "OFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\n"
          "Frames: 2\nFrame Time: 0.1\n0 0 0 0 0 0\n5 5 5 5 5 5\n");
    const Outcome done = claque({"render", "citizen", "--clips", path("bow.bvh"), "--count", "2", "--size", "64x48",
                                 "--frames", "0:3", "--processes", "2", "--out", path("f-%03d.png")});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(times(done.err, "1 joint of the clips not in the character: wing"), 1u) << done.err;
}

TEST_F(Warnings, SayThatPreparedFilesKeepTheirColours)
{
    const std::string keeps =
        "person.clq keeps its colours, as it is prepared already: claque prepare takes --colours ";
    ASSERT_EQ(claque({"prepare", file_, "--out", path("person.clq")}).code, 0);
    const auto rendered = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", path("person.clq"), "--size", "64x48", "--out", path("a.png")});
        return claque(more).err;
    };
    for (const std::string colours : {"wild", "own"})
        EXPECT_EQ(times(rendered({"--colours", colours}), keeps + colours), 1u);
    EXPECT_EQ(times(rendered({}), "keeps its colours"), 0u);
}

TEST_F(Warnings, OfACrowdThatLooksAlikeNameClipsAndZones)
{
    const std::string alike =
        "'person' has no clip and one zone, so its crowd looks alike: --clips FILE adds clips, --clips citizen those "
        "of "
        "the built-in citizen, and --colours wild, or a zone map of its picture (claque prepare --propose N)";
    for (const auto &words : {commands_[0], commands_[1]}) EXPECT_EQ(times(claque(words).err, alike), 1u);
    const auto rendered = [&](const std::string &who, const char *count) {
        return claque({"render", who, "--count", count, "--size", "64x48", "--out", path("a.png")}).err;
    };
    EXPECT_EQ(times(rendered(file_, "1"), "alike"), 0u);
    EXPECT_EQ(times(rendered("citizen", "2"), "alike"), 0u);
    write("still.toml", "steps = ['wait 0.1']\n");
    const Outcome in_line = claque({"view", "--characters", file_, "--count", "2", "--script", path("still.toml"),
                                    "--size", "640x480", "--shots", path("")});
    EXPECT_EQ(times(in_line.err, alike), 1u) << in_line.err;
    // A clip of one key is a pose.
    for (const float end_s : {0.0f, 1.0f}) {
        Maker maker;
        maker.triangle();
        claque::testing::ClipMaker clip(maker, "pose");
        const std::vector<float> keys = end_s > 0 ? std::vector<float>{0, end_s} : std::vector<float>{0};
        clip.add(0, "translation", "LINEAR", keys, std::vector<float>(3 * keys.size()));
        clip.finish();
        const auto bytes = maker.glb();
        write("posed.glb", std::string(bytes.begin(), bytes.end()));
        EXPECT_EQ(times(rendered(path("posed.glb"), "2"), "'posed' has no clip longer than 0 s"), end_s > 0 ? 0u : 1u);
    }
}

}  // namespace
}  // namespace cli_test
