// Masks in COCO's form. Examples with values are those of the documentation of COCO's mask API.
#include <random>

#include <gtest/gtest.h>

#include "samples/labels/rle.h"

namespace
{

using labels::letters_of;
using labels::runs_of;

// Written from the description of COCO's compressed form, not from the writer.
std::vector<uint32_t> runs_in(const std::string &letters)
{
    std::vector<uint32_t> runs;
    for (size_t at = 0; at < letters.size();) {
        int64_t value = 0;
        int shift = 0;
        int letter = 0;
        do {
            letter = letters.at(at++) - 48;
            value |= static_cast<int64_t>(letter & 31) << shift;
            shift += 5;
        } while ((letter & 32) != 0);
        if ((letter & 16) != 0) value -= int64_t{1} << shift;
        if (runs.size() > 2) value += runs[runs.size() - 2];
        runs.push_back(static_cast<uint32_t>(value));
    }
    return runs;
}

TEST(Runs, AreThoseOfTheDocumentation)
{
    EXPECT_EQ(runs_of({0, 0, 1, 1, 1, 0, 1}, 1, 7), (std::vector<uint32_t>{2, 3, 1, 1}));
    EXPECT_EQ(runs_of({1, 1, 1, 1, 1, 1, 0}, 1, 7), (std::vector<uint32_t>{0, 6, 1}));
}

TEST(Runs, GoDownTheColumns)
{
    // 0 1
    // 0 1
    EXPECT_EQ(runs_of({0, 1, 0, 1}, 2, 2), (std::vector<uint32_t>{2, 2}));
    // 0 0
    // 1 1
    EXPECT_EQ(runs_of({0, 0, 1, 1}, 2, 2), (std::vector<uint32_t>{1, 1, 1, 1}));
}

TEST(Runs, OfAPersonAreReadInItsBoxAlone)
{
    std::mt19937 random(6);
    for (int round = 0; round < 300; ++round) {
        const int width = 1 + static_cast<int>(random() % 20), height = 1 + static_cast<int>(random() % 20);
        const int left = static_cast<int>(random() % static_cast<unsigned>(width)),
                  top = static_cast<int>(random() % static_cast<unsigned>(height));
        const int right = left + 1 + static_cast<int>(random() % static_cast<unsigned>(width - left)),
                  bottom = top + 1 + static_cast<int>(random() % static_cast<unsigned>(height - top));
        std::vector<uint32_t> values;
        std::vector<uint8_t> inside;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool in_box = x >= left && x < right && y >= top && y < bottom;
                values.push_back(in_box && random() % 3 != 0 ? 7 : 5);
                inside.push_back(values.back() == 7);
            }
        const labels::Box box = {double(left), double(top), double(right), double(bottom)};
        EXPECT_EQ(runs_of(values, 7, width, height, box), runs_of(inside, width, height));
    }
}

TEST(Letters, HoldFiveBitsEachAndDifferencesFromTheFourthRunOn)
{
    EXPECT_EQ(letters_of({0}), "0");
    EXPECT_EQ(letters_of({15}), "?");
    EXPECT_EQ(letters_of({16}), "`0");            // 16 alone would be negative
    EXPECT_EQ(letters_of({1, 2, 3, 2}), "1230");  // the fourth is 2 - 2
}

// The annotation in https://docs.cloudfactory.com/export-formats/coco-dataset-format, with its area and box.
TEST(Letters, AreThoseOfAPublishedAnnotation)
{
    const std::string counts =
        "WRQR14oT20K?D5M0O7I6K3M005K3M004L0N4N001O02N001N2O0001O2N00001O02N0000N3O0000002N00001O000O1O100000"
        "0000001O00000N20000000O01000000000000N2000O10O1000N20O10000N200000O01000000N11000000000000N200000000"
        "00O3N00001O2N001O0N3O002M2O002M3L7J101H>A_SbS3";
    const int width = 2097, height = 2211;
    const std::vector<uint32_t> runs = runs_in(counts);
    EXPECT_EQ(letters_of(runs), counts);
    std::vector<uint8_t> inside(size_t(width) * size_t(height));
    size_t at = 0, area = 0;
    int x0 = width, y0 = height, x1 = 0, y1 = 0;
    for (size_t k = 0; k < runs.size(); ++k)
        for (uint32_t i = 0; i < runs[k]; ++i, ++at) {
            if (k % 2 == 0) continue;
            const int x = static_cast<int>(at / size_t(height)), y = static_cast<int>(at % size_t(height));
            ASSERT_LT(x, width);
            inside[size_t(y) * size_t(width) + size_t(x)] = 1;
            x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
            ++area;
        }
    EXPECT_EQ(at, inside.size());
    EXPECT_EQ(area, 6718u);
    EXPECT_EQ((std::vector<int>{x0, y0, x1 - x0 + 1, y1 - y0 + 1}), (std::vector<int>{504, 842, 117, 75}));
    EXPECT_EQ(letters_of(runs_of(inside, width, height)), counts);
}

TEST(Letters, AreReadBackByASecondReader)
{
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        const int width = 1 + static_cast<int>(random() % 40), height = 1 + static_cast<int>(random() % 40);
        const unsigned rare = 1 + random() % 30;
        std::vector<uint8_t> inside;
        for (int i = 0; i < width * height; ++i) inside.push_back(random() % rare == 0);
        const std::vector<uint32_t> runs = runs_of(inside, width, height);
        EXPECT_EQ(runs_in(letters_of(runs)), runs);
        std::vector<uint8_t> columns;
        uint8_t value = 0;
        for (const uint32_t run : runs) {
            columns.insert(columns.end(), run, value);
            value = value == 0 ? 1 : 0;
        }
        ASSERT_EQ(columns.size(), inside.size());
        for (size_t i = 0; i < inside.size(); ++i)
            ASSERT_EQ(
                inside[i],
                columns[i % static_cast<size_t>(width) * static_cast<size_t>(height) + i / static_cast<size_t>(width)]);
    }
}

}  // namespace
