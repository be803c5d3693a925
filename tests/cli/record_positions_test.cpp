// The positions in a record leave it as files that other programs, and claque itself, read.
#include <claque/record.h>

#include <cmath>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "samples/scenes/check.h"
#include "samples/scenes/library.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using scenes::check;

struct Position {
    double x, y;
};
using ByPersonAndFrame = std::map<std::pair<unsigned, int>, Position>;

ByPersonAndFrame read_csv(const std::string &path)
{
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "id,frame,x,y");
    ByPersonAndFrame out;
    while (std::getline(in, line)) {
        unsigned id = 0;
        int frame = 0;
        Position at = {};
        EXPECT_EQ(std::sscanf(line.c_str(), "%u,%d,%lf,%lf", &id, &frame, &at.x, &at.y), 4) << line;
        EXPECT_TRUE(out.emplace(std::make_pair(id, frame), at).second) << line;
    }
    return out;
}

class RecordPositions : public Command
{
protected:
    // Person 1 moves east at 2 m/s for four seconds; person 2 stands to the south and is gone after a second. Another
    // has the number of person 2 from the third second on.
    void record() const
    {
        scenes::Library library(1);
        const clq_crowd_def def = clq_crowd_def_init();
        clq_crowd *made = nullptr;
        check(clq_crowd_create(library.context(), &def, &made));
        const scenes::Own<clq_crowd> crowd(made);
        std::ofstream file(path("run.clt"), std::ios::binary);
        clq_recording_def writing = clq_recording_def_init();
        writing.write = [](void *out, const void *bytes, size_t size) {
            return static_cast<std::ofstream *>(out)->write(static_cast<const char *>(bytes), std::streamsize(size))
                       ? 0
                       : 1;
        };
        writing.user = &file;
        check(clq_crowd_begin_recording(made, &writing));
        const auto add = [&](double x, double z) {
            clq_actor_def actor = clq_actor_def_init();
            actor.tmpl = library.builtin("citizen");
            actor.transform.position[0] = x, actor.transform.position[2] = z;
            clq_actor out;
            check(clq_actor_create(made, &actor, &out));
            return out;
        };
        const clq_actor walker = add(-1, 0), first = add(3, 5);
        clq_actor second = {};
        for (int step = 0; step <= 40; ++step) {
            clq_transform at = clq_transform_init();
            at.position[0] = -1 + 0.2 * step;
            check(clq_crowd_set_transforms(made, &walker, &at, 1));
            if (step == 10) check(clq_actor_destroy(made, first));
            if (step == 30) second = add(-7, -2.5);
            check(clq_crowd_update(made, 0.1 * step, nullptr, 0));
        }
        ASSERT_EQ(second.index1, first.index1) << "the number is used again";
        check(clq_crowd_end_recording(made, nullptr));
    }
    Outcome write(const std::string &name, const std::vector<std::string> &more = {}) const
    {
        std::vector<std::string> words = {"tracks", path("run.clt"), "--out", path(name)};
        words.insert(words.end(), more.begin(), more.end());
        return claque(words);
    }
};

TEST_F(RecordPositions, AreThoseOfThePeopleShownByNumberAndFrame)
{
    record();
    const Outcome outcome = write("run.csv", {"--rate", "10"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const ByPersonAndFrame found = read_csv(path("run.csv"));
    ByPersonAndFrame expected;
    for (int frame = 0; frame <= 40; ++frame) {
        expected[{1, frame}] = {-1 + 0.2 * frame, 0};
        if (frame < 10) expected[{2, frame}] = {3, -5};
        if (frame >= 30) expected[{3, frame}] = {-7, 2.5};
    }
    ASSERT_EQ(found.size(), expected.size());
    for (const auto &[key, at] : expected) {
        const auto here = found.find(key);
        ASSERT_NE(here, found.end()) << key.first << " at " << key.second;
        EXPECT_NEAR(here->second.x, at.x, 1e-4) << key.first << " at " << key.second;
        EXPECT_NEAR(here->second.y, at.y, 1e-4) << key.first << " at " << key.second;
    }
    // Without --rate there are 25 a second, and north is up: y ascends as z goes down.
    ASSERT_EQ(write("usual.csv").code, 0);
    EXPECT_EQ(read_csv(path("usual.csv")).rbegin()->first.second, 100);
}

TEST_F(RecordPositions, AreReadAgainFromEachFormatAsTheyWereWritten)
{
    record();
    nlohmann::json reports[3];
    const std::vector<std::string> names = {"run.csv", "run.txt", "run.sqlite"};
    for (size_t i = 0; i < names.size(); ++i) {
        const Outcome written = write(names[i], {"--json", path("report.json")});
        ASSERT_EQ(written.code, 0) << written.err;
        std::vector<std::string> words = {"tracks", path(names[i]), "--json", "-"};
        if (i == 0) words.insert(words.end(), {"--columns", "id,frame,x,y", "--rate", "25", "--unit", "m"});
        const Outcome read = claque(words);
        ASSERT_EQ(read.code, 0) << read.err;
        reports[i] = nlohmann::json::parse(read.out);
        nlohmann::json of_record = nlohmann::json::parse(file_text(path("report.json")));
        of_record.erase("file"), reports[i].erase("file");
        EXPECT_EQ(reports[i].dump(), of_record.dump()) << names[i];
    }
    EXPECT_EQ(reports[0]["people"], 3);
    EXPECT_EQ(reports[0]["samples"], 101 + 25 + 26);
    const Outcome area = claque({"play", path("run.sqlite"), "--ground", path("run.sqlite"), "--time", "1", "--size",
                                 "32x24", "--out", path("p.png")});
    if (why_no_context("any").empty()) EXPECT_EQ(area.code, 0) << area.err;
}

TEST_F(RecordPositions, AreRefusedWhereTheNameOrTheFileIsOfAnotherKind)
{
    record();
    const Outcome ending = write("run.xyz");
    EXPECT_NE(ending.code, 0);
    EXPECT_NE(ending.err.find("ends in none of .csv, .txt and .sqlite"), std::string::npos) << ending.err;
    const Outcome columns = write("run.csv", {"--columns", "id,frame,x,y"});
    EXPECT_NE(columns.code, 0);
    EXPECT_NE(columns.err.find("FILE is a record"), std::string::npos) << columns.err;
    std::ofstream(path("people.csv")) << "id,frame,x,y\n1,0,0,0\n1,1,1,0\n";
    const Outcome table = claque({"tracks", path("people.csv"), "--columns", "id,frame,x,y", "--rate", "1", "--unit",
                                  "m", "--out", path("run.csv")});
    EXPECT_NE(table.code, 0);
    EXPECT_NE(table.err.find("FILE is no record"), std::string::npos) << table.err;
    EXPECT_EQ(left(), (std::vector<std::string>{"people.csv", "run.clt"}));
}

}  // namespace
}  // namespace cli_test
