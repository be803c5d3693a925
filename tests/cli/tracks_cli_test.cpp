// tracks and play: what a file of trajectories holds, a plan of it, and pictures of the people in it.
#include <cmath>
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

// Two people pass each other, one of them after a rest: ten rows a second.
void write_table(const std::string &path, double unit = 1)
{
    std::ofstream out(path);
    out << "id,frame,x,y\n";
    for (int frame = 0; frame <= 100; ++frame) {
        const double t = 0.1 * frame, rested = t < 3 ? t : t < 6 ? 3 : t - 3;
        out << "anna," << frame << ',' << unit * (1.2 * rested - 4) << ',' << unit * 1 << '\n';
        if (frame > 20) out << "ben," << frame << ',' << unit * (4 - 1.4 * (t - 2)) << ',' << unit * -1 << '\n';
    }
}

class TracksCommand : public Command
{
protected:
    void SetUp() override { write_table(path("two.csv")); }
    std::vector<std::string> table(const char *command) const
    {
        return {command, path("two.csv"), "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"};
    }
    static std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string> &more)
    {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

class PlayCommand : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        write_table(path("two.csv"));
    }
    Outcome play(const std::vector<std::string> &more) const
    {
        std::vector<std::string> arguments = {"play",         path("two.csv"), "--columns", "id,frame,x,y", "--rate",
                                              "10",           "--unit",        "m",         "--size",       "160x120",
                                              "--characters", "citizen"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return claque(arguments);
    }
};

}  // namespace

TEST_F(TracksCommand, TellsHowFastAndHowLongEachPersonWalked)
{
    const Outcome outcome = claque(with(table("tracks"), {"--json", "-"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["people"], 2);
    EXPECT_EQ(report["most_at_once"], 2);
    EXPECT_EQ(report["samples"], 101 + 80);
    EXPECT_NEAR(report["length_s"].get<double>(), 10, 1e-6);
    EXPECT_NEAR(report["speed_m_s"]["max"].get<double>(), 1.4, 0.01);
    EXPECT_NEAR(report["shown"]["standing_share"].get<double>(), 2.3 / 18, 0.04);
    EXPECT_NEAR(report["shown"]["distance_m"].get<double>(), 1.2 * 7 + 1.4 * 8, 0.4);
    EXPECT_LT(report["shown"]["mean_shift_m"].get<double>(), 0.05);
    EXPECT_TRUE(report["warnings"].empty());
    const Outcome text = claque(table("tracks"));
    ASSERT_EQ(text.code, 0) << text.err;
    EXPECT_NE(text.out.find("people           2, at most 2 at once"), std::string::npos) << text.out;
}

TEST_F(TracksCommand, ReadsTheSameFromOtherUnits)
{
    write_table(path("two.csv"), 100);
    std::vector<std::string> centimetres = table("tracks");
    centimetres.back() = "cm";
    const Outcome outcome = claque(with(centimetres, {"--json", "-"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(nlohmann::json::parse(outcome.out)["speed_m_s"]["max"].get<double>(), 1.4, 0.01);
}

TEST_F(TracksCommand, DrawsAPlanOfThePaths)
{
    ASSERT_EQ(claque(with(table("tracks"), {"--plot", path("plan.svg")})).code, 0);
    const std::string svg = file_text(path("plan.svg"));
    EXPECT_NE(svg.find("2 people in 10.0 s"), std::string::npos);
    EXPECT_NE(svg.find("<svg"), std::string::npos);
    for (const char *on_axes : {">x in m<", ">y in m<", ">-4<", ">2<", ">0<"})
        EXPECT_NE(svg.find(on_axes), std::string::npos) << on_axes;
    ASSERT_EQ(claque(with(table("tracks"), {"--plot", path("plan.png")})).code, 0);
    EXPECT_GT(picture_of(path("plan.png")).width, 500);
}

TEST_F(TracksCommand, AsksByOptionNameForWhatTheFileLacks)
{
    const struct {
        std::vector<std::string> arguments;
        int code;
        std::string says;
    } cases[] = {
        {{"tracks", path("two.csv"), "--columns", "id,frame,x,y", "--unit", "m"}, 1, "--rate"},
        {{"tracks", path("two.csv"), "--columns", "id,frame,x,y", "--rate", "10"}, 1, "--unit"},
        {{"tracks", path("two.csv"), "--unit", "ell"}, 2, "'ell' is no unit"},
        {{"tracks", path("none.csv")}, 1, "none.csv"},
        {{"tracks"}, 2, "FILE"},
        {with(table("tracks"), {"--characters", "dragon"}), 1, "dragon"},
        {with(table("play"), {"--out", path("a.png"), "--time", "1", "--camera", "follow:carl"}), 1, "carl"},
        {with(table("play"), {"--out", path("a.png"), "--time", "1", "--camera", "aerial"}), 2,
         "'aerial' is no camera"},
        {with(table("play"), {"--out", path("a.png"), "--time", "1", "--ground", path("none.wkt")}), 1, "none.wkt"},
        {with(table("play"), {"--out", path("a.png")}), 2, "frame number"},
    };
    for (const auto &c : cases) {
        const Outcome outcome = claque(c.arguments);
        EXPECT_EQ(outcome.code, c.code) << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(left(), std::vector<std::string>{"two.csv"});
}

TEST_F(PlayCommand, DrawsTheWholeFileAndGoesOnWhereItEnded)
{
    ASSERT_EQ(play({"--fps", "1", "--out", path("f-%02d.png")}).code, 0);
    EXPECT_EQ(left().size(), 1u + 11u);
    std::remove(path("f-04.png").c_str());
    const Outcome again = play({"--fps", "1", "--out", path("f-%02d.png"), "--json", path("again.json")});
    ASSERT_EQ(again.code, 0) << again.err;
    const auto report = nlohmann::json::parse(file_text(path("again.json")));
    EXPECT_EQ(report["frames"].size(), 1u);
    EXPECT_EQ(report["frames"][0]["frame"], 4);
    EXPECT_EQ(report["skipped"].size(), 10u);
}

TEST_F(PlayCommand, RefusesToGoOnWithPicturesOfOtherSettings)
{
    const std::vector<std::string> frames = {"--frames", "0:1", "--out", path("f-%d.png")};
    const auto played = [&](const std::vector<std::string> &more) {
        std::vector<std::string> all = frames;
        all.insert(all.end(), more.begin(), more.end());
        return play(all);
    };
    std::ofstream(path("hall.wkt")) << "POLYGON ((-6 -3, 6 -3, 6 3, -6 3, -6 -3))";
    ASSERT_EQ(played({}).code, 0);
    ASSERT_EQ(played({}).code, 0);
    const auto before = file_text(path("f-1.png"));
    const std::vector<std::pair<std::vector<std::string>, std::string>> others = {
        {{"--camera", "close"}, "/camera is \"\" there and \"close\" here"},
        {{"--camera", "follow:anna"}, "/camera is \"\" there and \"follow:anna\" here"},
        {{"--seed", "7"}, "/seed is 1 there and 7 here"},
        {{"--hour", "9"}, "/hour is 0.0 there and 9.0 here"},
        {{"--lod", "off"}, "/levels/0 is \"on\" there and \"off\" here"},
        {{"--ground", path("hall.wkt")}, "/ground/file is missing there"},
        {{"--fps", "10"}, "f-1.png is a picture of other settings: /time_s is 0.04 there and 0.1 here"},
    };
    for (const auto &[options, sentence] : others) {
        const Outcome refused = played(options);
        EXPECT_EQ(refused.code, 1) << options[1];
        EXPECT_NE(refused.err.find(sentence), std::string::npos) << options[1] << ": " << refused.err;
        EXPECT_NE(refused.err.find("choose another --out, or draw all anew with --again"), std::string::npos);
        EXPECT_EQ(file_text(path("f-1.png")), before);
    }
    write_table(path("two.csv"), 0.9);
    const Outcome file = played({});
    EXPECT_EQ(file.code, 1);
    EXPECT_NE(file.err.find("/file/sha256"), std::string::npos) << file.err;
    EXPECT_EQ(played({"--again"}).code, 0);
    EXPECT_NE(file_text(path("f-1.png")), before);
    EXPECT_EQ(played({}).code, 0);
    // A picture that somebody else made.
    std::ofstream(path("f-1.png"), std::ios::binary) << before.substr(0, 33) + before.substr(before.find("IDAT") - 4);
    const Outcome unknown = played({});
    EXPECT_EQ(unknown.code, 1);
    EXPECT_NE(unknown.err.find("f-1.png is a picture that does not say how it was drawn"), std::string::npos)
        << unknown.err;
}

TEST_F(PlayCommand, AFrameAloneIsTheFrameInTheSequence)
{
    ASSERT_EQ(play({"--frames", "40:44", "--fps", "10", "--out", path("f-%02d.png"), "--json", path("a.json")}).code,
              0);
    ASSERT_EQ(play({"--time", "4.3", "--out", path("alone.png"), "--json", path("b.json")}).code, 0);
    const auto sequence = nlohmann::json::parse(file_text(path("a.json")));
    const auto alone = nlohmann::json::parse(file_text(path("b.json")));
    EXPECT_EQ(sequence["frames"][3]["picture_hash"], alone["frames"][0]["picture_hash"]);
    EXPECT_NE(sequence["frames"][2]["picture_hash"], alone["frames"][0]["picture_hash"]);
    EXPECT_EQ(alone["scene"], "tracks");
    EXPECT_EQ(alone["count"], 2);
}

TEST_F(PlayCommand, FollowsAPersonAndLaysAGround)
{
    std::ofstream(path("hall.wkt")) << "POLYGON ((-6 -3, 6 -3, 6 3, -6 3, -6 -3))";
    ASSERT_EQ(play({"--time", "4", "--out", path("all.png")}).code, 0);
    const Outcome behind =
        play({"--time", "4", "--out", path("ben.png"), "--camera", "follow:ben", "--ground", path("hall.wkt")});
    ASSERT_EQ(behind.code, 0) << behind.err;
    EXPECT_NE(picture_of(path("all.png")).rgb, picture_of(path("ben.png")).rgb);
}

TEST_F(PlayCommand, WarnsWhenTheFollowedPersonIsAbsent)
{
    const auto followed = [&](const std::string &id, const std::string &time_s) {
        return play({"--time", time_s, "--camera", "follow:" + id, "--out", path("p.png")});
    };
    const std::string there = "person ben is present from 2.1 to 10 s";
    EXPECT_NE(followed("ben", "1").err.find(there), std::string::npos);
    for (const char *time_s : {"2.1", "5", "10"})
        EXPECT_EQ(followed("ben", time_s).err.find("is present from"), std::string::npos) << time_s;
    EXPECT_NE(followed("bne", "5").err.find("no person has the id bne that the camera is to follow: 'ben' is near"),
              std::string::npos);
}

TEST_F(PlayCommand, WarnsOfTimesWithoutPeople)
{
    const auto at = [&](const char *file, const char *time_s) {
        Words words = {"play", path(file), "--size", "160x120", "--time", time_s, "--out", path("p.png")};
        if (std::string(file) == "two.csv")
            words.insert(words.end(), {"--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"});
        return claque(words).err;
    };
    EXPECT_NE(at("two.csv", "99").find("the file has people from 0 to 10 s: pictures of other times are empty"),
              std::string::npos);
    EXPECT_NE(at("two.csv", "-5").find("pictures of other times are empty"), std::string::npos);
    for (const char *time_s : {"0", "10"}) EXPECT_EQ(at("two.csv", time_s), "") << time_s;
    ASSERT_EQ(play({"--frames", "50:75", "--out", path("f-%d.png"), "--record", path("run.clt")}).code, 0);
    EXPECT_NE(at("run.clt", "99").find("the record runs from 2 to 3 s: pictures of other times show its end"),
              std::string::npos);
    EXPECT_NE(at("run.clt", "0").find("pictures of other times show its first step"), std::string::npos);
    for (const char *time_s : {"2", "3"}) EXPECT_EQ(at("run.clt", time_s), "") << time_s;
}

}  // namespace cli_test
