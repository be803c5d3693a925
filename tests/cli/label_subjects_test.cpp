// What claque labels is asked to label: a scene, a scenario, a file of trajectories or a record, by its name alone.
#include <algorithm>
#include <fstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

class LabelSubjects : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        std::ofstream table(path("two.csv"));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame <= 30; ++frame)
            table << "1," << frame << ',' << 0.1 * frame << ",0\n2," << frame << ",0," << 1 + 0.1 * frame << '\n';
        std::ofstream(path("two.toml")) << "name = \"two\"\n[tracks]\nfile = \"two.csv\"\n"
                                           "columns = \"id,frame,x,y\"\nrate_hz = 10\n"
                                           "unit = \"m\"\n";
    }

    Outcome label(const std::string &folder, std::vector<std::string> subject, std::vector<std::string> more = {}) const
    {
        std::vector<std::string> all = {"labels",   "--out",    path(folder), "--size", "96x72",   "--frames", "10:11",
                                        "--camera", "overview", "--fps",      "10",     "--write", "coco,mot"};
        all.insert(all.end(), subject.begin(), subject.end());
        all.insert(all.end(), more.begin(), more.end());
        return claque(all);
    }

    std::map<std::string, std::string> labels_in(const std::string &folder) const
    {
        auto found = contents(folder);
        found.erase("settings.json");  // names its files; each picture's JSON has its hash
        for (const char *name : {"frames/000010.json", "frames/000011.json"}) EXPECT_EQ(found.erase(name), 1u);
        return found;
    }

    const std::vector<std::string> reading_ = {"--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"};
};

TEST_F(LabelSubjects, AreScenesByTheirNames)
{
    ASSERT_EQ(label("named", {"plaza", "--count", "6"}).code, 0);
    ASSERT_EQ(label("option", {"--scene", "plaza", "--count", "6"}).code, 0);
    EXPECT_TRUE(contents("named") == contents("option"));
}

TEST_F(LabelSubjects, AreScenariosAndFilesOfTrajectories)
{
    Outcome outcome = label("tracks", {path("two.csv")}, reading_);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    outcome = label("scenario", {path("two.toml")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto made = labels_in("tracks");
    EXPECT_TRUE(made == labels_in("scenario"));
    const std::string &mot = made.at("mot/gt/gt.txt");
    EXPECT_EQ(std::count(mot.begin(), mot.end(), '\n'), 4) << mot;  // two people in two frames
    // A folder has the labels of one way of reading.
    outcome = label("tracks", {path("two.csv")}, {"--columns", "id,frame,y,x", "--rate", "10", "--unit", "m"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("/tracks/columns is \"id,frame,x,y\" there and \"id,frame,y,x\" here"),
              std::string::npos)
        << outcome.err;
}

// A camera path shows both from one place; the grounds differ.
TEST_F(LabelSubjects, AreRecordsWithTheBoxesOfTheirPeople)
{
    std::ofstream camera(path("camera.toml"));
    camera << "far_m = 500.0\n[[sections]]\nname = \"all\"\nstart_s = 0.0\nend_s = 100.0\n";
    for (const char *time_s : {"0.0", "100.0"})
        camera << "[[keys]]\ntime_s = " << time_s << "\neye = [1.5, 3.0, 7.0]\ntarget = [1.5, 0.8, -1.0]\n"
               << "fov_deg = 50.0\nnear_m = 0.1\n";
    camera.close();
    std::vector<std::string> play = {"play",  path("two.csv"), "--record", path("run.clt"), "--size",
                                     "32x24", "--frames",      "0:30",     "--fps",         "10",
                                     "--out", path("p-%d.png")};
    play.insert(play.end(), reading_.begin(), reading_.end());
    ASSERT_EQ(claque(play).code, 0);
    const auto seen = [&](const std::string &folder, const std::string &file, std::vector<std::string> more) {
        std::vector<std::string> all = {"labels", "--out",    path(folder), file,     "--size",
                                        "96x72",  "--frames", "10:11",      "--path", path("camera.toml"),
                                        "--fps",  "10",       "--write",    "mot"};
        all.insert(all.end(), more.begin(), more.end());
        return claque(all);
    };
    const auto boxes = [&](const std::string &folder, const std::string &file, const std::vector<std::string> &more) {
        const Outcome outcome = seen(folder, file, more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return file_text(path(folder + "/mot/gt/gt.txt"));
    };
    const std::string of_record = boxes("record", path("run.clt"), {});
    EXPECT_EQ(std::count(of_record.begin(), of_record.end(), '\n'), 4) << of_record;
    EXPECT_EQ(of_record, boxes("tracks", path("two.csv"), reading_));
    const Outcome refused = label("columns", {path("run.clt")}, {"--columns", "id,frame,x,y"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("--columns: is for files of trajectories; FILE is a record"), std::string::npos)
        << refused.err;
    // Nobody is there behind the end.
    const std::vector<std::pair<std::string, std::vector<std::string>>> subjects = {
        {"run.clt", {}}, {"two.csv", reading_}, {"two.toml", {}}};
    for (const auto &[file, more] : subjects) {
        std::vector<std::string> words = {"labels", path(file), "--out", path("behind"), "--size",
                                          "96x72",  "--fps",    "10",    "--frames",     "10,31"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome behind = claque(words);
        EXPECT_EQ(behind.code, 2) << file;
        EXPECT_NE(behind.err.find("--frames: ends at 31, and the last frame of "), std::string::npos) << behind.err;
        EXPECT_NE(behind.err.find(" is 30 at 10 frames a second"), std::string::npos) << behind.err;
        EXPECT_FALSE(std::filesystem::exists(path("behind")));
    }
    // A folder has the labels of one camera and of one record.
    const auto followed = [&](const std::string &number) {
        return claque({"labels", path("run.clt"), "--out", path("followed"), "--size", "96x72", "--frames", "10",
                       "--fps", "10", "--camera", "follow:" + number});
    };
    EXPECT_EQ(followed("1").code, 0);
    const Outcome second = followed("2");
    EXPECT_EQ(second.code, 1);
    EXPECT_NE(second.err.find("/tracks/follow is \"1\" there and \"2\" here"), std::string::npos) << second.err;
    std::filesystem::resize_file(path("run.clt"), std::filesystem::file_size(path("run.clt")) - 20);
    const Outcome other = seen("record", path("run.clt"), {});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("/record/sha256"), std::string::npos) << other.err;
}

TEST_F(LabelSubjects, ThatAreNothingAreNamed)
{
    Outcome outcome = label("none", {"plazza"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("plazza is no scene, and no file of that name exists; scenes are plaza, odeon,"),
              std::string::npos)
        << outcome.err;
    outcome = label("none", {"plaza"}, {"--rate", "10"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("--rate: is for a file of trajectories"), std::string::npos) << outcome.err;
    std::ofstream(path("person.glb")) << "glTF";
    outcome = label("none", {path("person.glb")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("person.glb is a character"), std::string::npos) << outcome.err;
    std::ofstream(path("person.FBX")) << "Kaydara FBX";
    outcome = label("none", {path("person.FBX")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("person.FBX is a character"), std::string::npos) << outcome.err;
    EXPECT_EQ(label("none", {"plaza", "--scene", "odeon"}).code, 2);
}

}  // namespace
}  // namespace cli_test
