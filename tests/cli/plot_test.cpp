// claque plot on line charts, as SVG and as PNG; tests/cli/odeon_test.cpp plots the output of bench.
#include <algorithm>
#include <fstream>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

constexpr const char *growth = R"({"kind": "lines", "title": "Growth & more", "x": {"title": "actors", "scale": "log"},
    "y": {"title": "ms"}, "series": [{"name": "actor", "points": [[100, 1], [10000, 3]]},
    {"name": "traditional", "points": [[100, 2], [10000, 40]], "dash": "dashed"}], "note": "below is better"})";

class Plot : public Command
{
protected:
    Outcome plot(const std::string &text, const std::string &out) const
    {
        std::ofstream(path("in.json"), std::ios::trunc) << text;
        return claque({"plot", path("in.json"), "--out", out == "-" ? out : path(out)});
    }
};

TEST_F(Plot, LinesBecomeSvg)
{
    const Outcome done = plot(growth, "-");
    EXPECT_EQ(done.code, 0) << done.err;
    for (const char *words : {"<svg", "Growth &amp; more", "actors", "ms", "traditional", "below is better",
                              "1\u00a0000", "stroke-dasharray"})
        EXPECT_NE(done.out.find(words), std::string::npos) << words;
    EXPECT_EQ(plot(growth, "a.svg").code, 0);
    EXPECT_EQ(file_text(path("a.svg")), done.out);
}

TEST_F(Plot, WhatIsNestedTooDeepIsRefused)
{
    const Outcome done = plot("{\"kind\": " + std::string(300000, '[') + std::string(300000, ']') + "}", "-");
    EXPECT_EQ(done.code, 1);
    EXPECT_NE(done.err.find("nested more than 64 deep"), std::string::npos) << done.err;
}

TEST_F(Plot, LinesBecomePngWithTheirColoursAndTheSameBytesTwice)
{
    EXPECT_EQ(plot(growth, "a.png").err, "");
    EXPECT_EQ(plot(growth, "b.png").code, 0);
    EXPECT_EQ(file_text(path("a.png")), file_text(path("b.png")));
    const Picture picture = picture_of(path("a.png"));
    ASSERT_EQ(picture.width, 1920);
    EXPECT_GT(picture.count_of({0x2f, 0x80, 0xc9}), 3000);
    EXPECT_GT(picture.count_of({0xe0, 0x8a, 0x1e}), 2000);
    EXPECT_GT(picture.count_of({255, 255, 255}), picture.width * picture.height / 2);
    EXPECT_EQ(left(), (std::vector<std::string>{"a.png", "b.png", "in.json"})) << "no part is left behind";
}

TEST_F(Plot, AnOlderPictureStaysWhenANewOneFails)
{
    std::ofstream(path("a.png")) << "old";
    EXPECT_EQ(plot(R"({"kind": "lines", "title": "t", "series": []})", "a.png").code, 1);
    EXPECT_EQ(file_text(path("a.png")), "old");
}

TEST_F(Plot, OtherFilesAreRefusedInOneSentence)
{
    for (const auto &[text, said] : std::vector<std::pair<std::string, std::string>>{
             {R"({"kind": "pie"})", "'kind' is not 'lines'"},
             {R"({"kind": "lines", "title": "t", "series": [{"name": "a", "points": [[2, 1], [1, 1]]}]})",
              "series 1: point 2 lies left of the one before it"},
             {"[]", "lacks 'scene'"},
         }) {
        const Outcome outcome = plot(text, "a.png");
        EXPECT_EQ(outcome.code, 1) << text;
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(left(), std::vector<std::string>{"in.json"});
}

}  // namespace
}  // namespace cli_test
