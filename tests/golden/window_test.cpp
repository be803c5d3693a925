// Compares the window of claque view with an accepted picture, pixel for pixel, drawn by softpipe. Panels are drawn by
// Dear ImGui: another one draws others, and another Mesa rounds edges differently, so neither is compared. The edges of
// ImGui's lines may differ by one step of 255 in a few pixels: it takes their normals from the instruction rsqrtss,
// whose last bits differ between makers of processors (104 pixels between an Intel and an AMD processor).
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/gl/support/absent.h"
#include "tests/golden/picture.h"

namespace
{

std::string first_line_of(const std::string &path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

TEST(GoldenWindow, IsAsItWasAccepted)
{
    if (const std::string absent = gltest::absent_gl(contexts::Kind::any); !absent.empty()) GTEST_SKIP() << absent;
    const std::string imgui = first_line_of(GOLDEN_DIR "/imgui.txt"), here = "Dear ImGui " IMGUI_VERSION;
    if (imgui != here) GTEST_SKIP() << "the picture is of " << imgui << ", and this is " << here;
    const std::string json = OUTPUT_DIR "/window.json", actual_path = OUTPUT_DIR "/window.png";
    std::remove(json.c_str());
    std::remove(actual_path.c_str());
    const int status =
        std::system("GALLIUM_DRIVER=softpipe " CLAQUE_COMMAND " view " CLAQUE_WINDOW_ARGUMENTS " --script " GOLDEN_DIR
                    "/window.toml --shots " OUTPUT_DIR " --rates " OUTPUT_DIR "/window.json");
    ASSERT_EQ(status, 0) << "claque view failed";
    std::stringstream about;
    about << std::ifstream(json).rdbuf();
    ASSERT_NE(about.str().find("softpipe"), std::string::npos) << about.str();
    const std::string mesa = first_line_of(GOLDEN_DIR "/mesa.txt");
    ASSERT_FALSE(mesa.empty());
    if (about.str().find(mesa) == std::string::npos)
        GTEST_SKIP() << "the picture is of " << mesa << ": " << about.str();
    const Picture expected = read_picture(GOLDEN_DIR "/window.png"), actual = read_picture(actual_path);
    const Difference difference = compare(expected, actual);
    if (difference.pixels) write_difference(OUTPUT_DIR "/window-difference.pgm", expected, actual);
    EXPECT_LE(difference.most, 1) << "see " << actual_path << ". If the change is meant: make golden-accept";
    EXPECT_LE(difference.pixels, 400u) << "largest difference " << difference.most << "; see " << actual_path
                                       << ". If the change is meant: make golden-accept";
}

}  // namespace
