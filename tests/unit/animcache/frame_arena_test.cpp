#include "animcache/frame_arena.h"

#include <algorithm>
#include <cstring>
#include <memory_resource>
#include <random>

#include <gtest/gtest.h>

#include "tests/law/support/host.h"

namespace claque::animcache
{

using testing_support::CountingMemory;

namespace
{

struct Block {
    char *first;
    size_t bytes;
};

std::vector<Block> take_blocks(FrameArena &arena, uint32_t seed, uint32_t count)
{
    std::mt19937 random(seed);
    std::vector<Block> blocks;
    for (uint32_t i = 0; i < count; ++i) {
        const size_t bytes = 1 + random() % 9000;
        blocks.push_back({reinterpret_cast<char *>(arena.take(bytes)), bytes});
    }
    return blocks;
}

}  // namespace

TEST(FrameArena, BlocksLieOnCacheLinesAndDoNotOverlap)
{
    FrameArena arena(std::pmr::get_default_resource());
    for (uint32_t update = 1; update <= 3; ++update) {
        arena.reset();
        std::vector<Block> blocks = take_blocks(arena, update, 200);
        uint64_t used = 0;
        for (const Block &block : blocks) {
            ASSERT_TRUE(block.first);
            EXPECT_EQ(reinterpret_cast<uintptr_t>(block.first) % FrameArena::alignment, 0u);
            std::memset(block.first, 0xff, block.bytes);  // a sanitizer checks that all of it may be written
            used += block.bytes;
        }
        std::sort(blocks.begin(), blocks.end(), [](const Block &a, const Block &b) { return a.first < b.first; });
        for (size_t i = 1; i < blocks.size(); ++i)
            EXPECT_GE(blocks[i].first, blocks[i - 1].first + blocks[i - 1].bytes);
        EXPECT_GE(arena.used_bytes(), used);
        EXPECT_LE(arena.used_bytes(), used + blocks.size() * FrameArena::alignment);
        EXPECT_LE(arena.used_bytes(), arena.reserved_bytes());
    }
}

TEST(FrameArena, TheSameUpdateAgainAsksTheHostForNothing)
{
    CountingMemory memory;
    {
        FrameArena arena(&memory);
        const std::vector<Block> before = take_blocks(arena, 7, 300);
        const uint64_t allocations = memory.allocations();
        for (int update = 0; update < 5; ++update) {
            arena.reset();
            EXPECT_EQ(arena.used_bytes(), 0u);
            const std::vector<Block> after = take_blocks(arena, 7, 300);
            for (size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].first, before[i].first);
        }
        EXPECT_EQ(memory.allocations(), allocations);
        EXPECT_EQ(int64_t(arena.reserved_bytes() + arena.book_bytes()), memory.bytes());
    }
    EXPECT_EQ(memory.bytes(), 0) << "all memory is given back";
}

TEST(FrameArena, HoldsLittleMoreThanItsFullestUpdate)
{
    FrameArena arena(std::pmr::get_default_resource());
    uint64_t fullest = 0;
    for (uint32_t update = 1; update <= 40; ++update) {
        arena.reset();
        take_blocks(arena, update, 50 * update);
        fullest = std::max(fullest, arena.used_bytes());
    }
    EXPECT_LE(arena.reserved_bytes(), fullest + fullest / 3 + (1 << 17));
}

TEST(FrameArena, ARefusedChunkLeavesAllOtherBlocksAndTheNextTryMaySucceed)
{
    CountingMemory memory;
    FrameArena arena(&memory);
    const std::vector<Block> blocks = take_blocks(arena, 3, 20);
    for (const Block &block : blocks) std::memset(block.first, 0x5a, block.bytes);
    memory.refuse_all(true);
    const uint64_t used = arena.used_bytes(), reserved = arena.reserved_bytes();
    EXPECT_EQ(arena.take(size_t(1) << 20), nullptr);
    EXPECT_EQ(arena.used_bytes(), used);
    EXPECT_EQ(arena.reserved_bytes(), reserved);
    memory.refuse_all(false);
    EXPECT_TRUE(arena.take(size_t(1) << 20));
    for (const Block &block : blocks)
        EXPECT_EQ(std::count(block.first, block.first + block.bytes, char(0x5a)), int64_t(block.bytes));
}

TEST(FrameArena, ABlockOfMoreThanMemoryCanHoldIsRefused)
{
    // A sanitizer's own allocator would end the test in place of std::bad_alloc.
    class Small : public std::pmr::memory_resource
    {
        void *do_allocate(size_t bytes, size_t alignment) override
        {
            if (bytes > size_t(1) << 30) throw std::bad_alloc();
            return std::pmr::new_delete_resource()->allocate(bytes, alignment);
        }
        void do_deallocate(void *block, size_t bytes, size_t alignment) override
        {
            std::pmr::new_delete_resource()->deallocate(block, bytes, alignment);
        }
        bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }
    } small;
    FrameArena arena(&small);
    EXPECT_EQ(arena.take(~size_t(0)), nullptr);
    EXPECT_EQ(arena.take(~size_t(0) / 2), nullptr);
    EXPECT_TRUE(arena.take(1));
}

}  // namespace claque::animcache
