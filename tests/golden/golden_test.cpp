// Compares the scenes with accepted pictures, pixel for pixel. Thresholds are zero: the bits of softpipe and of claque
// do not depend on the processor. Another Mesa may round differently, so the pictures belong to the Mesa named in
// mesa.txt.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests/golden/picture.h"

namespace
{

const struct Golden {
    const char *name;
    const char *arguments;
} goldens[] = {
    {"plaza", "--scene plaza --count 400 --size 320x240 --time 1.5"},
    {"plaza-close", "--scene plaza --count 400 --camera close --size 320x240 --time 1.5"},
    {"odeon", "--scene odeon --size 320x240 --time 1.5"},
    {"odeon-close", "--scene odeon --camera close --size 320x240 --time 1.5"},
};

// The name that CTest shows for a case.
void PrintTo(const Golden &golden, std::ostream *out) { *out << golden.name; }

std::string text_of(const std::string &path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

// Renders and returns the JSON's description of the context; empty without software GL.
std::string render(const Golden &golden, const std::string &picture)
{
    const std::string json = std::string(OUTPUT_DIR) + "/" + golden.name + ".json";
    std::remove(picture.c_str());
    std::remove(json.c_str());
    const std::string command =
        std::string(CLAQUE_COMMAND) + " render " + golden.arguments + " --out " + picture + " --json " + json;
    return std::system(command.c_str()) == 0 ? text_of(json) : "";
}

class GoldenPicture : public testing::TestWithParam<Golden>
{
};

}  // namespace

TEST_P(GoldenPicture, IsAsItWasAccepted)
{
    const Golden &golden = GetParam();
    const std::string actual_path = std::string(OUTPUT_DIR) + "/" + golden.name + "-actual.png";
    const std::string json = render(golden, actual_path);
    if (json.empty()) GTEST_SKIP() << "nothing could be rendered here: no software GL";
    std::string mesa = text_of(std::string(GOLDEN_DIR) + "/mesa.txt");
    mesa = mesa.substr(0, mesa.find('\n'));
    ASSERT_FALSE(mesa.empty());
    if (json.find(mesa) == std::string::npos || json.find("softpipe") == std::string::npos)
        GTEST_SKIP() << "the stored pictures are those of softpipe of " << mesa;
    const Picture expected = read_picture(std::string(GOLDEN_DIR) + "/" + golden.name + ".png");
    const Picture actual = read_picture(actual_path);
    ASSERT_FALSE(expected.rgb.empty()) << golden.name << ".png is missing";
    const Difference difference = compare(expected, actual);
    if (difference.pixels)
        write_difference(std::string(OUTPUT_DIR) + "/" + golden.name + "-difference.pgm", expected, actual);
    EXPECT_EQ(difference.pixels, 0u) << "largest difference " << difference.most << "; see " << actual_path
                                     << ". If the change is meant: make golden-accept";
}

INSTANTIATE_TEST_SUITE_P(scenes, GoldenPicture, testing::ValuesIn(goldens), [](const auto &golden) {
    std::string name = golden.param.name;
    for (char &c : name) c = c == '-' ? '_' : c;
    return name;
});

TEST(Comparator, SeesOnePixelOfOneStep)
{
    Picture a;
    a.width = 4, a.height = 3;
    a.rgb.assign(36, 100);
    Picture b = a;
    EXPECT_EQ(compare(a, b).pixels, 0u);
    b.rgb[17] = 101;
    EXPECT_EQ(compare(a, b).pixels, 1u);
    EXPECT_EQ(compare(a, b).most, 1);
    b.width = 3, b.height = 4;
    EXPECT_EQ(compare(a, b).pixels, 12u);
    EXPECT_GT(compare(Picture(), Picture()).pixels, 0u)
        << "two missing pictures are not equal: a missing picture fails";
}
