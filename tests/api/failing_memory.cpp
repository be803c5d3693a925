#include "tests/api/failing_memory.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

#include <unwind.h>

// Sanitizers own malloc, and only glibc lends its own; operator new and the host's allocator are still ours.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define WITHOUT_MALLOC 1
#endif

#if !defined(WITHOUT_MALLOC)
extern "C" {
void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);
void __libc_free(void *);
}
#endif

namespace
{

std::atomic<bool> armed{false};
bool reach_everything = false, keep_failing = false;
uint64_t fail_at = 0;
std::atomic<uint64_t> seen{0};
std::atomic<int64_t> held{0}, blocks_held{0};
std::vector<failing_memory::Place> *noted = nullptr;
uint32_t wanted_frames = 8;
std::atomic<failing_memory::Place> failed{0};

struct Walk {
    uint64_t hash = 0;
    uint32_t frames = 0;
};
uintptr_t outermost = 0;  // the frame that arms: what is above it is the test's

failing_memory::Place place_here()
{
    Walk walk;
    _Unwind_Backtrace(
        [](_Unwind_Context *frame, void *user) {
            Walk &found = *static_cast<Walk *>(user);
            if (_Unwind_GetCFA(frame) > outermost) return _URC_END_OF_STACK;
            const uint64_t address = _Unwind_GetIP(frame);
            found.hash = (found.hash ^ address) * 0x9e3779b97f4a7c15u;
            found.hash ^= found.hash >> 29;
            return ++found.frames < wanted_frames ? _URC_NO_REASON : _URC_END_OF_STACK;
        },
        &walk);
    return walk.hash;
}

bool refuse(bool host)
{
    if (!armed || !(host || reach_everything)) return false;
    const uint64_t number = ++seen;
    if (noted || number == fail_at) {  // one place for both
        const failing_memory::Unarmed unarmed;
        const failing_memory::Place place = place_here();
        if (noted) noted->push_back(place);
        if (number == fail_at) failed = place;
    }
    return fail_at && (number == fail_at || (keep_failing && number > fail_at));
}

#if defined(_WIN32)
void *plain(size_t bytes, size_t alignment)
{
    void *memory = _aligned_malloc(bytes ? bytes : 1, std::max(alignment, alignof(std::max_align_t)));
    blocks_held += memory != nullptr;
    return memory;
}
void plain_free(void *memory)
{
    blocks_held -= memory != nullptr;
    _aligned_free(memory);
}
#elif defined(WITHOUT_MALLOC)
void *plain(size_t bytes, size_t alignment)
{
    void *memory = alignment <= alignof(std::max_align_t)
                       ? std::malloc(bytes ? bytes : 1)
                       : std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
    blocks_held += memory != nullptr;
    return memory;
}
void plain_free(void *memory)
{
    blocks_held -= memory != nullptr;
    std::free(memory);
}
#else
void *plain(size_t bytes, size_t alignment)
{
    void *memory = alignment <= alignof(std::max_align_t) ? __libc_malloc(bytes) : __libc_memalign(alignment, bytes);
    blocks_held += memory != nullptr;
    return memory;
}
void plain_free(void *memory)
{
    blocks_held -= memory != nullptr;
    __libc_free(memory);
}
#endif

void *host_allocate(void *, size_t bytes, size_t alignment)
{
    if (refuse(true)) return nullptr;
    held += static_cast<int64_t>(bytes);
    return plain(bytes, alignment);
}

void host_release(void *, void *memory, size_t bytes, size_t)
{
    held -= static_cast<int64_t>(bytes);
    plain_free(memory);
}

void *new_or_throw(size_t bytes, size_t alignment)
{
    if (!refuse(false))
        if (void *memory = plain(bytes, alignment)) return memory;
    throw std::bad_alloc();
}

}  // namespace

namespace failing_memory
{

void arm(uint64_t n, Reach reach, bool persistent)
{
    outermost = reinterpret_cast<uintptr_t>(__builtin_frame_address(0)) + 2 * sizeof(void *);
    fail_at = n, keep_failing = persistent, reach_everything = reach == Reach::everything, seen = 0;
    armed = true;
}

uint64_t disarm()
{
    armed = false;
    return seen;
}

Unarmed::Unarmed() : was_armed_(armed.exchange(false)) {}
Unarmed::~Unarmed() { armed = was_armed_; }

int64_t host_bytes() { return held; }
int64_t blocks() { return blocks_held; }
void note_places(std::vector<Place> *out, uint32_t frames) { noted = out, wanted_frames = frames; }
Place failed_place() { return failed; }

const clq_allocator allocator = {nullptr, host_allocate, host_release};

}  // namespace failing_memory

void *operator new(size_t bytes) { return new_or_throw(bytes, 1); }
void *operator new[](size_t bytes) { return new_or_throw(bytes, 1); }
void *operator new(size_t bytes, std::align_val_t alignment) { return new_or_throw(bytes, size_t(alignment)); }
void *operator new[](size_t bytes, std::align_val_t alignment) { return new_or_throw(bytes, size_t(alignment)); }
void *operator new(size_t bytes, const std::nothrow_t &) noexcept { return refuse(false) ? nullptr : plain(bytes, 1); }
void *operator new[](size_t bytes, const std::nothrow_t &tag) noexcept { return operator new(bytes, tag); }
void *operator new(size_t bytes, std::align_val_t alignment, const std::nothrow_t &) noexcept
{
    return refuse(false) ? nullptr : plain(bytes, size_t(alignment));
}
void *operator new[](size_t bytes, std::align_val_t alignment, const std::nothrow_t &tag) noexcept
{
    return operator new(bytes, alignment, tag);
}
// GCC does not see that operator new above takes its memory from malloc.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void operator delete(void *memory) noexcept { plain_free(memory); }
void operator delete[](void *memory) noexcept { plain_free(memory); }
void operator delete(void *memory, size_t) noexcept { plain_free(memory); }
void operator delete[](void *memory, size_t) noexcept { plain_free(memory); }
void operator delete(void *memory, std::align_val_t) noexcept { plain_free(memory); }
void operator delete[](void *memory, std::align_val_t) noexcept { plain_free(memory); }
void operator delete(void *memory, size_t, std::align_val_t) noexcept { plain_free(memory); }
void operator delete[](void *memory, size_t, std::align_val_t) noexcept { plain_free(memory); }

#if !defined(WITHOUT_MALLOC)
extern "C" {

void *malloc(size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    return plain(bytes, 1);
}

void *calloc(size_t count, size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    void *memory = __libc_calloc(count, bytes);
    blocks_held += memory != nullptr;
    return memory;
}

void *realloc(void *memory, size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    void *moved = __libc_realloc(memory, bytes);
    blocks_held += (moved != nullptr) - (memory != nullptr && (moved || !bytes));
    return moved;
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    if (refuse(false)) return errno = ENOMEM, nullptr;
    return plain(bytes, alignment);
}

void *memalign(size_t alignment, size_t bytes) { return aligned_alloc(alignment, bytes); }

int posix_memalign(void **out, size_t alignment, size_t bytes)
{
    void *memory = aligned_alloc(alignment, bytes);
    if (memory) *out = memory;
    return memory ? 0 : ENOMEM;
}

void free(void *memory) { plain_free(memory); }

}  // extern "C"
#endif
