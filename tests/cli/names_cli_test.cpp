// Names: where they are listed, and what is said of one that is not there.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/support/gltf_maker.h"

namespace cli_test
{
namespace
{

using claque::testing::Maker;
using Json = nlohmann::json;

struct NamesCommand : Drawing {
    void write(const std::string &name, const std::string &text) const { std::ofstream(path(name)) << text; }
    void expect_said(const std::vector<std::string> &words, int code, const std::string &sentence) const
    {
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, code) << done.err;
        EXPECT_NE(done.err.find(sentence), std::string::npos) << done.err;
    }
};

TEST_F(NamesCommand, OfNodesMaterialsAndLegsAreListed)
{
    const Outcome done = claque({"inspect", "citizen", "--nodes"});
    ASSERT_EQ(done.code, 0) << done.err;
    for (const char *line : {"\nnodes\n", "pelvis  joint\n", "      thigh_l  joint\n", "\nmaterials\n", "\nclips\n",
                             "left_leg  thigh \"thigh_l\"  shin \"shin_l\"  foot \"foot_l\"", "walk  clip \"walk\""})
        EXPECT_NE(done.out.find(line), std::string::npos) << line << done.out;
    const Json json = Json::parse(claque({"inspect", "citizen", "--nodes", "--json"}).out);
    EXPECT_EQ(json["node_list"].size(), json["loaded"]["nodes"].get<size_t>());
    EXPECT_TRUE(json["node_list"][0]["parent"].is_null());
    EXPECT_GT(json["locomotion"]["walk"]["speed"].get<double>(), 0.5);
    EXPECT_EQ(json["locomotion"]["run"]["clip"], "jog");
    EXPECT_FALSE(Json::parse(claque({"inspect", "citizen", "--json"}).out).contains("node_list"));
}

TEST_F(NamesCommand, AreListedOfAFileOfClipsAndWhyAnOwlDoesNotWalk)
{
    write(
        "a.bvh",
        "HIERARCHY\nROOT hips\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT knee\n{\nOFFSET 0 1 0\n"
        "CHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 2\n"
        "Frame Time: 0.5\n0 0 0 0 0 0\n5 5 5 5 5 5\n");
    const Outcome clips = claque({"inspect", path("a.bvh"), "--nodes"});
    EXPECT_NE(clips.out.find("nodes\n  hips\n    knee\n      knee end\n"), std::string::npos) << clips.out;
    EXPECT_NE(clips.out.find("a:  start_s 0.0  duration_s 0.5"), std::string::npos) << clips.out;
    const Outcome owl = claque({"inspect", "owl", "--nodes"});
    EXPECT_NE(owl.out.find("no locomotion: the character owl has no clip named walk"), std::string::npos) << owl.out;
}

TEST_F(NamesCommand, OfOneNodeHaveNoClipThatItCouldWalkBy)
{
    Maker maker;
    maker.triangle();
    const auto bytes = maker.glb();
    std::ofstream(path("wolf.glb"), std::ios::binary)
        .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const std::string said = claque({"inspect", path("wolf.glb"), "--nodes"}).out;
    EXPECT_NE(said.find("has a skeleton of 1 node, and walkers have a hip, a knee and an ankle on each side"),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("--walk"), std::string::npos) << said;
}

TEST_F(NamesCommand, ThatAreNotThereBringTheNearOnes)
{
    write("walk.bvh", "");
    expect_said({"dump", "citizen", "--clip", "wlak", "--out", path("a.npy")}, 1,
                "citizen has no clip 'wlak' among its 23: 'walk' and 'walk_slow' are near");
    expect_said({"render", "citizen", "--clip", "aplaud", "--out", path("a.png")}, 1, "'applaud'");
    expect_said({"dump", "citizen", "--clip", "zzzzzz", "--out", path("a.npy")}, 1, "; there are: stand, walk, ");
    expect_said({"inspect", "citzen"}, 1, "there is no built-in character 'citzen': 'citizen' is near");
    expect_said({"inspect", path("wlak.bvh")}, 1, "No such file or directory: 'walk.bvh' is near");
    expect_said({"blend", "citizen", "--over", "Walk", "--out", path("b.png")}, 1, "'walk' and 'walk_slow' are near");
    expect_said({"rendr", "citizen"}, 2, "'rendr' is no subcommand of claque: 'render' is near");
    expect_said({"render", "citizen", "--tiem", "1", "--out", path("a.png")}, 2,
                "'--tiem' is no option of render: '--time' and '--to' are near");
    write("map.toml", "unit_n = 1.0\n");
    expect_said({"inspect", "citizen", "--clips", path("walk.bvh"), "--map", path("amp.toml")}, 1,
                "No such file or directory: 'map.toml' is near");
    expect_said({"inspect", "citizen", "--clips", path("walk.bvh"), "--map", path("map.toml")}, 1,
                "has an unknown key 'unit_n': 'unit_m' is near");
}

TEST_F(NamesCommand, OfAMapThatNeitherSkeletonHasBringTheNearOnes)
{
    write(
        "a.bvh",
        "HIERARCHY\nROOT Hips\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT knee\n{\nOFFSET 0 1 0\n"
        "CHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 2\n"
        "Frame Time: 0.5\n0 0 0 0 0 0\n5 5 5 5 5 5\n");
    write("map.toml", "[joints]\nHip = \"pelvis\"\nHips = \"pelvis\"\nknee = \"thigh_x\"\n");
    const Outcome done = claque({"inspect", "citizen", "--clips", path("a.bvh"), "--map", path("map.toml")});
    EXPECT_NE(done.err.find("not in the clips' skeleton: Hip ('Hips' is near)"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("not in the character: thigh_x ('thigh_l' and 'thigh_r' are near)"), std::string::npos)
        << done.err;
}

TEST_F(NamesCommand, OfAClipChooseIt)
{
    const auto hash = [&](std::vector<std::string> more) {
        std::vector<std::string> words = {"citizen"};
        words.insert(words.end(), more.begin(), more.end());
        return picture_hash(words);
    };
    const std::string sits = hash({"--clip", "sit", "--time", "0"});
    EXPECT_EQ(sits, hash({"--clip", "4", "--time", "0"})) << "the fifth of its clips";
    EXPECT_NE(sits, hash({"--clip", "walk", "--time", "0"}));
    EXPECT_NE(hash({"--clip", "walk", "--time", "0.25"}), hash({"--clip", "walk", "--time", "0"}));
}

TEST_F(NamesCommand, OfTexturesThatAreNotThereBringTheNearOnes)
{
    Maker maker;
    maker.triangle();
    maker.json["materials"] = {{{"name", "plain"}}, {{"name", "grey"}}};
    maker.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "night"}}, {{"name", "day"}}};
    maker.primitive()["material"] = 0;
    maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0, 1}}}};
    const auto bytes = maker.glb();
    std::ofstream(path("a.glb"), std::ios::binary)
        .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    write("people.toml",
          "name = \"p\"\n[[characters]]\nname = \"p\"\ncharacter = \"a.glb\"\n[[people]]\nclass = \"p\"\n"
          "at = [0.0, 0.0, 0.0]\ntextures = \"nigth\"\n");
    expect_said({"render", "--scenario", path("people.toml"), "--out", path("a.png")}, 1,
                "there are no textures 'nigth': 'night' is near");
}

TEST_F(NamesCommand, OfMorphTargetsAreListedAsFarAsTheFileHasThem)
{
    const auto listed = [&](const Json &extras) {
        Maker maker;
        maker.triangle();
        maker.primitive()["targets"] = Json::array({{{"POSITION", 0}}, {{"POSITION", 0}}, {{"POSITION", 0}}});
        maker.json["nodes"][0]["name"] = "face";
        maker.json["meshes"][0]["extras"] = extras;
        const auto bytes = maker.glb();
        std::ofstream(path("face.glb"), std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), long(bytes.size()));
        const Outcome done = claque({"inspect", path("face.glb"), "--nodes"});
        EXPECT_EQ(done.code, 0) << done.err;
        const size_t at = done.out.find("morph targets\n");
        return at == std::string::npos ? done.out : done.out.substr(at, done.out.find("no locomotion", at) - at);
    };
    EXPECT_EQ(listed({{"targetNames", {"smile", "blink", "jaw"}}}),
              "morph targets\n  face 0  smile\n  face 1  blink\n  face 2  jaw\n");
    for (const Json &odd :
         {Json("text"), Json({{"targetNames", "smile"}}), Json({{"targetNames", {1, nullptr}}}), Json()})
        EXPECT_EQ(listed(odd), "morph targets\n  face 0  \n  face 1  \n  face 2  \n") << odd;
    EXPECT_EQ(listed({{"targetNames", {"smile", 2, "jaw", "more"}}}),
              "morph targets\n  face 0  smile\n  face 1  \n  face 2  jaw\n");
}

TEST_F(NamesCommand, OfFilesDoNotDecideTheirFormat)
{
    Maker maker;
    maker.triangle();
    const auto bytes = maker.glb();
    for (const char *name : {"x.mesh.xml.glb", "x.mesh.xml.folder.glb", "x.fbx", "x.vrm", "x.csv", "x"}) {
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), long(bytes.size()));
        const Outcome done = claque({"inspect", path(name)});
        EXPECT_EQ(done.code, 0) << name << done.err;
        expect_said({"labels", path(name), "--out", path("l")}, 2, path(name) + " is a character; labels are of");
        const Outcome measured = claque({"bench", path(name), "--count", "2", "--frames", "1", "--size", "96x72"});
        EXPECT_EQ(measured.code, 0) << name << measured.err;
    }
    expect_said({"inspect", path("absent.vrm")}, 1, "absent.vrm");
    write("b.iqm", "INTERQUAKEMODEL");
    write("b.egg", "<CoordinateSystem> { Z-Up }");
    write("b.bin", "IDP2");
    for (const char *name : {"b.iqm", "b.egg", "b.bin"}) expect_said({"inspect", path(name)}, 1, "claque convert ");
}

}  // namespace
}  // namespace cli_test
