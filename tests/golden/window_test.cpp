// Compares the window of claque view with an accepted picture, pixel for pixel, drawn by softpipe. Panels are drawn by
// Dear ImGui: another one draws others, so only the accepted one is compared; with another one a picture of the size is
// wanted. The edges of ImGui's lines may differ by one step of 255 in a few pixels: it takes their normals from the
// instruction rsqrtss, whose last bits differ between makers of processors (104 pixels between an Intel and an AMD
// processor).
#include <cstdio>
#include <cstdlib>
#include <filesystem>
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

// Another Mesa rounds the edges of people differently; panels are the same. Up to 1.5 % of llvmpipe's pixels differ by
// more than 8.
constexpr int steps_of_another_rasteriser = 8;
constexpr double share_of_another_rasteriser = 0.015;

void hold(const std::string &driver)
{
    if (const std::string absent = gltest::absent_gl(contexts::Kind::any); !absent.empty()) GTEST_SKIP() << absent;
    const std::string folder = OUTPUT_DIR "/window-" + driver, json = folder + "/window.json";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const int status = std::system(("GALLIUM_DRIVER=" + driver +
                                    " " CLAQUE_COMMAND " view " CLAQUE_WINDOW_ARGUMENTS " --script " GOLDEN_DIR
                                    "/window.toml --shots " +
                                    folder + " --rates " + json)
                                       .c_str());
    ASSERT_EQ(status, 0) << "claque view failed";
    std::stringstream about;
    about << std::ifstream(json).rdbuf();
    ASSERT_NE(about.str().find(driver), std::string::npos) << "drawn by another rasteriser: " << about.str();
    const std::string mesa = first_line_of(GOLDEN_DIR "/mesa.txt");
    ASSERT_FALSE(mesa.empty());
    const bool same = driver == "softpipe" && about.str().find(mesa) != std::string::npos;
    const Picture expected = read_picture(GOLDEN_DIR "/window.png"), actual = read_picture(folder + "/window.png");
    ASSERT_FALSE(expected.rgb.empty());
    ASSERT_EQ(std::pair(actual.width, actual.height), std::pair(expected.width, expected.height));
    EXPECT_NE(actual.rgb, std::vector<uint8_t>(actual.rgb.size(), actual.rgb[0])) << "nothing is drawn";
    const std::string imgui = first_line_of(GOLDEN_DIR "/imgui.txt"), here = "Dear ImGui " IMGUI_VERSION;
    if (imgui != here) GTEST_SKIP() << "the picture is of " << imgui << ", which is not installed: this is " << here;
    const Difference difference = compare(expected, actual, same ? 0 : steps_of_another_rasteriser);
    if (difference.pixels) write_difference(folder + "/window-difference.pgm", expected, actual);
    const double pixels = double(expected.rgb.size()) / 3;
    if (same) {
        EXPECT_LE(difference.most, 1) << "see " << folder << ". If the change is meant: make golden-accept";
    }
    EXPECT_LE(double(difference.pixels), same ? 400 : share_of_another_rasteriser * pixels)
        << "largest difference " << difference.most << "; see " << folder
        << ". If the change is meant: make golden-accept";
    testing::Test::RecordProperty("pixels", std::to_string(difference.pixels));
}

TEST(GoldenWindow, IsAsItWasAccepted) { hold("softpipe"); }

TEST(GoldenWindow, IsAlikeWithAnotherRasteriser) { hold("llvmpipe"); }

}  // namespace
