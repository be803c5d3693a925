// Compares the draw order with a comparison sort.
#include "lib/frame/order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "lib/base/hash.h"

namespace claque::frame
{

namespace
{

// Eight bands from each power of two to the next.
std::pair<int, int> band_of(float distance)
{
    int exponent = 0;
    const float fraction = std::frexp(distance, &exponent);
    return {distance > 0 ? exponent : -1000, static_cast<int>(std::floor(16 * fraction))};
}

std::pmr::vector<SortEntry> compared(std::pmr::vector<SortEntry> listed)
{
    std::sort(listed.begin(), listed.end(), [](const SortEntry &a, const SortEntry &b) {
        const auto of_a = band_of(a.distance), of_b = band_of(b.distance);
        return std::tie(a.tmpl, a.texture_set, of_a, a.row) < std::tie(b.tmpl, b.texture_set, of_b, b.row);
    });
    return listed;
}

std::pmr::vector<uint32_t> rows_of(const std::pmr::vector<SortEntry> &listed)
{
    std::pmr::vector<uint32_t> rows;
    for (const SortEntry &one : listed) rows.push_back(one.row);
    return rows;
}

std::pmr::vector<uint32_t> ordered(std::pmr::vector<SortEntry> listed)
{
    std::pmr::vector<SortEntry> spare;
    sort_entries(listed, spare);
    return rows_of(listed);
}

uint32_t drawn(uint32_t i, uint32_t which) { return static_cast<uint32_t>(base::mix(uint64_t(i) * 8 + which)); }

// Many individuals of one template at the same distance, in any order of rows.
std::pmr::vector<SortEntry> many(uint32_t count, uint32_t row_step)
{
    std::pmr::vector<SortEntry> listed;
    for (uint32_t i = 0; i < count; ++i)
        listed.push_back(
            {drawn(i, 0) % 5 * 100000, drawn(i, 1) % 3, float(drawn(i, 2) % 700) * 0.37f, i * row_step % 1048583});
    return listed;
}

}  // namespace

TEST(Order, IsWhatComparingOneByOneMakes)
{
    for (const uint32_t row_step : {1u, 7919u, 524287u})
        for (const uint32_t count : {1u, 2u, 100u, 5000u}) {
            std::pmr::vector<SortEntry> listed = many(count, row_step);
            EXPECT_EQ(ordered(listed), rows_of(compared(listed))) << count << " with rows by " << row_step;
            std::reverse(listed.begin(), listed.end());
            EXPECT_EQ(ordered(listed), rows_of(compared(listed))) << count << " with rows by " << row_step << " back";
        }
}

TEST(Order, GoesFrontToBackInBandsOfAnEighthAtMost)
{
    std::pmr::vector<SortEntry> listed;
    for (uint32_t i = 0; i < 3000; ++i) listed.push_back({0, 0, std::exp(float(drawn(i, 3) % 20000) * 0.001f - 5), i});
    std::pmr::vector<SortEntry> in_order = listed, spare;
    sort_entries(in_order, spare);
    float furthest = 0;
    for (size_t i = 0; i < in_order.size(); ++i) {
        EXPECT_GE(in_order[i].distance * 1.125f, furthest);
        if (i > 0 && in_order[i].row < in_order[i - 1].row) {
            EXPECT_GT(in_order[i].distance, in_order[i - 1].distance);
        }
        furthest = std::max(furthest, in_order[i].distance);
    }
}

TEST(Order, KnowsAllDistances)
{
    const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::min();
    std::pmr::vector<SortEntry> listed;
    for (const float distance : {most, 1.0f, 0.0f, 1.125f, least, std::numeric_limits<float>::infinity(), 1e-20f})
        listed.push_back({0, 0, distance, static_cast<uint32_t>(listed.size())});
    EXPECT_EQ(ordered(listed), (std::pmr::vector<uint32_t>{2, 4, 6, 1, 3, 0, 5}));
}

TEST(Order, OfNoActorsIsEmpty) { EXPECT_TRUE(ordered({}).empty()); }

}  // namespace claque::frame
