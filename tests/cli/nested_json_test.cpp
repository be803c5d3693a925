// JSON that the command reads again, nested 300 000 deep. Values are copied, compared and freed by recursion, so that a
// limit of their depth has to come first.
#include <fstream>

#include <nlohmann/json.hpp>

#include "samples/cli/message.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

const std::string nested = std::string(300000, '[') + std::string(300000, ']');

class NestedJson : public Drawing
{
};

TEST_F(NestedJson, IsNoManifest)
{
    std::ofstream(path("m.json")) << R"({"claque_manifest": 1, "about": {"scene": )" << nested
                                  << R"(}, "asked": "0", "frames": []})";
    const std::string before = file_text(path("m.json"));
    const Outcome checked = claque({"frames", "check", path(".")});
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.err.find("has no manifest"), std::string::npos) << checked.err;
    const Outcome drawn = claque({"render", "--scene", "plaza", "--count", "2", "--size", "16x12", "--frames", "0:1",
                                  "--threads", "1", "--out", path("f-%03d.png"), "--manifest", path("m.json")});
    EXPECT_EQ(drawn.code, 1);
    EXPECT_NE(drawn.err.find("is there and is no manifest"), std::string::npos) << drawn.err;
    EXPECT_EQ(file_text(path("m.json")), before);
}

TEST_F(NestedJson, IsNoLabelAndNoSettingOfLabels)
{
    const auto label = [&] {
        return claque({"labels", "--scene", "plaza", "--count", "2", "--size", "16x12", "--out", path("labels"),
                       "--frames", "0:1"});
    };
    ASSERT_EQ(label().code, 0);
    const auto whole = contents("labels");
    for (const char *file : {"settings.json", "frames/000000.json"}) {
        ASSERT_EQ(whole.count(file), 1u) << file;
        std::ofstream(path("labels") + "/" + file) << R"({"frame": 0, "settings": )" << nested << "}";
    }
    const Outcome again = label();
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(contents("labels") == whole);
}

TEST(NestedJsonMessage, IsRefusedWithASentence)
{
    using Json = nlohmann::ordered_json;
    for (const std::string &text : {nested, R"({"report": )" + nested + "}", std::string("no JSON")}) {
        std::string refusal;
        try {
            cli::message_of<Json>(text);
        } catch (const scenes::Failure &failure) {
            refusal = failure.what();
        }
        const char *reason = text[0] == 'n' ? "is not JSON" : "is nested more than 64 deep";
        EXPECT_EQ(refusal, std::string("what one process of a team told another ") + reason);
    }
    EXPECT_EQ(cli::message_of<Json>(R"({"at": [[1]]})")["at"][0][0], 1);
}

}  // namespace
}  // namespace cli_test
