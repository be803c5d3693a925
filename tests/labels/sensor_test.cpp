// Haze, noise and compression of pictures.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/labels/variation/haze.h"
#include "samples/labels/variation/jpeg.h"
#include "samples/labels/variation/noise.h"
#include "samples/scenes/eye.h"

namespace
{

constexpr double near_m = 0.5, far_m = 1000;

// As GL stores it.
float depth_of(double metres) { return static_cast<float>(far_m * (metres - near_m) / (metres * (far_m - near_m))); }

clq_camera level_camera() { return scenes::look({0, 2, 0}, {0, 2, -1}, 60, 1, near_m, far_m); }

TEST(Haze, LeavesATwentiethAtTheVisibility)
{
    std::vector<uint8_t> rgb = {0, 0, 0};
    labels::add_haze(rgb, {depth_of(100)}, 1, 1, level_camera(), 100);
    EXPECT_EQ(rgb[0], 208);  // 219 - 219 / 20
    EXPECT_EQ(rgb[1], 213);
    rgb = {255, 0, 100};
    labels::add_haze(rgb, {depth_of(10)}, 1, 1, level_camera(), 1000);
    EXPECT_NEAR(rgb[0], 219 + 36 * 0.9705, 1);
    EXPECT_NEAR(rgb[1], 224 * 0.0295, 1);
}

TEST(Haze, IsThickerAtTheEdgesOfAWallThanInItsMiddle)
{
    const int size = 65;
    std::vector<uint8_t> rgb(3 * size * size, 0);
    labels::add_haze(rgb, std::vector<float>(size * size, depth_of(50)), size, size, level_camera(), 100);
    const size_t middle = 3 * (32 * 65 + 32), edge = 3 * (32 * 65);
    EXPECT_NEAR(rgb[middle], 219 * (1 - std::exp(-2.9957 * 0.5)), 1);
    const double longer = std::sqrt(1 + std::pow(64.0 / 65 * std::tan(0.5235987755982988), 2));
    EXPECT_NEAR(rgb[edge], 219 * (1 - std::exp(-2.9957 * 0.5 * longer)), 1);
    EXPECT_GT(rgb[edge], rgb[middle]);
}

TEST(Haze, HidesTheSkyNearTheHorizonAndLessAbove)
{
    const int size = 65;
    std::vector<uint8_t> rgb(3 * size * size, 0);
    labels::add_haze(rgb, std::vector<float>(size * size, 1), size, size, level_camera(), 2000);
    const auto column = [&](int y) { return rgb[3 * static_cast<size_t>(y * size + 32)]; };
    EXPECT_EQ(column(33), 219);  // below the horizon
    EXPECT_LT(column(0), 160);
    for (int y = 1; y < 33; ++y) EXPECT_GE(column(y), column(y - 1));
}

TEST(Noise, HasItsDeviationAndNoBias)
{
    for (const auto &[read, shot, value, deviation] :
         {std::array<double, 4>{4, 0, 128, 4}, {0, 6, 255 / 4, 6 * std::sqrt(63.0 / 255)}, {3, 4, 127, 4.12}}) {
        std::vector<uint8_t> rgb(300000, static_cast<uint8_t>(value));
        labels::add_noise(rgb, read, shot, 9, 3);
        double sum = 0, squares = 0;
        for (const uint8_t one : rgb) sum += one, squares += (one - value) * (one - value);
        const double count = static_cast<double>(rgb.size()), mean = sum / count - std::floor(value);
        EXPECT_NEAR(mean, 0, 0.05);
        // Rounding adds a twelfth.
        EXPECT_NEAR(std::sqrt(squares / count - 1.0 / 12), deviation, 0.05 * deviation);
    }
}

TEST(Noise, IsOfItsSeedAndSampleAndStaysInRange)
{
    const auto noisy = [](uint64_t seed, uint32_t sample, uint8_t value) {
        std::vector<uint8_t> rgb(3000, value);
        labels::add_noise(rgb, 20, 0, seed, sample);
        return rgb;
    };
    EXPECT_EQ(noisy(1, 2, 100), noisy(1, 2, 100));
    EXPECT_NE(noisy(1, 2, 100), noisy(1, 3, 100));
    EXPECT_NE(noisy(1, 2, 100), noisy(2, 2, 100));
    size_t black = 0;
    for (const uint8_t one : noisy(1, 2, 0)) {
        black += one == 0;
        EXPECT_LT(one, 80);  // did not go below 0 and round
    }
    EXPECT_NEAR(static_cast<double>(black), 1500, 150);
    std::vector<uint8_t> silent(300, 77);
    labels::add_noise(silent, 0, 0, 1, 2);
    EXPECT_EQ(silent, std::vector<uint8_t>(300, 77));
}

TEST(Compression, LosesMoreAtLowerQuality)
{
#ifndef CLAQUE_HAS_JPEG
    GTEST_SKIP() << "built without stb_image_write.h";
#endif
    ASSERT_TRUE(labels::can_compress());
    const int width = 37, height = 23;
    std::vector<uint8_t> rgb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int k = 0; k < 3; ++k) rgb.push_back(static_cast<uint8_t>(128 + 90 * std::sin(0.4 * x + 0.3 * y + k)));
    const auto lost = [&](int quality) {
        std::vector<uint8_t> after = rgb;
        labels::compress(after, width, height, quality);
        std::vector<uint8_t> again = rgb;
        labels::compress(again, width, height, quality);
        EXPECT_EQ(after, again);
        double sum = 0;
        for (size_t i = 0; i < rgb.size(); ++i) sum += std::abs(double(after[i]) - double(rgb[i]));
        return sum / static_cast<double>(rgb.size());
    };
    EXPECT_LT(lost(100), 1.5);
    EXPECT_LT(lost(100), lost(60));
    EXPECT_LT(lost(60), lost(5));
    EXPECT_GT(lost(5), 4);
}

}  // namespace
