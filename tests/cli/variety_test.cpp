// variety: colourings of one template beside the content of its texture.
#include <fstream>
#include <set>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Variety = Drawing;
using VarietyUsage = Command;

// A raw picture as pixels.
struct RawPicture {
    size_t width, height;
    std::string rgb;

    std::string pixel(size_t x, size_t y) const { return rgb.substr(3 * (y * width + x), 3); }
    std::string block(size_t x, size_t y, size_t w, size_t h) const
    {
        std::string bytes;
        for (size_t row = y; row < y + h; ++row) bytes += rgb.substr(3 * (row * width + x), 3 * w);
        return bytes;
    }
};

RawPicture draw(std::vector<std::string> arguments, size_t width, size_t height)
{
    arguments.insert(arguments.begin(), "variety");
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    for (const char *more : {"--size", size.c_str(), "--out", "-"}) arguments.push_back(more);
    const Outcome outcome = claque(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.size(), 3 * width * height);
    return {width, height, outcome.out};
}

TEST_F(Variety, ThePictureIsAPngOfTheSizeThatWasAskedFor)
{
    const Outcome outcome = claque({"variety", "citizen", "--size", "400x260", "--out", path("v.png")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string png = file_text(path("v.png"));
    ASSERT_GT(png.size(), 5000u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 400);
    EXPECT_EQ(static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]), 260);
    EXPECT_NE(png.find("citizen"), std::string::npos);
    EXPECT_EQ(left(), (std::vector<std::string>{"v.png"}));
}

// Above left the grey texture, below it the zone map in a few flat colours; the citizen has eight zones.
TEST_F(Variety, LeftIsTheGreyTextureAndBelowItTheZoneMap)
{
    const RawPicture p = draw({"citizen"}, 640, 400);
    std::set<std::string> colours;
    for (size_t y = 24; y < 120; ++y)
        for (size_t x = 24; x < 140; ++x) {
            const std::string light = p.pixel(x, y);
            ASSERT_TRUE(light[0] == light[1] && light[1] == light[2]) << x << ' ' << y;
        }
    for (size_t y = 180; y < 300; ++y)
        for (size_t x = 24; x < 140; ++x) colours.insert(p.pixel(x, y));
    EXPECT_GE(colours.size(), 6u);
    EXPECT_LE(colours.size(), 10u);
}

TEST_F(Variety, TheSameSeedGivesTheSameIndividualsAndAnotherSeedOthers)
{
    const RawPicture one = draw({"plebeian", "--count", "6"}, 480, 300);
    EXPECT_TRUE(draw({"plebeian", "--count", "6"}, 480, 300).rgb == one.rgb);
    const RawPicture other = draw({"plebeian", "--count", "6", "--seed", "2"}, 480, 300);
    EXPECT_FALSE(other.rgb == one.rgb);
    EXPECT_TRUE(other.block(0, 0, 120, 300) == one.block(0, 0, 120, 300)) << "texture and map have no seed";
}

// Each tile has the same pixels of background and other colours on the same character.
TEST_F(Variety, PeopleStandTheSameAndDifferInColours)
{
    const RawPicture p = draw({"patrician", "--count", "4"}, 900, 320);
    std::set<std::string> tiles;
    size_t moved = 0, width = 0;
    const size_t left = 16 * 2 + (320 - 64) * 2 / 5, room = 900 - 16 - left;
    width = (room + 2) / 4 - 2;
    const std::string first = p.block(left, 16, width, 288);
    for (size_t i = 0; i < 4; ++i) {
        const std::string tile = p.block(left + i * (width + 2), 16, width, 288);
        tiles.insert(tile);
        for (size_t corner : {size_t(0), 3 * width - 3, tile.size() - 3 * width, tile.size() - 3})
            moved += tile.substr(corner, 3) != first.substr(corner, 3);
    }
    EXPECT_EQ(moved, 0u);
    EXPECT_EQ(tiles.size(), 4u);
}

TEST_F(Variety, PreparedFilesAreDrawnToo)
{
    ASSERT_EQ(claque({"prepare", "citizen", "--out", path("c.clq")}).code, 0);
    EXPECT_EQ(draw({path("c.clq"), "--count", "2"}, 300, 200).rgb.size(), 180000u);
}

TEST_F(VarietyUsage, WhatCannotBeDoneIsOneSentence)
{
    std::ofstream(path("text.glb")) << "this is no character";
    const struct {
        std::vector<std::string> arguments;
        int code;
        std::string says;
    } cases[] = {
        {{"centurion", "--out", path("a.png")}, 1, "centurion"},
        {{path("none.glb"), "--out", path("a.png")}, 1, "none.glb"},
        {{path("text.glb"), "--out", path("a.png")}, 1, "text.glb"},
        {{"citizen", "--out", path("no/folder/a.png")}, 1, "no/folder"},
        {{"citizen", "--texture", "3", "--out", path("a.png")}, 1, "texture 3"},
        {{"citizen", "--count", "0", "--out", path("a.png")}, 2, "--count"},
        {{"citizen", "--size", "12", "--out", path("a.png")}, 2, "12"},
        {{"citizen"}, 2, "--out"},
    };
    for (const auto &c : cases) {
        std::vector<std::string> arguments = c.arguments;
        arguments.insert(arguments.begin(), "variety");
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, c.code) << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
        if (c.code == 1) {
            EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
        }
    }
    EXPECT_EQ(left(), (std::vector<std::string>{"text.glb"}));
}

TEST_F(Variety, TooManyPeopleAreRefusedByTheirNumber)
{
    const Outcome outcome = claque({"variety", "citizen", "--count", "300", "--size", "90x60", "--out", path("a.png")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("300 people do not fit into a picture of 90 x 60"), std::string::npos) << outcome.err;
    EXPECT_TRUE(left().empty());
}

}  // namespace
}  // namespace cli_test
