// Scenarios on the command line: render, sheet, bench and parity draw what a file describes.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string source = CLAQUE_SOURCE_DIR, odeon = source + "/samples/scenes/odeon/odeon.toml",
                  corner = source + "/samples/scenarios/corner.toml";

class ScenarioCommand : public Drawing
{
protected:
    // The report of a picture or a sequence.
    Json render(std::vector<std::string> arguments) const
    {
        const bool sequence = std::find(arguments.begin(), arguments.end(), "--frames") != arguments.end();
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--size", "64x48", "--json", path("r.json"), "--out",
                                           path(sequence ? "f-%03d.png" : "f.png"), "--threads", "1"});
        const Outcome done = claque(arguments);
        EXPECT_EQ(done.code, 0) << done.err;
        return done.code == 0 ? Json::parse(file_text(path("r.json"))) : Json();
    }
    std::string hash(const std::vector<std::string> &arguments) const
    {
        const Json report = render(arguments);
        return report.is_null() ? "" : report["frames"][0]["picture_hash"].get<std::string>();
    }
    // The corner's scenario with lines before and after what is in it.
    std::string changed(const std::string &was, const std::string &is, const std::string &more = "") const
    {
        fs::copy(source + "/samples/scenarios", path("s"),
                 fs::copy_options::overwrite_existing | fs::copy_options::recursive);
        std::string text = file_text(corner);
        const size_t at = text.find(was);
        EXPECT_NE(at, std::string::npos) << was;
        std::ofstream(path("s/mine.toml")) << text.replace(at, was.size(), is) << more;
        return path("s/mine.toml");
    }
};

TEST_F(ScenarioCommand, TheOdeonIsOneOfThem)
{
    for (const char *camera : {"overview", "close", "path"}) {
        const std::vector<std::string> rest = {"--time", "13", "--camera", camera, "--count", "60"};
        std::vector<std::string> scene = {"--scene", "odeon"}, file = {"--scenario", odeon};
        scene.insert(scene.end(), rest.begin(), rest.end());
        file.insert(file.end(), rest.begin(), rest.end());
        EXPECT_EQ(hash(scene), hash(file)) << camera;
    }
    const Json report = render({"--scenario", odeon, "--time", "13"});
    EXPECT_EQ(report["count"], 1020);
    EXPECT_EQ(report["scene"], "odeon");
    EXPECT_EQ(report["scenario"], odeon);
}

TEST_F(ScenarioCommand, AFrameOfTheCornerAloneIsTheFrameInTheSequence)
{
    const Json sequence = render({"--scenario", corner, "--frames", "55:56", "--fps", "5"});
    EXPECT_EQ(sequence["count"], 14);
    EXPECT_EQ(sequence["camera"], "path") << "frames follow the scenario's path";
    const Json alone = render({"--scenario", corner, "--camera", "path", "--time", "11.2"});
    EXPECT_EQ(sequence["frames"][1]["picture_hash"], alone["frames"][0]["picture_hash"]);
    EXPECT_NE(sequence["frames"][0]["picture_hash"], alone["frames"][0]["picture_hash"]);
    EXPECT_EQ(render({"--scenario", corner, "--time", "11.2"})["camera"], "overview");
}

// Through a long lens a metre has more pixels than the update period counts at sixty metres, and feet would slide back
// and forth.
TEST_F(ScenarioCommand, WalkersInTheCorridorArePosedInEachFrameOfALongLens)
{
    const std::string corridor = source + "/samples/scenarios/corridor.toml";
    const Outcome done = claque({"render", "--scenario", corridor, "--frames", "925:928", "--size", "720x900", "--json",
                                 path("r.json"), "--out", path("f-%03d.png"), "--threads", "1"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(file_text(path("r.json")));
    EXPECT_EQ(report["count"], 36);
    for (const Json &frame : report["frames"]) {
        EXPECT_GT(frame["counters"]["visible"], 5);
        EXPECT_GE(frame["counters"]["due"], frame["counters"]["visible"]);
    }
}

TEST_F(ScenarioCommand, IsThePlayOfItsOptions)
{
    const std::string file = source + "/samples/scenarios/corner.csv";
    std::ofstream(path("plain.toml"))
        << "name = \"plain\"\n[tracks]\nfile = \"" << file
        << "\"\ncolumns = \"id,frame,x,y\"\nrate_hz = 2\nunit = \"m\"\n[ground]\narea = \""
        << source + "/samples/scenarios/corner.wkt\"\n";
    const Outcome played = claque({"play",      file,
                                   "--columns", "id,frame,x,y",
                                   "--rate",    "2",
                                   "--unit",    "m",
                                   "--ground",  source + "/samples/scenarios/corner.wkt",
                                   "--size",    "64x48",
                                   "--time",    "9",
                                   "--threads", "1",
                                   "--json",    path("play.json"),
                                   "--out",     path("play.png")});
    ASSERT_EQ(played.code, 0) << played.err;
    const Json report = Json::parse(file_text(path("play.json")));
    EXPECT_EQ(report["frames"][0]["picture_hash"], hash({"--scenario", path("plain.toml"), "--time", "9"}));
}

TEST_F(ScenarioCommand, EachPartOfTheFileShows)
{
    const auto shown = [&](const std::string &file) {
        return hash({"--scenario", file, "--time", "9", "--camera", "path"});
    };
    const std::string own = shown(corner);
    EXPECT_EQ(own, shown(changed("name", "name")));
    const std::string map = "colours = \"" + source + "/samples/maps/roman-classes.toml\"\n";
    for (const auto &[was, is] : std::vector<std::pair<std::string, std::string>>{
             {"share = 3", "share = 0"},
             {"hue = [18.0, 60.0]", "hue = [180.0, 260.0]"},
             {"paving = [0.80, 0.77, 0.72]", "paving = [0.30, 0.30, 0.30]"},
             {"around = [0.52, 0.50, 0.44]", "around = [0.20, 0.50, 0.20]"},
             {"area = \"corner.wkt\"", ""},
             {"to_sun = [-0.45, 0.70, 0.55]", "to_sun = [0.45, 0.70, 0.55]"},
             {"sun = [0.78, 0.70, 0.56]", "sun = [0.40, 0.40, 0.56]"},
             {"[-8.0, 5.5, 8.5]", "[-8.0, 6.5, 8.5]"},
             {"rate_hz = 2", "rate_hz = 2.2"},
             {"origin_m = [0.0, 0.0]", "origin_m = [1.0, 0.0]"},
             {"name = \"corner\"", "name = \"corner\"\n" + map}})
        EXPECT_NE(own, shown(changed(was, is))) << is;
}

TEST_F(ScenarioCommand, TheCameraFollowsAPersonUnlessAnotherIsAskedFor)
{
    std::string text = file_text(changed("name", "name"));
    std::ofstream(path("s/mine.toml")) << text.substr(0, text.find("[camera]")) << "[camera]\nfollow = \"4\"\n";
    const Json follows = render({"--scenario", path("s/mine.toml"), "--time", "9"});
    EXPECT_EQ(follows["camera"], "follow:4");
    const Json above = render({"--scenario", path("s/mine.toml"), "--time", "9", "--camera", "overview"});
    EXPECT_EQ(above["camera"], "overview");
    EXPECT_NE(follows["frames"][0]["picture_hash"], above["frames"][0]["picture_hash"]);
}

// People get levels of detail; an owl has its own.
TEST_F(ScenarioCommand, APersonWithARoleMayBeAnOwl)
{
    std::ofstream(path("owls.toml")) << "name = \"owls\"\n[[characters]]\nname = \"birds\"\ncharacter = \"owl\"\n"
                                        "[[people]]\nclass = \"birds\"\nat = [0.0, 1.0, 0.0]\n";
    EXPECT_EQ(render({"--scenario", path("owls.toml"), "--time", "1"})["frames"][0]["drawn"]["individuals"], 1);
}

// The two scenarios of docs/scenarios.md, as they stand there.
TEST_F(ScenarioCommand, TheExamplesOfThePageAreDrawn)
{
    fs::copy(source + "/samples/scenarios", path("s"));
    const std::string page = file_text(source + "/docs/scenarios.md");
    std::vector<unsigned> counts;
    for (size_t at = page.find("```toml\n"); at != std::string::npos; at = page.find("```toml\n", at + 1)) {
        const size_t begin = at + 8;
        std::ofstream(path("s/example.toml")) << page.substr(begin, page.find("```", begin) - begin);
        const Json report = render({"--scenario", path("s/example.toml"), "--time", "9"});
        counts.push_back(report["count"].get<unsigned>());
        EXPECT_GT(report["frames"][0]["drawn"]["individuals"], 2u) << counts.size();
    }
    EXPECT_EQ(counts, (std::vector<unsigned>{14, 60}));
}

TEST_F(ScenarioCommand, ASheetHasTheSectionsOfItsPath)
{
    const Outcome done =
        claque({"sheet", "--scenario", corner, "--size", "48x36", "--out", path("s.png"), "--json", "-"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(done.out);
    ASSERT_EQ(report["tiles"].size(), 2u);
    EXPECT_EQ(report["tiles"][1]["section"], "at the corner");
    EXPECT_GT(report["tiles"][1]["in_view"], 2);
}

TEST_F(ScenarioCommand, BenchMeasuresTracksAlongThePathAndWhereMostPeopleAre)
{
    const std::vector<std::string> quick = {"--frames", "2",      "--cache", "full,none", "--strategy",
                                            "fused",    "--size", "48x36",   "--json"};
    std::vector<std::string> along = {"bench", "--scenario", corner},
                             above = {"bench", "--scenario", corner, "--camera", "overview"};
    along.insert(along.end(), quick.begin(), quick.end());
    above.insert(above.end(), quick.begin(), quick.end());
    const Outcome path_done = claque(along), above_done = claque(above);
    ASSERT_EQ(path_done.code, 0) << path_done.err;
    ASSERT_EQ(above_done.code, 0) << above_done.err;
    const Json path_report = Json::parse(path_done.out), above_report = Json::parse(above_done.out);
    EXPECT_EQ(path_report["scene"], "corner");
    EXPECT_EQ(path_report["count"], 14);
    EXPECT_EQ(path_report["sections"].size(), 2u);
    ASSERT_EQ(above_report["runs"].size(), 2u);
    EXPECT_EQ(above_report["runs"][0]["count"], 14);
    EXPECT_GE(above_report["runs"][0]["counters"]["visible"], 9) << "of those who are there at once";
    const Outcome counted = claque({"bench", "--scenario", corner, "--camera", "overview", "--count", "3"});
    EXPECT_EQ(counted.code, 2);
    EXPECT_NE(counted.err.find("file of trajectories"), std::string::npos) << counted.err;
}

TEST_F(ScenarioCommand, ACameraFollowsThePersonThatIsNamed)
{
    const std::string text = "name = \"plain\"\n[tracks]\nfile = \"" + source +
                             "/samples/scenarios/corner.csv\"\ncolumns = \"id,frame,x,y\"\nrate_hz = 2\nunit = \"m\"\n";
    std::ofstream(path("plain.toml")) << text;
    std::ofstream(path("follows.toml")) << text << "[camera]\nfollow = \"4\"\n";
    const Json followed = render({"--scenario", path("plain.toml"), "--time", "9", "--camera", "follow:4"});
    EXPECT_EQ(followed["camera"], "follow:4");
    EXPECT_EQ(followed["frames"][0]["picture_hash"], hash({"--scenario", path("follows.toml"), "--time", "9"}))
        << "as the scenario says it";
    EXPECT_NE(followed["frames"][0]["picture_hash"], hash({"--scenario", path("plain.toml"), "--time", "9"}));
    const Outcome nowhere = claque({"render", "--scene", "plaza", "--camera", "follow:4", "--out", path("n.png")});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_NE(nowhere.err.find("needs people on tracks"), std::string::npos) << nowhere.err;
    const Outcome gone =
        claque({"render", "--scenario", corner, "--camera", "follow:99", "--time", "9", "--out", path("n.png")});
    EXPECT_NE(gone.code, 0);
    EXPECT_NE(gone.err.find("--camera follow:99"), std::string::npos) << gone.err;
}

TEST_F(ScenarioCommand, BenchMeasuresAFileOfTrajectoriesByItself)
{
    const std::vector<std::string> quick = {"--frames", "2",      "--cache", "full,none", "--strategy",
                                            "fused",    "--size", "48x36",   "--json"};
    std::vector<std::string> file = {
        "bench", source + "/samples/scenarios/corner.csv", "--rate", "2", "--unit", "m", "--columns", "id,frame,x,y"};
    file.insert(file.end(), quick.begin(), quick.end());
    const Outcome done = claque(file);
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(done.out);
    EXPECT_EQ(report["scene"], "corner.csv");
    ASSERT_EQ(report["runs"].size(), 2u);
    for (const Json &run : report["runs"]) {
        EXPECT_EQ(run["count"], 14);
        EXPECT_GE(run["counters"]["visible"], 9);
    }
    const Outcome other = claque({"bench", "plaza", "--rate", "2"});
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("is for a file of trajectories"), std::string::npos) << other.err;
}

TEST_F(ScenarioCommand, ParityTakesTracks)
{
    for (const char *what : {"export", "capture"}) {
        const Outcome done = claque({"parity", what, "--scenario", corner, "--time", "9", "--size", "64x48",
                                     "--threads", "1", "--out", path(what)});
        ASSERT_EQ(done.code, 0) << done.err;
    }
    const Outcome same = claque({"parity", "compare", path("capture"), path("capture")});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_NE(file_text(path("export/capture.json")).find("corner"), std::string::npos);
}

TEST_F(ScenarioCommand, WhatTheLibraryFindsInItsFilesIsSaidWithTheirPlace)
{
    for (const auto &[was, is, says] : std::vector<std::array<std::string, 3>>{
             {"rate_hz = 2", "", "mine.toml:6:1: "},
             {"walk = \"walk\"", "walk = \"fly\"", "the character plebeian has no clip named fly; there are: stand"},
             {"\"corner.wkt\"", "\"corner.csv\"", "mine.toml:29:8: "},
             {"tunic", "kilt", "the workers have a palette for 'kilt'"},
             {"character = \"citizen\"", "character = \"senator\"", "senator"}}) {
        const Outcome done = claque({"render", "--scenario", changed(was, is), "--out", path("x.png")});
        EXPECT_EQ(done.code, 1) << is;
        EXPECT_NE(done.err.find("mine.toml:"), std::string::npos) << done.err;
        EXPECT_NE(done.err.find(says), std::string::npos) << done.err;
    }
}

}  // namespace
}  // namespace cli_test
