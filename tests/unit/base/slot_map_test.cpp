#include "lib/base/slot_map.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/law/support/host.h"

namespace claque::base
{

using testing_support::CountingMemory;

namespace
{

struct Number {
    int value = 7;
};

class SlotMapTest : public testing::Test
{
protected:
    uint32_t add()
    {
        map_.reserve();
        return map_.take();
    }
    std::vector<uint32_t> free_rows() const
    {
        std::vector<uint32_t> rows;
        map_.for_each_free([&](uint32_t row) { rows.push_back(row); });
        return rows;
    }

    CountingMemory memory_;
    SlotMap<Number> map_{&memory_};
};

}  // namespace

TEST_F(SlotMapTest, TakesNewRowsInOrderAndThenTheOneThatWasFreedLast)
{
    for (uint32_t row = 0; row < 40; ++row) EXPECT_EQ(add(), row);
    for (const uint32_t row : {3u, 17u, 0u}) map_.free(row);
    EXPECT_EQ(free_rows(), (std::vector<uint32_t>{0, 17, 3}));
    EXPECT_EQ(map_.used_count(), 37u);
    EXPECT_EQ(map_.free_count(), 3u);
    for (const uint32_t row : {0u, 17u, 3u, 40u}) EXPECT_EQ(add(), row);
    EXPECT_EQ(map_.size(), 41u);
    EXPECT_EQ(map_.used_count(), 41u);
}

TEST_F(SlotMapTest, StaleIdsFindNothingForEver)
{
    const SlotId first = map_.id_of(add()), second = map_.id_of(add());
    EXPECT_EQ(first.index1, 1u);
    EXPECT_EQ(first.generation, 1u);
    EXPECT_EQ(map_.find(first), 0u);
    map_.free(0);
    EXPECT_EQ(map_.find(first), no_slot);
    EXPECT_EQ(map_.find({1, 2}), no_slot) << "the generation of a free row";
    EXPECT_EQ(map_.id_of(add()).generation, 3u);
    for (const SlotId stale : {first, SlotId{0, 0}, SlotId{0, 1}, SlotId{77, 1}, SlotId{second.index1, 0}})
        EXPECT_EQ(map_.find(stale), no_slot);
    EXPECT_EQ(map_.find(second), 1u);
}

TEST_F(SlotMapTest, AFreedRowHoldsADefaultValue)
{
    const uint32_t row = add();
    EXPECT_EQ(map_[row].value, 7);
    map_[row].value = 1;
    map_[row] = Number{2};
    EXPECT_EQ(map_.slot(row).generation, 1u) << "assignment is to the value alone";
    map_.free(row);
    EXPECT_EQ(map_[row].value, 7);
}

TEST_F(SlotMapTest, ARowWhoseGenerationsAreUsedUpStaysEmpty)
{
    const uint32_t row = map_.append(SlotMap<Number>::retired - 1);
    EXPECT_TRUE(map_.in_use(row));
    map_.free(row);
    EXPECT_EQ(map_.slot(row).generation, SlotMap<Number>::retired);
    EXPECT_FALSE(map_.in_use(row));
    EXPECT_EQ(map_.free_count(), 0u);
    EXPECT_FALSE(map_.link_free(row));
    EXPECT_EQ(add(), row + 1);
}

TEST_F(SlotMapTest, AFullMapHasNoRoomUntilARowIsFreed)
{
    SlotMap<Number> small(&memory_, 3);
    EXPECT_TRUE(small.has_room(3));
    EXPECT_FALSE(small.has_room(4));
    EXPECT_THROW(small.reserve(4), std::bad_alloc);
    small.reserve(3);
    for (int i = 0; i < 3; ++i) small.take();
    EXPECT_FALSE(small.has_room());
    EXPECT_THROW(small.reserve(), std::bad_alloc);
    EXPECT_THROW(small.append(1), std::bad_alloc);
    small.free(1);
    EXPECT_TRUE(small.has_room());
    small.reserve();
    EXPECT_EQ(small.take(), 1u);
    EXPECT_EQ(small.size(), 3u);
}

TEST_F(SlotMapTest, ARefusedReserveChangesNothingAndAReservedTakeAsksForNothing)
{
    for (int i = 0; i < 5; ++i) add();
    map_.free(2);
    memory_.refuse_all(true);
    EXPECT_THROW(map_.reserve(1000), std::bad_alloc);
    EXPECT_THROW(
        {
            while (map_.size() < map_.capacity()) map_.append(1);
            map_.append(1);
        },
        std::bad_alloc);
    EXPECT_EQ(free_rows(), std::vector<uint32_t>{2});
    memory_.refuse_all(false);
    map_.reserve(1000);
    const uint64_t before = memory_.allocations();
    std::set<uint32_t> rows;
    for (int i = 0; i < 1000; ++i) rows.insert(map_.take());
    for (const uint32_t row : rows) map_.free(row);
    EXPECT_EQ(rows.size(), 1000u);
    EXPECT_EQ(memory_.allocations(), before);
}

TEST_F(SlotMapTest, RowsAndFreeOnesMakeTheSameMapAgain)
{
    std::mt19937 random(5);
    std::vector<uint32_t> used;
    for (int i = 0; i < 500; ++i) {
        if (used.empty() || random() % 3) {
            used.push_back(add());
            continue;
        }
        std::swap(used[random() % used.size()], used.back());
        map_.free(used.back());
        used.pop_back();
    }
    SlotMap<Number> again(&memory_);
    for (uint32_t row = 0; row < map_.size(); ++row) again.append(map_.slot(row).generation);
    const std::vector<uint32_t> free = free_rows();
    for (auto row = free.rbegin(); row != free.rend(); ++row) {
        EXPECT_TRUE(again.link_free(*row));
        EXPECT_FALSE(again.link_free(*row)) << "once only";
    }
    EXPECT_FALSE(again.link_free(used[0]));
    EXPECT_EQ(again.used_count(), map_.used_count());
    EXPECT_EQ(again.free_count(), map_.free_count());
    again.reserve(50);
    map_.reserve(50);
    for (int i = 0; i < 50; ++i) {
        const SlotId there = again.id_of(again.take()), here = map_.id_of(map_.take());
        EXPECT_EQ(there.index1, here.index1);
        EXPECT_EQ(there.generation, here.generation);
    }
}

}  // namespace claque::base
