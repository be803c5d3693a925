#include "heap_meter.h"

#include <cstdlib>
#include <new>

namespace
{

struct alignas(16) Head {
    std::size_t size;
};
uint64_t held = 0, peak = 0;

void *take(std::size_t size)
{
    Head *head = static_cast<Head *>(std::malloc(sizeof(Head) + size));
    if (!head) throw std::bad_alloc();
    head->size = size;
    held += size;
    if (held > peak) peak = held;
    return head + 1;
}

void give(void *block)
{
    if (!block) return;
    Head *head = static_cast<Head *>(block) - 1;
    held -= head->size;
    std::free(head);
}

}  // namespace

void *operator new(std::size_t size) { return take(size); }
void *operator new[](std::size_t size) { return take(size); }
void operator delete(void *block) noexcept { give(block); }
void operator delete[](void *block) noexcept { give(block); }
void operator delete(void *block, std::size_t) noexcept { give(block); }
void operator delete[](void *block, std::size_t) noexcept { give(block); }

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
