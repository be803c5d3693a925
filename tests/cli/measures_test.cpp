// Density, speed, least distance and crossings that `claque tracks --measure` writes, against sums over all people.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

constexpr double rate_hz = 10;

struct Place {
    double x, y;
};
using Way = std::map<int, Place>;  // by frame

// Two people pass the line x = 0 two seconds after each other, a third passes it, turns and comes back, and a fourth
// passes beside its end.
std::map<std::string, Way> ways()
{
    std::map<std::string, Way> out;
    for (int frame = 0; frame <= 60; ++frame) {
        out["ahead"][frame] = {-3.05 + 0.1 * frame, 0};
        out["behind"][frame + 20] = {-3.05 + 0.1 * frame, 0.5};
        if (frame <= 42) out["turns"][frame] = {-1.05 + 0.1 * std::abs(21 - frame), -0.75};
        out["beside"][frame] = {-3.05 + 0.1 * frame, 5};
    }
    return out;
}

bool is_inside(Place p) { return std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1; }

// Between the samples farthest away within a quarter of a second on either side.
double speed_at(const Way &way, int frame)
{
    int before = frame, after = frame;
    for (const auto &[other, place] : way) {
        (void)place;
        if (other < before && frame - other <= 2) before = other;
        if (other > after && other - frame <= 2) after = other;
    }
    const Place a = way.at(before), b = way.at(after);
    return std::hypot(b.x - a.x, b.y - a.y) / (after - before) * rate_hz;
}

std::vector<std::string> fields_of(const std::string &line)
{
    std::vector<std::string> out(1);
    for (const char c : line)
        if (c == ',') out.emplace_back();
        else out.back() += c;
    return out;
}

class Measures : public Command
{
protected:
    Measures()
    {
        std::ofstream out(path("ways.csv"));
        out << "id,frame,x,y\n";
        for (const auto &[id, way] : ways())
            for (const auto &[frame, place] : way)
                out << id << ',' << frame << ',' << place.x << ',' << place.y << '\n';
    }
    Outcome tracks(const std::vector<std::string> &more) const
    {
        std::vector<std::string> words = {"tracks", path("ways.csv"), "--columns", "id,frame,x,y", "--rate",
                                          "10",     "--unit",         "m"};
        words.insert(words.end(), more.begin(), more.end());
        return claque(words);
    }
    const std::vector<std::string> line_ = {"--line", "0,-1,0,1"}, area_ = {"--area", "-1,-1,1,1"};
};

TEST_F(Measures, FollowTheDefinitionsAtEachStep)
{
    const Outcome outcome = tracks({"--measure", path("m.csv"), line_[0], line_[1], area_[0] + "=" + area_[1]});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream rows(file_text(path("m.csv")));
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row, "time_s,people,inside,density_per_m2,speed_m_s,nearest_m,crossed");
    const std::map<std::string, Way> all = ways();
    for (int frame = 0; frame <= 80; ++frame) {
        ASSERT_TRUE(std::getline(rows, row)) << frame;
        const std::vector<std::string> found = fields_of(row);
        ASSERT_EQ(found.size(), 7u) << row;
        unsigned people = 0, inside = 0;
        double speeds = 0, nearest = HUGE_VAL;
        for (const auto &[id, way] : all) {
            const auto here = way.find(frame);
            if (here == way.end()) continue;
            ++people;
            if (is_inside(here->second)) ++inside, speeds += speed_at(way, frame);
            for (const auto &[other_id, other] : all)
                if (other_id != id && other.count(frame))
                    nearest = std::min(
                        nearest, std::hypot(other.at(frame).x - here->second.x, other.at(frame).y - here->second.y));
        }
        EXPECT_NEAR(std::stod(found[0]), frame / rate_hz, 1e-4);
        EXPECT_EQ(std::stoul(found[1]), people) << row;
        EXPECT_EQ(std::stoul(found[2]), inside) << row;
        EXPECT_NEAR(std::stod(found[3]), inside / 4.0, 1e-4) << row;
        if (inside == 0) EXPECT_EQ(found[4], "") << row;
        else EXPECT_NEAR(std::stod(found[4]), speeds / inside, 1e-3) << row;
        if (people < 2) EXPECT_EQ(found[5], "") << row;
        else EXPECT_NEAR(std::stod(found[5]), nearest, 1e-3) << row;
        // "turns" passes before frame 11 and comes back, "ahead" before 31, "behind" before 51.
        EXPECT_EQ(found[6], std::to_string((frame >= 11) + (frame >= 31) + (frame >= 51))) << row;
    }
    EXPECT_FALSE(std::getline(rows, row)) << row;
    EXPECT_NE(outcome.out.find("3 crossed the line, 0.500 a second from 1.10 to 5.10 s"), std::string::npos)
        << outcome.out;
}

TEST_F(Measures, AreEqualForARectangleAndItsWalkableArea)
{
    std::ofstream(path("square.wkt")) << "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))";
    ASSERT_EQ(tracks({"--measure", path("a.csv"), area_[0] + "=" + area_[1]}).code, 0);
    const Outcome of_file = tracks({"--measure", path("b.csv"), "--area", path("square.wkt")});
    ASSERT_EQ(of_file.code, 0) << of_file.err;
    EXPECT_EQ(file_text(path("a.csv")), file_text(path("b.csv")));
    EXPECT_NE(file_text(path("a.csv")).find(",\n"), std::string::npos) << "without a line, crossings are empty";
}

TEST_F(Measures, DrawCrossingsOverTime)
{
    const Outcome outcome = tracks({"--measure", path("n.svg"), "--measure", path("n.csv"), "--line", "0,1,0,-1"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(file_text(path("n.svg")).find("0.500 people a second"), std::string::npos);
    EXPECT_NE(file_text(path("n.svg")).find("ways.csv, the line from (0, 1) to (0, -1)"), std::string::npos);
    EXPECT_NE(outcome.out.find("3 crossed the line"), std::string::npos) << outcome.out << "either way counts";
}

TEST_F(Measures, AreInTheReport)
{
    const Outcome outcome =
        tracks({"--measure", path("m.csv"), line_[0], line_[1], area_[0] + "=" + area_[1], "--json", "-"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json found = nlohmann::json::parse(outcome.out)["measures"];
    EXPECT_EQ(found["crossed"], 3);
    EXPECT_NEAR(found["flow_per_s"].get<double>(), 0.5, 1e-9);
    EXPECT_NEAR(found["first_s"].get<double>(), 1.1, 1e-9);
    EXPECT_NEAR(found["last_s"].get<double>(), 5.1, 1e-9);
    EXPECT_EQ(found["area_m2"], 4);
    EXPECT_EQ(found["line"], nlohmann::json({{0, -1}, {0, 1}}));
    const Outcome bare = tracks({"--measure", path("m.csv"), "--json", "-"});
    const nlohmann::json without = nlohmann::json::parse(bare.out)["measures"];
    for (const char *name : {"crossed", "line", "area_m2", "most_per_m2", "first_s", "flow_per_s"})
        EXPECT_TRUE(without.contains(name) && without[name].is_null()) << name;
    EXPECT_EQ(without["nearest_m"], found["nearest_m"]);
    const Outcome none = tracks({"--json", "-"});
    EXPECT_FALSE(nlohmann::json::parse(none.out).contains("measures"));
}

TEST_F(Measures, GoToStandardOutput)
{
    const Outcome outcome = tracks({"--measure", "-", "--measure", path("m.csv"), line_[0], line_[1]});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, file_text(path("m.csv")));
    const Outcome both = tracks({"--measure", "-", "--json", "-"});
    EXPECT_EQ(both.code, 2);
    EXPECT_NE(both.err.find("standard output takes one of the files named -"), std::string::npos) << both.err;
    EXPECT_EQ(both.out, "");
}

TEST_F(Measures, RefuseWrongLinesAreasAndFiles)
{
    const auto refused = [&](const std::vector<std::string> &more, const std::string &why) {
        const Outcome outcome = tracks(more);
        EXPECT_NE(outcome.code, 0) << why;
        EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    };
    refused({"--measure", path("m.txt")}, "m.txt ends in none of .csv, .svg and .png");
    refused({"--measure", path("m.svg")}, "m.svg shows crossings of a line: --line says which");
    refused({"--measure", path("m.csv"), "--line", "0,0,1"}, "'0,0,1' is no line");
    refused({"--measure", path("m.csv"), "--line", "2,3,2,3"}, "'2,3,2,3' has no length");
    refused({"--measure", path("m.csv"), "--area", "1,1,2"}, "'1,1,2' is no rectangle");
    refused({"--measure", path("m.csv"), "--area", "0,0,0,1"}, "'0,0,0,1' has no size");
    refused({"--measure", path("m.csv"), "--area", path("none.wkt")}, "none.wkt");
    refused({"--line", "0,0,1,1"}, "--line requires --measure");
    EXPECT_EQ(left(), std::vector<std::string>{"ways.csv"});
}

}  // namespace
}  // namespace cli_test
