#include "heap_meter.h"

#include <cstdlib>
#include <new>

namespace
{

using std::align_val_t;
using std::nothrow_t;
using std::size_t;

// Stands before every block.
struct alignas(16) Head {
    size_t size;
    void *begin;  // of what malloc gave
};
uint64_t held = 0, peak = 0;

void *take_or_null(size_t size, size_t alignment = alignof(Head)) noexcept
{
    if (alignment < alignof(Head)) alignment = alignof(Head);
    void *const begin = std::malloc(sizeof(Head) + alignment + size);
    if (!begin) return nullptr;
    const uintptr_t from = reinterpret_cast<uintptr_t>(begin) + sizeof(Head);
    Head *const head = reinterpret_cast<Head *>((from + alignment - 1) / alignment * alignment) - 1;
    *head = {size, begin};
    held += size;
    if (held > peak) peak = held;
    return head + 1;
}

void *take(size_t size, size_t alignment = alignof(Head))
{
    void *const block = take_or_null(size, alignment);
    if (!block) throw std::bad_alloc();
    return block;
}

void give(void *block) noexcept
{
    if (!block) return;
    const Head *head = static_cast<Head *>(block) - 1;
    held -= head->size;
    std::free(head->begin);
}

}  // namespace

// All forms: sanitizers and std::pmr call the aligned and the silent ones by themselves.
void *operator new(size_t size) { return take(size); }
void *operator new[](size_t size) { return take(size); }
void *operator new(size_t size, align_val_t alignment) { return take(size, size_t(alignment)); }
void *operator new[](size_t size, align_val_t alignment) { return take(size, size_t(alignment)); }
void *operator new(size_t size, const nothrow_t &) noexcept { return take_or_null(size); }
void *operator new[](size_t size, const nothrow_t &) noexcept { return take_or_null(size); }
void *operator new(size_t size, align_val_t alignment, const nothrow_t &) noexcept
{
    return take_or_null(size, size_t(alignment));
}
void *operator new[](size_t size, align_val_t alignment, const nothrow_t &) noexcept
{
    return take_or_null(size, size_t(alignment));
}
void operator delete(void *block) noexcept { give(block); }
void operator delete[](void *block) noexcept { give(block); }
void operator delete(void *block, size_t) noexcept { give(block); }
void operator delete[](void *block, size_t) noexcept { give(block); }
void operator delete(void *block, align_val_t) noexcept { give(block); }
void operator delete[](void *block, align_val_t) noexcept { give(block); }
void operator delete(void *block, size_t, align_val_t) noexcept { give(block); }
void operator delete[](void *block, size_t, align_val_t) noexcept { give(block); }
void operator delete(void *block, const nothrow_t &) noexcept { give(block); }
void operator delete[](void *block, const nothrow_t &) noexcept { give(block); }

namespace claque::testing
{

uint64_t peak_heap_bytes(const std::function<void()> &job)
{
    const uint64_t before = held;
    peak = held;
    job();
    return peak - before;
}

}  // namespace claque::testing
