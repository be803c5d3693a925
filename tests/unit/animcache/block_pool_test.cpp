#include "animcache/block_pool.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "tests/law/support/host.h"

namespace claque::animcache
{

using testing_support::CountingMemory;

TEST(BlockPool, GivesBlocksThatDoNotOverlapAndLieOnCacheLines)
{
    BlockPool pool(std::pmr::get_default_resource(), 1 << 20);
    std::set<std::pair<const char *, const char *>> taken;
    for (const size_t bytes : {100u, 1000u, 100u, 64u, 1000u}) {
        for (int i = 0; i < 40; ++i) {
            float *block = pool.allocate_from_slabs(bytes);
            if (!block) block = pool.allocate_new_slab(bytes);
            ASSERT_TRUE(block);
            EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % BlockPool::alignment, 0u);
            std::memset(block, 0xff, bytes);  // a sanitizer checks that all of it may be written
            taken.insert({reinterpret_cast<char *>(block), reinterpret_cast<char *>(block) + bytes});
        }
    }
    ASSERT_EQ(taken.size(), 200u);
    const char *end = nullptr;
    for (const auto &[first, last] : taken) {
        EXPECT_GE(first, end);
        end = last;
    }
    EXPECT_LE(pool.used_bytes(), pool.reserved_bytes());
}

TEST(BlockPool, WhatIsGivenBackIsTakenAgainWithoutTheHost)
{
    CountingMemory memory;
    BlockPool pool(&memory, 1 << 20);
    std::vector<float *> blocks;
    for (int i = 0; i < 50; ++i) {
        float *block = pool.allocate_from_slabs(500);
        blocks.push_back(block ? block : pool.allocate_new_slab(500));
    }
    const uint64_t before = memory.allocations();
    for (int round = 0; round < 100; ++round) {
        for (int i = round % 3; i < 50; i += 3) pool.deallocate(blocks[i], 500), blocks[i] = nullptr;
        for (float *&block : blocks) {
            if (!block) block = pool.allocate_from_slabs(500);
            ASSERT_TRUE(block);
        }
    }
    EXPECT_EQ(memory.allocations(), before);
    EXPECT_EQ(std::set<float *>(blocks.begin(), blocks.end()).size(), 50u);
}

TEST(BlockPool, KeepsItsBudgetToTheLastBlockAndSlabsThatAreEmptyGoBack)
{
    CountingMemory memory;
    {
        BlockPool pool(&memory, 1000 * 64);
        std::vector<float *> small;
        for (float *block; (block = pool.allocate_from_slabs(64)) || (block = pool.allocate_new_slab(64));)
            small.push_back(block);
        EXPECT_EQ(small.size(), 1000u);
        EXPECT_EQ(pool.reserved_bytes(), 64000u);
        EXPECT_FALSE(pool.allocate_new_slab(640));
        EXPECT_FALSE(pool.trim());
        for (float *block : small) pool.deallocate(block, 64);
        EXPECT_EQ(pool.used_bytes(), 0u);
        EXPECT_TRUE(pool.trim());
        EXPECT_EQ(pool.reserved_bytes(), 0u);
        EXPECT_TRUE(pool.allocate_new_slab(640));
    }
    EXPECT_EQ(memory.bytes(), 0);
}

TEST(BlockPool, AHostThatRefusesLeavesItAsItWas)
{
    CountingMemory memory;
    BlockPool pool(&memory, 1 << 20);
    float *first = pool.allocate_new_slab(200);
    memory.refuse_all(true);
    while (pool.allocate_from_slabs(200)) {}
    EXPECT_FALSE(pool.allocate_new_slab(200));
    EXPECT_FALSE(pool.allocate_new_slab(999));
    memory.refuse_all(false);
    pool.deallocate(first, 200);
    EXPECT_EQ(pool.allocate_from_slabs(200), first);
}

}  // namespace claque::animcache
