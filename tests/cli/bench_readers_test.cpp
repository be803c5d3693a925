// claque bench readers with few elements: every format is read, and the table says what the measurements say.
#include <algorithm>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "samples/cli/reader_law.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;
using BenchReaders = Command;

#ifdef CLAQUE_STAGED
constexpr bool has_stage = true;
#else
constexpr bool has_stage = false;
#endif

// The word of elements that this build cannot read.
std::vector<std::string> unread()
{
    std::vector<std::string> out;
#ifndef CLAQUE_HAS_WEBP
    out.emplace_back("WebP");
#endif
#ifndef CLAQUE_HAS_EXPAT
    out.emplace_back("SUMO");
    out.emplace_back("JuPedSim");
#endif
    return out;
}

TEST_F(BenchReaders, ReadEveryFormat)
{
    const Outcome done = claque({"bench", "readers", "--count", "30", "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(done.out);
    EXPECT_EQ(report["most_ratio"], 16);
    std::set<std::string> formats, names;
    for (const Json &run : report["runs"]) {
        const std::string name = run["format"].get<std::string>() + " " + run["element"].get<std::string>();
        formats.insert(run["format"].get<std::string>());
        EXPECT_TRUE(names.insert(name).second) << name << " twice";
        EXPECT_EQ(run["count"], 30) << name;
        EXPECT_GT(run["bytes"], 30u) << name;
        bool is_read = true;
        for (const std::string &word : unread()) is_read = is_read && name.find(word) == std::string::npos;
        EXPECT_EQ(run["loaded"], is_read ? "ok" : "CLQ_UNSUPPORTED") << name;
        EXPECT_TRUE(run["built"] == "ok" || run["built"] == "-") << name << ": " << run["built"];
        EXPECT_TRUE(run["lawful"]) << name;
    }
    std::set<std::string> expected = {"BVH",      "JPEG",   "PNG",    "WebP",     "area", "colours",
                                      "glTF",     "joints", "npy",    "parity",   "path", "save",
                                      "prepared", "record", "tracks", "scenario", "zones"};
    if (has_stage) expected.insert({"machine", "stage"});
    EXPECT_EQ(formats, expected);
    EXPECT_GE(names.size(), has_stage ? 118u : 106u);
}

TEST_F(BenchReaders, PrintALineForEachElement)
{
    const Outcome done = claque({"bench", "readers", "--count", "10", "--save", path("r.json")});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json runs = Json::parse(file_text(path("r.json")))["runs"];
    std::istringstream lines(done.out);
    std::string line;
    std::getline(lines, line);
    for (const char *column : {"format", "element", "count", "bytes", "load ms", "ratio", "build ms"})
        EXPECT_NE(line.find(column), std::string::npos) << line;
    for (const Json &run : runs) {
        ASSERT_TRUE(std::getline(lines, line));
        EXPECT_EQ(line.rfind(run["format"].get<std::string>() + " ", 0), 0u) << line;
        EXPECT_NE(line.find(" " + run["element"].get<std::string>() + " "), std::string::npos) << line;
        EXPECT_NE(line.find(" " + run["bytes"].dump() + " "), std::string::npos) << line;
    }
    EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST_F(BenchReaders, EndWithOneAndNameWhatTakesMoreThanMayBe)
{
    const Outcome done = claque(
        {"bench", "readers", "--count", "300", "--most-ratio", "0.001", "--least-ms", "0", "--save", path("r.json")});
    EXPECT_EQ(done.code, 1);
    const Json report = Json::parse(file_text(path("r.json")));
    EXPECT_EQ(report["most_ratio"], 0.001);
    EXPECT_EQ(report["least_ms"], 0);
    const std::string begin = "claque: ten times the elements take too many times the time: ";
    ASSERT_EQ(done.err.rfind(begin, 0), 0u) << done.err;
    const std::string named = ", " + done.err.substr(begin.size());
    size_t unlawful = 0;
    for (const Json &run : report["runs"]) {
        const double most = std::max(run["load_ratio"].get<double>(), run["build_ratio"].get<double>());
        EXPECT_EQ(run["lawful"], most <= 0.001) << run;
        char numbers[100];
        std::snprintf(numbers, sizeof numbers, " (%.3g, at most 0.001)", most);
        const std::string name =
            ", " + run["format"].get<std::string>() + " " + run["element"].get<std::string>() + numbers;
        EXPECT_EQ(named.find(name) != std::string::npos, !run["lawful"].get<bool>()) << name;
        unlawful += !run["lawful"].get<bool>();
    }
    EXPECT_GE(2 * unlawful, report["runs"].size());
}

TEST_F(BenchReaders, AreAllThatIsJudged)
{
    for (const char *option : {"--most-ratio", "--least-ms"}) {
        const Outcome done = claque({"bench", "plaza", option, "2"});
        EXPECT_EQ(done.code, 2);
        EXPECT_NE(done.err.find(std::string(option) + ": judges readers alone"), std::string::npos) << done.err;
    }
    for (const char *ratio : {"0", "-1", "much"})
        EXPECT_EQ(claque({"bench", "readers", "--most-ratio", ratio}).code, 2) << ratio;
}

// What is said of times of reading, and of building from what was read.
bool holds(double few_ms, double many_ms, double build_ms = 0, const cli::readers::Law &law = {})
{
    const cli::Reading few = {few_ms, few_ms}, many = {many_ms, build_ms};
    return cli::readers::is_lawful(few, many, law);
}

TEST(LawOfReaders, AllowsSixteenTimesTheTimeForTenTimesTheElements)
{
    EXPECT_TRUE(holds(10, 160));
    EXPECT_FALSE(holds(10, 161));
    EXPECT_FALSE(holds(10, 30, 161)) << "what is built counts too";
    EXPECT_TRUE(holds(0.01, 19.9)) << "too short to be measured";
    EXPECT_FALSE(holds(0.01, 20));
    EXPECT_EQ(cli::readers::ratio(0.01, 20), 20) << "a millisecond is the least that a tenth takes";
    EXPECT_EQ(cli::readers::ratio(10, 160), 16);
}

TEST(LawOfReaders, IsAsStrictAsIsAskedFor)
{
    cli::readers::Law law;
    law.most_ratio = 8;
    EXPECT_TRUE(holds(10, 80, 0, law));
    EXPECT_FALSE(holds(10, 81, 0, law));
    EXPECT_TRUE(holds(1, 19, 0, law));
    law.least_ms = 10;
    EXPECT_FALSE(holds(1, 19, 0, law));
    EXPECT_TRUE(holds(1, 9.9, 0, law));
}

TEST(LawOfReaders, ABrokenOneFailsTheCommandAndIsNamed)
{
    const auto row = [](const char *element, bool lawful) {
        return nlohmann::ordered_json{{"format", "area"},    {"element", element},  {"lawful", lawful},
                                      {"load_ratio", 88.96}, {"build_ratio", 12.0}, {"most_ratio", 16.0}};
    };
    nlohmann::ordered_json report = {{"runs", nlohmann::ordered_json::array({row("points", true)})}};
    EXPECT_NO_THROW(cli::readers::expect_lawful(report));
    for (const char *element : {"holes", "obstacles"}) report["runs"].push_back(row(element, false));
    try {
        cli::readers::expect_lawful(report);
        ADD_FAILURE() << "nothing was said";
    } catch (const scenes::Failure &failure) {
        EXPECT_STREQ(failure.what(),
                     "ten times the elements take too many times the time: area holes (89, at most "
                     "16), area obstacles (89, at most 16)");
    }
}

}  // namespace
}  // namespace cli_test
