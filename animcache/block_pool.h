// Memory of individuals' palettes and vertices: blocks of a few sizes, cut from slabs, so that individuals that come
// and go cost no allocation in a frame. All slabs together stay within one budget.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace claque::animcache
{

class BlockPool
{
public:
    BlockPool(std::pmr::memory_resource *memory, uint64_t budget_bytes);
    ~BlockPool();  // gives all memory back
    BlockPool(const BlockPool &) = delete;
    BlockPool &operator=(const BlockPool &) = delete;

    // Blocks are whole cache lines, so that no two individuals share one.
    static constexpr size_t alignment = 64;
    static size_t rounded_size(size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

    // Returns a free block, or null if there is none.
    float *allocate_from_slabs(size_t bytes);
    // Likewise, but allocates another slab if necessary; null: the budget is spent, or the host refuses.
    float *allocate_new_slab(size_t bytes) noexcept;
    void deallocate(float *block, size_t bytes);
    // Gives slabs without a block in use back to the host. False: there was none.
    bool trim();

    uint64_t used_bytes() const { return used_bytes_; }          // of blocks in use
    uint64_t reserved_bytes() const { return reserved_bytes_; }  // of all slabs: at most the budget
    uint64_t book_bytes() const;                                 // of the tables that describe the slabs

private:
    struct Slab {
        std::byte *memory = nullptr;
        float *free = nullptr;  // the first free block; a free block holds the address of the next
        uint32_t blocks = 0, used = 0;
    };
    // Blocks of one size.
    struct SizeClass {
        SizeClass(size_t block_bytes, std::pmr::memory_resource *memory) : bytes(block_bytes), slabs(memory) {}
        size_t bytes;
        size_t first_free = 0;         // no slab before this one has a free block
        std::pmr::vector<Slab> slabs;  // by address
    };

    SizeClass *size_class_of(size_t bytes);
    float *take_from(SizeClass &size_class, size_t slab);
    void add_slab(size_t bytes, uint32_t blocks);

    std::pmr::memory_resource *memory_;
    uint64_t budget_bytes_, used_bytes_ = 0, reserved_bytes_ = 0;
    std::pmr::vector<SizeClass> size_classes_;  // two per template
};

}  // namespace claque::animcache
