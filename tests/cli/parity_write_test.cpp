// parity export and capture: folders that another renderer reads, with the same bytes from the same command.
#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;

class ParityWrite : public Drawing
{
protected:
    void write(const std::string &what, const std::string &folder, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments = {"parity", what,    "citizen", "--count",   "2",
                                              "--size", "80x60", "--out",   path(folder)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
    static std::vector<std::string> files(const std::string &folder)
    {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }
};

TEST_F(ParityWrite, ASceneHasWhatThePagePromises)
{
    write("export", "scene");
    EXPECT_EQ(files(path("scene")),
              (std::vector<std::string>{"actors.npy", "atlas.npy", "capture.json", "model_view.npy",
                                        "morph_weights.npy", "palettes.npy", "scene.glb", "sizes.npy"}));
    const Json json = Json::parse(file_text(path("scene") + "/capture.json"));
    EXPECT_EQ(json["format"], "claque-parity");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["kind"], "scene");
    EXPECT_EQ(json["width"], 80);
    EXPECT_EQ(json["actors"], 2);
    EXPECT_EQ(json["templates"][0]["name"], "citizen");
    EXPECT_EQ(json["lighting"]["lights"].size(), 2u);
    const std::string atlas = file_text(path("scene") + "/atlas.npy");
    EXPECT_NE(atlas.find("'shape': (1, 1024, 256, 3)"), std::string::npos);
    EXPECT_EQ(file_text(path("scene") + "/scene.glb").substr(0, 4), "glTF");
}

TEST_F(ParityWrite, AResultReplacesAnOlderScene)
{
    write("export", "folder");
    write("capture", "folder");
    EXPECT_EQ(files(path("folder")),
              (std::vector<std::string>{"actor.npy", "actors.npy", "capture.json", "colour.npy", "depth.npy",
                                        "model_view.npy", "normals.npy", "positions.npy", "sizes.npy", "zone.npy"}));
    const Json json = Json::parse(file_text(path("folder") + "/capture.json"));
    EXPECT_EQ(json["kind"], "result");
    EXPECT_EQ(json["draws"]["individuals"], 2);
    EXPECT_EQ(file_text(path("folder") + "/depth.npy").size(), 128u + 4 * 80 * 60);
}

TEST_F(ParityWrite, TheSameCommandWritesTheSameBytes)
{
    for (const char *what : {"export", "capture"}) {
        write(what, "a");
        write(what, "b", {"--threads", "3"});
        ASSERT_EQ(files(path("a")), files(path("b")));
        for (const std::string &name : files(path("a")))
            EXPECT_EQ(file_text(path("a") + "/" + name), file_text(path("b") + "/" + name)) << what << " " << name;
    }
    write("capture", "later", {"--time", "2.5"});
    EXPECT_NE(file_text(path("a") + "/positions.npy"), file_text(path("later") + "/positions.npy"));
}

TEST_F(ParityWrite, WhatIsNoCaptureStaysInTheFolder)
{
    namespace fs = std::filesystem;
    write("export", "folder");
    std::ofstream(path("folder") + "/notes.txt") << "mine";
    fs::create_directory(path("folder") + "/more");
    std::ofstream(path("folder") + "/more/notes.txt") << "also mine";
    fs::permissions(path("folder"), fs::perms::owner_all);
    fs::create_directory_symlink(path("folder"), path("link"));
    write("capture", "link");
    EXPECT_EQ(left(), (std::vector<std::string>{"folder", "link"}));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(files(path("folder")).size(), 12u);
    EXPECT_EQ(Json::parse(file_text(path("folder") + "/capture.json"))["kind"], "result");
    EXPECT_EQ(file_text(path("folder") + "/notes.txt"), "mine");
    EXPECT_EQ(file_text(path("folder") + "/more/notes.txt"), "also mine");
    EXPECT_EQ(fs::status(path("folder")).permissions(), fs::perms::owner_all);
}

TEST_F(ParityWrite, RefusesToReplaceTheFolderThatItRunsIn)
{
    namespace fs = std::filesystem;
    fs::create_directories(path("folder") + "/below");
    const fs::path before = fs::current_path();
    fs::current_path(path("folder") + "/below");
    for (const std::string &out : {std::string("."), std::string(".."), path("folder") + "/"}) {
        const Outcome outcome = claque({"parity", "export", "citizen", "--count", "1", "--out", out});
        EXPECT_EQ(outcome.code, 1) << out;
        EXPECT_NE(outcome.err.find(out + " holds the folder that the command runs in"), std::string::npos)
            << outcome.err;
    }
    fs::current_path(before);
    EXPECT_EQ(left(), (std::vector<std::string>{"folder"}));
}

TEST_F(ParityWrite, RefusesWhatCannotBeNumberedOrFound)
{
    Outcome outcome = claque({"parity", "capture", "citizen", "--format", "rgb565", "--out", path("a")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("8 bits"), std::string::npos) << outcome.err;
    outcome = claque({"parity", "export", path("none.glb"), "--out", path("a")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("none.glb"), std::string::npos) << outcome.err;
    outcome = claque({"parity", "export", "citizen", "--out", path("no/such/place")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("no/such/place"), std::string::npos) << outcome.err;
    EXPECT_EQ(claque({"parity"}).code, 2);
    EXPECT_TRUE(left().empty());
}

}  // namespace
}  // namespace cli_test
