// claque parity compare as a script runs it: exit codes, one clear line each, its files.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;

class ParityCompare : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        if (IsSkipped()) return;
        for (const char *name : {"reference", "yours"}) {
            const Outcome done =
                claque({"parity", "capture", "citizen", "--count", "3", "--size", "160x120", "--out", path(name)});
            ASSERT_EQ(done.code, 0) << done.err;
        }
    }
    Outcome compare(std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(), {"parity", "compare", path("reference"), path("yours")});
        return claque(more);
    }
    void overwrite(const std::string &file, size_t at, const std::string &bytes) const
    {
        std::fstream out(path(file), std::ios::in | std::ios::out | std::ios::binary);
        out.seekp(static_cast<std::streamoff>(at));
        out << bytes;
    }
};

bool one_line(const std::string &text) { return !text.empty() && text.find('\n') == text.size() - 1; }

TEST_F(ParityCompare, TwoCapturesOfOneTimeAreEqual)
{
    const Outcome done = compare({"--tolerance", "exact", "--json", path("r.json"), "--html", path("r.html")});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    EXPECT_NE(done.out.find("yours passes exact: 12 limits kept\n"), std::string::npos) << done.out;
    const Json json = Json::parse(file_text(path("r.json")));
    EXPECT_EQ(json["verdict"], "pass");
    EXPECT_EQ(json["not_compared"].size(), 0u);
    const std::string page = file_text(path("r.html"));
    size_t pictures = 0;
    for (size_t at = 0; (at = page.find("data:image/png;base64,iVBORw0KGgo", at)) != std::string::npos; ++at)
        ++pictures;
    EXPECT_EQ(pictures, 7u);
    EXPECT_EQ(compare({"--tolerance", "exact", "--json", "-"}).out, file_text(path("r.json")));
}

TEST_F(ParityCompare, DifferencesBeyondTheToleranceFailInOneLine)
{
    overwrite("yours/colour.npy", 128 + 3 * 160 * 40, std::string(3 * 160 * 40, '\xff'));  // 40 lines white
    const Outcome done = compare({"--json", path("r.json")});
    EXPECT_EQ(done.code, 1);
    EXPECT_TRUE(one_line(done.err)) << done.err;
    EXPECT_NE(done.err.find("yours fails gpu: colour.over_2 is "), std::string::npos) << done.err;
    EXPECT_EQ(Json::parse(file_text(path("r.json")))["verdict"], "fail");
    std::ofstream(path("mine.toml")) << "require = ['colour']\n[at_most]\ncolour.over_8 = 1\n";
    EXPECT_EQ(compare({"--tolerance", path("mine.toml")}).code, 0);
}

TEST_F(ParityCompare, FoldersThatCannotBeComparedAreRefusedInOneLine)
{
    const auto refused = [this](const std::vector<std::string> &more, const std::string &sentence) {
        const Outcome done = compare(more);
        EXPECT_EQ(done.code, 2);
        EXPECT_TRUE(one_line(done.err)) << done.err;
        EXPECT_NE(done.err.find(sentence), std::string::npos) << done.err;
        EXPECT_EQ(done.out, "");
    };
    refused({"--tolerance", "fine"},
            "there is no tolerance and no file 'fine'; tolerances are exact, gpu, coarse, loose.");
    std::ofstream(path("mine.toml")) << "[at_most]\ncolours = 1\n";
    refused({"--tolerance", path("mine.toml")}, "mine.toml, line 2: there is no measure 'colours'.");
    overwrite("yours/depth.npy", 0, "PK");
    refused({}, "yours/depth.npy is not a NumPy array: it does not begin as one.");
    std::ofstream(path("yours/capture.json")) << "{";
    refused({}, "yours/capture.json is not JSON.");
    std::ofstream(path("yours/capture.json"))
        << "{\"scene\": " << std::string(300000, '[') << std::string(300000, ']') << "}";
    refused({}, "yours/capture.json is nested more than 64 deep.");
    std::filesystem::remove_all(path("yours"));
    refused({}, "yours is not a folder.");
}

TEST_F(ParityCompare, CapturesOfDifferentTimesAreNotCompared)
{
    const Outcome later = claque(
        {"parity", "capture", "citizen", "--count", "3", "--size", "160x120", "--time", "3", "--out", path("yours")});
    ASSERT_EQ(later.code, 0) << later.err;
    const Outcome done = compare();
    EXPECT_EQ(done.code, 2);
    EXPECT_NE(done.err.find("yours shows the time 3 s, and "), std::string::npos) << done.err;
}

TEST(ParityCompareUsage, IsChecked)
{
    EXPECT_EQ(claque({"parity"}).code, 2);
    EXPECT_EQ(claque({"parity", "compare", "one"}).code, 2);
    EXPECT_EQ(claque({"parity", "compare", "a", "b", "--pixels-per-degree", "1"}).code, 2);
}

}  // namespace
}  // namespace cli_test
