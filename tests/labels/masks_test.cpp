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

TEST(Letters, HoldFiveBitsEachAndDifferencesFromTheFourthRunOn)
{
    EXPECT_EQ(letters_of({0}), "0");
    EXPECT_EQ(letters_of({15}), "?");
    EXPECT_EQ(letters_of({16}), "`0");            // 16 alone would be negative
    EXPECT_EQ(letters_of({1, 2, 3, 2}), "1230");  // the fourth is 2 - 2
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
