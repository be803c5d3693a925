#include "lib/asset/stb_decode.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace
{

// The memory of one decode; a thread runs one decode at a time. Blocks begin with their size, so that freed memory can
// be counted.
struct Arena {
    uint64_t left = 0;
    bool heap_refused = false;
};
thread_local Arena arena;

struct alignas(16) Head {
    size_t size;
};

void *arena_allocate(size_t size)
{
    if (size > arena.left) return nullptr;
    // Zeros: a damaged JPEG leaves coefficients unwritten that stb_image reads.
    Head *head = static_cast<Head *>(std::calloc(1, sizeof(Head) + size));
    if (!head) {
        arena.heap_refused = true;
        return nullptr;
    }
    head->size = size;
    arena.left -= size;
    return head + 1;
}

void arena_free(void *block)
{
    if (!block) return;
    Head *head = static_cast<Head *>(block) - 1;
    arena.left += head->size;
    std::free(head);
}

void *arena_resize(void *block, size_t size)
{
    void *bigger = arena_allocate(size);
    if (!bigger || !block) return bigger;
    const size_t old = (static_cast<Head *>(block) - 1)->size;
    std::memcpy(bigger, block, old < size ? old : size);
    arena_free(block);
    return bigger;
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384
#define STBI_ASSERT(x) ((void)(x))
#define STBI_MALLOC(size) arena_allocate(size)
#define STBI_REALLOC(block, size) arena_resize(block, size)
#define STBI_FREE(block) arena_free(block)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace claque::asset::stb
{

namespace
{

// Enough memory for reading a header.
constexpr uint64_t header_bytes = 1 << 20;

}  // namespace

Size size_of(const uint8_t *bytes, size_t size)
{
    arena = Arena{header_bytes + size, false};
    int width = 0, height = 0, channels = 0;
    const bool good = stbi_info_from_memory(bytes, static_cast<int>(size), &width, &height, &channels) != 0;
    if (arena.heap_refused) throw std::bad_alloc();
    if (!good || width <= 0 || height <= 0) return Size{};
    return Size{static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

const char *decode(const uint8_t *bytes, size_t size, uint64_t cap_bytes, const Size &expected, uint8_t *out_rgba)
{
    arena = Arena{cap_bytes, false};
    int width = 0, height = 0, channels = 0;
    stbi_uc *pixels = stbi_load_from_memory(bytes, static_cast<int>(size), &width, &height, &channels, 4);
    if (!pixels) {
        if (arena.heap_refused) throw std::bad_alloc();
        const char *reason = stbi_failure_reason();
        return reason ? reason : "it is broken";
    }
    const bool same =
        static_cast<uint32_t>(width) == expected.width && static_cast<uint32_t>(height) == expected.height;
    if (same) std::memcpy(out_rgba, pixels, size_t(4) * expected.width * expected.height);
    stbi_image_free(pixels);
    return same ? nullptr : "it changes its size";
}

}  // namespace claque::asset::stb
