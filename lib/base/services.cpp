#include "lib/base/services.h"

#include <new>

namespace claque::base
{

void *HostMemory::do_allocate(std::size_t bytes, std::size_t alignment)
{
    void *memory = allocator_.allocate(allocator_.user, bytes, alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void HostMemory::do_deallocate(void *memory, std::size_t bytes, std::size_t alignment)
{
    allocator_.release(allocator_.user, memory, bytes, alignment);
}

}  // namespace claque::base
