// Columns grow in steps: few enough that growth costs little, and small enough that little room is left over.
#include "lib/base/reserve.h"

#include <vector>

#include <gtest/gtest.h>

namespace claque::base
{

TEST(ReserveMore, AColumnGrowsInFewStepsAndALargeOneByAQuarterAtMost)
{
    std::vector<char> column;
    size_t steps = 0;
    while (column.size() < 1000000) {
        const size_t before = column.capacity();
        reserve_more(column);
        if (column.capacity() != before) {
            ++steps;
            const size_t most = column.size() < large_column ? column.size() / 2 + 16 : column.size() / 4;
            ASSERT_LE(column.capacity(), column.size() + most) << column.size();
        }
        column.resize(column.capacity());
    }
    EXPECT_LE(steps, 12u + 25u);
}

TEST(ReserveMore, MakesRoomForAllThatIsWantedAtOnce)
{
    std::vector<char> column(5000);
    column.shrink_to_fit();
    reserve_more(column, 4000);
    EXPECT_GE(column.capacity(), 9000u);
}

}  // namespace claque::base
