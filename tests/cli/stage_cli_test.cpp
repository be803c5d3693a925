// stage: runs of people who decide, their records, pictures, reports and states.
#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;

const std::string scenarios = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";

class StageCommand : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        std::filesystem::copy(scenarios + "evacuation", path("evacuation"));
        std::string text = file_text(scenarios + "evacuation.toml");
        for (const char *count : {"count = 160", "count = 140"}) {
            const size_t at = text.find(count);
            ASSERT_NE(at, std::string::npos);
            text.replace(at, 11, "count = 12");
        }
        std::ofstream(path("hall.toml")) << text;
    }
    Json run(std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"stage", path("hall.toml"), "--fps", "5", "--json", "-"});
        const Outcome done = claque(more);
        EXPECT_EQ(done.code, 0) << done.err;
        EXPECT_EQ(done.err, "") << "no progress in a pipe";
        return done.code == 0 ? Json::parse(done.out) : Json();
    }
};

TEST_F(StageCommand, RecordsTheSameForAnyThreadsAndFlows)
{
    const Json first = run({"--record", path("1.clt"), "--threads", "1", "--in-turn"});
    EXPECT_EQ(first["frames"], 376);
    EXPECT_EQ(first["came"], 24);
    EXPECT_EQ(first["left"], 24);
    EXPECT_EQ(first["refused_commands"], 0);
    EXPECT_GT(first["decisions"], 200);
    EXPECT_EQ(first["record"]["steps"], 376);
    EXPECT_GT(first["record"]["pieces"], 500);
    ASSERT_EQ(first["doors"].size(), 3u);
    const Json second = run({"--record", path("2.clt"), "--threads", "2", "--apart"});
    EXPECT_EQ(second["hash"], first["hash"]);
    EXPECT_EQ(file_text(path("2.clt")), file_text(path("1.clt")));
    const Json other = run({"--seed", "2"});
    EXPECT_NE(other["hash"], first["hash"]);
}

// A line across the south door, which everyone passes once.
TEST_F(StageCommand, MeasuresAsTracksMeasuresItsRecord)
{
    const std::vector<std::string> of = {"--line=-1.5,-0.3,1.5,-0.3", "--area=-3,0,3,3", "--measure"};
    const Json report = run({"--record", path("run.clt"), of[0], of[1], of[2], path("run.csv")});
    const std::string rows = file_text(path("run.csv"));
    ASSERT_EQ(claque({"tracks", path("run.clt"), "--rate", "5", of[0], of[1], of[2], path("tracks.csv")}).code, 0);
    EXPECT_EQ(rows, file_text(path("tracks.csv")));
    EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 100) << "rows as long as somebody is there";
    const std::string last = rows.substr(rows.rfind(',') + 1);
    ASSERT_EQ(report["doors"][0]["name"], "south door");
    EXPECT_EQ(last, report["doors"][0]["passed"].dump() + "\n");
    EXPECT_GT(report["doors"][0]["passed"], 2);
    EXPECT_GT(report["doors"][0]["first_s"], 0);
    EXPECT_GT(report["doors"][0]["last_s"], report["doors"][0]["first_s"]);
    const Outcome alone = claque({"stage", path("hall.toml"), "--measure", path("no.csv")});
    EXPECT_NE(alone.err.find("--measure requires --record"), std::string::npos) << alone.err;
}

TEST_F(StageCommand, WearsTheColoursOfTheScenarioOrOfTheCommand)
{
    for (const auto &[file, colour] : {std::pair("red.toml", "#ff0000"), {"blue.toml", "#0000ff"}})
        std::ofstream(path(file)) << "[[classes]]\nname = \"citizens\"\nzones.tunic = { colour = \"" << colour
                                  << "\" }\n";
    const auto drawn = [&](std::vector<std::string> more) {
        more.insert(more.end(),
                    {"--seconds", "2", "--frames", "10:10", "--size", "160x120", "--out", path("f-%d.png")});
        run(more);
        return picture_of(path("f-10.png")).rgb;
    };
    const auto own = drawn({}), red = drawn({"--colours", path("red.toml")});
    EXPECT_NE(red, own);
    const std::string text = file_text(path("hall.toml"));
    std::ofstream(path("hall.toml")) << "colours = \"red.toml\"\n" << text;
    EXPECT_EQ(drawn({}), red);
    const auto blue = drawn({"--colours", path("blue.toml")});
    EXPECT_NE(blue, red);
    EXPECT_NE(blue, own);
}

TEST_F(StageCommand, DrawsWhatPlayThenShows)
{
    const Json live = run({"--seconds", "20", "--record", path("run.clt"), "--frames", "0:100", "--stride", "50",
                           "--size", "96x64", "--out", path("live-%03d.png")});
    EXPECT_EQ(live["frames"], 101);
    EXPECT_EQ(left().size(), 6u) << "two inputs, three pictures and a record";
    const Json silent = run({"--seconds", "20", "--record", path("silent.clt")});
    EXPECT_EQ(file_text(path("silent.clt")), file_text(path("run.clt"))) << "pictures change nothing";
    const Outcome played =
        claque({"play", path("run.clt"), "--time", "10", "--size", "96x64", "--json", "-", "--out", path("again.png")});
    ASSERT_EQ(played.code, 0) << played.err;
    EXPECT_GT(Json::parse(played.out)["frames"][0]["drawn"]["individuals"], 10);
}

// With the west door, which closes at 24 s.
TEST_F(StageCommand, IsPlayedInItsScenarioAsItWasDrawn)
{
    const std::vector<std::string> frames = {"--frames", "0:150", "--stride", "75", "--size", "480x320"};
    std::vector<std::string> drawing = {"--seconds", "31", "--record", path("run.clt"), "--out", path("run-%03d.png")};
    drawing.insert(drawing.end(), frames.begin(), frames.end());
    run(drawing);
    std::vector<std::string> playing = {"play", path("run.clt"), "--scenario",         path("hall.toml"), "--fps",
                                        "5",    "--out",         path("play-%03d.png")};
    playing.insert(playing.end(), frames.begin(), frames.end());
    const Outcome played = claque(playing);
    ASSERT_EQ(played.code, 0) << played.err;
    const auto picture = [&](const char *of, const char *frame) {
        return picture_of(path(of + std::string(frame) + ".png"));
    };
    for (const char *frame : {"000", "075", "150"})
        EXPECT_EQ(picture("run-", frame).rgb, picture("play-", frame).rgb) << frame;
    EXPECT_NE(picture("run-", "075").rgb, picture("run-", "150").rgb) << "a door closes, and people go";
    const Outcome not_its = claque(
        {"play", path("run.clt"), "--scenario", scenarios + "corner.toml", "--time", "1", "--out", path("x.png")});
    EXPECT_EQ(not_its.code, 2);
    EXPECT_NE(not_its.err.find("has no [stage]"), std::string::npos) << not_its.err;
}

TEST_F(StageCommand, IsPlayedWithWhatFliesOverPeopleThatLook)
{
    std::ofstream(path("guest.toml")) << "machine = \"guest\"\n[states.stands]\n"
                                         "enter = [ { look = [4.0, 1.0, 4.0] } ]\n";
    std::ofstream(path("owl.toml")) << R"(name = "an owl over three people"
[stage]
seconds = 2.0
[[characters]]
name = "guests"
character = "citizen"
[navigation]
rectangle = [-6.0, -6.0, 6.0, 6.0]
[[agents]]
class = "guests"
machine = "guest.toml"
count = 3
area = [-4.0, -4.0, 4.0, 4.0]
[[flyers]]
character = "owl"
path = [3.0, 2.0, 0.0, -3.0, 2.0, 3.0, -3.0, 2.0, -3.0]
)";
    const std::vector<std::string> frame = {"--frames", "25:25", "--size", "240x160"};
    const auto with_frame = [&](std::vector<std::string> words) {
        words.insert(words.end(), frame.begin(), frame.end());
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, 0) << done.err;
    };
    with_frame({"stage", path("owl.toml"), "--record", path("run.clt"), "--out", path("run-%d.png")});
    with_frame({"play", path("run.clt"), "--scenario", path("owl.toml"), "--out", path("play-%d.png")});
    EXPECT_EQ(picture_of(path("run-25.png")).rgb, picture_of(path("play-25.png")).rgb);
}

TEST_F(StageCommand, GoesOnFromAStateAsItWouldHaveGoneOn)
{
    const Json whole = run({"--save", path("state"), "--at", "20"});
    const Json rest = run({"--restore", path("state")});
    EXPECT_EQ(rest["hash"], whole["hash"]);
    EXPECT_EQ(rest["left"], 24);
    EXPECT_EQ(rest["frames"], 276);
    const Outcome other = claque({"stage", path("hall.toml"), "--seed", "9", "--restore", path("state")});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("state: "), std::string::npos) << other.err;
}

TEST_F(StageCommand, IsLedByCommandsThatSaveAndRestore)
{
    const Json whole = run({});
    std::ofstream(path("lines")) << "# ten seconds, and ten more that are taken back\nstep 50\nstep\n\nsave "
                                 << path("state") << "\nto 20\nrestore " << path("state") << "\ngo\n";
    const Json led = run({"--commands", path("lines")});
    EXPECT_EQ(led["hash"], whole["hash"]);
    EXPECT_EQ(led["left"], 24);
    EXPECT_EQ(led["frames"], 101 + 376 - 50);
    std::ofstream(path("lines")) << "to 4\nend\n";
    const Json ended = run({"--commands", path("lines")});
    EXPECT_EQ(ended["frames"], 21);
}

TEST_F(StageCommand, IsToldOfEventsByCommands)
{
    EXPECT_EQ(run({"--seconds", "11"})["left"], 0) << "the alarm comes later";
    std::ofstream(path("lines")) << "to 1\nsend alarm\n";
    const Json apart = run({"--seconds", "11", "--commands", path("lines")});
    EXPECT_GT(apart["left"], 0);
    EXPECT_EQ(apart["late_messages"], 0);
    EXPECT_EQ(run({"--seconds", "11", "--in-turn", "--commands", path("lines")})["hash"], apart["hash"]);
}

TEST_F(StageCommand, RefusesLinesThatAreNoCommandsByNumber)
{
    const auto refused = [&](const std::string &line, const std::string &says) {
        std::ofstream(path("lines")) << "step\n" << line;
        const Outcome done = claque({"stage", path("hall.toml"), "--fps", "5", "--commands", path("lines")});
        EXPECT_EQ(done.code, 1) << line;
        EXPECT_NE(done.err.find(says), std::string::npos) << done.err;
    };
    refused("jump 5\n", "lines, line 2: 'jump' is no command; known are step");
    refused("save", "line 2: 'save' needs a name");
    refused("to nowhere", "line 2: 'to' needs a number");
    refused("step 0", "'step' needs a number of frames from 1");
    refused("go now", "there is 'now' behind 'go'");
    refused("send dinner", "the event 'dinner'");
    refused("restore " + path("nothing"), "nothing: ");
}

TEST_F(StageCommand, PausesStepsAndSavesLive)
{
    std::ofstream(path("lines")) << "pause\nstep 5\nstep 5\njump\nsave " << path("state") << "\nend\n";
    const Outcome done = claque({"stage", path("hall.toml"), "--fps", "5", "--live", "--commands", path("lines")});
    EXPECT_EQ(done.code, 0);
    EXPECT_NE(done.err.find("line 4: 'jump' is no command"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("The run goes on as it was."), std::string::npos) << done.err;
    std::ofstream(path("lines")) << "end\n";
    const Json on = run({"--live", "--restore", path("state"), "--commands", path("lines")});
    EXPECT_NEAR(on["decided_s"].get<double>(), 2 + 1, 0.5)
        << "the state is that of two seconds, and decisions are ahead";
}

TEST_F(StageCommand, GoesLiveAndRecordsWhatHappened)
{
    for (const char *flow : {"--apart", "--in-turn"}) {
        const Json live = run({"--live", "--seconds", "2", flow, "--record", path("live.clt")});
        const int frames = live["live"]["frames"].get<int>();
        EXPECT_GE(frames, 1);
        EXPECT_LE(frames, 10);
        EXPECT_EQ(live["record"]["steps"], frames + 1) << "and the one before the clock began";
        EXPECT_EQ(live["came"], 24);
        const Outcome played =
            claque({"play", path("live.clt"), "--time", "1", "--size", "48x32", "--out", path("l.png")});
        EXPECT_EQ(played.code, 0) << played.err;
    }
    const Outcome both = claque({"stage", path("hall.toml"), "--live", "--frames", "0:1", "--out", path("%d.png")});
    EXPECT_EQ(both.code, 2);
}

TEST_F(StageCommand, LeavesNoHalfFile)
{
    std::ofstream(path("evacuation/visitor.toml"), std::ios::app) << "\n[states.idle]\ninitial = true\n";
    const Outcome bad = claque({"stage", path("hall.toml"), "--record", path("run.clt")});
    EXPECT_EQ(bad.code, 1);
    EXPECT_NE(bad.err.find("hall.toml:"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find("visitor.toml, line 41"), std::string::npos) << bad.err;
    EXPECT_EQ(left(), (std::vector<std::string>{"evacuation", "hall.toml"}));
    // The run itself fails, after the record has begun.
    std::string text = file_text(path("hall.toml"));
    for (size_t at; (at = text.find("exits = ")) != std::string::npos;) text.erase(at, text.find('\n', at) - at);
    std::ofstream(path("hall.toml")) << text;
    std::filesystem::copy_file(scenarios + "evacuation/visitor.toml", path("evacuation/visitor.toml"),
                               std::filesystem::copy_options::overwrite_existing);
    const Outcome lost = claque({"stage", path("hall.toml"), "--record", path("run.clt")});
    EXPECT_EQ(lost.code, 1);
    EXPECT_NE(lost.err.find("has no 'exits'"), std::string::npos) << lost.err;
    EXPECT_EQ(left(), (std::vector<std::string>{"evacuation", "hall.toml"}));
}

TEST_F(StageCommand, WrongUseIsSaidBeforeAnythingIsDone)
{
    const auto refused = [&](std::vector<std::string> more, const std::string &says) {
        more.insert(more.begin(), {"stage", path("hall.toml")});
        const Outcome done = claque(more);
        EXPECT_EQ(done.code, 2) << says;
        EXPECT_NE(done.err.find(says), std::string::npos) << done.err;
    };
    refused({"--frames", "0:5", "--out", path("x.png")}, "one place for the frame number");
    refused({"--frames", "0:5"}, "--out");
    refused({"--frames", "0:9000", "--out", path("%d.png")}, "ends at 9000, and the run has 1875 frames");
    refused({"--record", path("run.mp4")}, "run.mp4' would hold a record, so its name must end in .clt");
    refused({"--record", path("run.clt"), "--measure", "-", "--json", "-"}, "standard output takes one");
    refused({"--at", "5"}, "--save");
    refused({"--save", path("s"), "--at", "99"}, "after the end of the run");
    refused({"--apart", "--in-turn"}, "excludes");
    const Outcome other = claque({"stage", scenarios + "corner.toml"});
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("has no [stage]"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace cli_test
