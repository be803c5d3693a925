#include "tests/api/failing_memory.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define WITHOUT_MALLOC 1  // sanitizers own malloc; operator new and the host's allocator are still ours
#endif

#if !defined(WITHOUT_MALLOC)
extern "C" {
void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
}
#endif

namespace
{

std::atomic<bool> armed{false};
bool reach_everything = false, keep_failing = false;
uint64_t fail_at = 0;
std::atomic<uint64_t> seen{0};
std::atomic<int64_t> held{0};

bool refuse(bool host)
{
    if (!armed || !(host || reach_everything)) return false;
    const uint64_t number = ++seen;
    return fail_at && (number == fail_at || (keep_failing && number > fail_at));
}

#if defined(WITHOUT_MALLOC)
void *plain(size_t bytes) { return std::malloc(bytes); }
#else
void *plain(size_t bytes) { return __libc_malloc(bytes); }
#endif

void *host_allocate(void *, size_t bytes, size_t)
{
    if (refuse(true)) return nullptr;
    held += static_cast<int64_t>(bytes);
    return plain(bytes ? bytes : 1);
}

void host_release(void *, void *memory, size_t bytes, size_t)
{
    held -= static_cast<int64_t>(bytes);
    std::free(memory);
}

}  // namespace

namespace failing_memory
{

void arm(uint64_t n, Reach reach, bool persistent)
{
    fail_at = n, keep_failing = persistent, reach_everything = reach == Reach::everything, seen = 0;
    armed = true;
}

uint64_t disarm()
{
    armed = false;
    return seen;
}

int64_t host_bytes() { return held; }

const clq_allocator allocator = {nullptr, host_allocate, host_release};

}  // namespace failing_memory

void *operator new(size_t bytes)
{
    if (!refuse(false))
        if (void *memory = plain(bytes ? bytes : 1)) return memory;
    throw std::bad_alloc();
}
void *operator new[](size_t bytes) { return operator new(bytes); }
void *operator new(size_t bytes, const std::nothrow_t &) noexcept
{
    return refuse(false) ? nullptr : plain(bytes ? bytes : 1);
}
void *operator new[](size_t bytes, const std::nothrow_t &tag) noexcept { return operator new(bytes, tag); }
// GCC does not see that operator new above takes its memory from malloc.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete[](void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, size_t) noexcept { std::free(memory); }
void operator delete[](void *memory, size_t) noexcept { std::free(memory); }

#if !defined(WITHOUT_MALLOC)
extern "C" {

void *malloc(size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    return __libc_malloc(bytes);
}

void *calloc(size_t count, size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    return __libc_calloc(count, bytes);
}

void *realloc(void *memory, size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    return __libc_realloc(memory, bytes);
}

}  // extern "C"
#endif
