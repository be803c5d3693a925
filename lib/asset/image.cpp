#include "lib/asset/image.h"

#include <cstring>

#include "lib/asset/decoders.h"
#include "lib/asset/stb_decode.h"
#include "lib/asset/webp_decode.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint8_t png_magic[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
// Every scan of a progressive JPEG covers the whole picture; files in use have about ten.
constexpr uint32_t max_scans = 100;

bool starts_with(const uint8_t *bytes, size_t size, const void *magic, size_t length, size_t at = 0)
{
    return size >= at + length && std::memcmp(bytes + at, magic, length) == 0;
}

// Checks that chunks end inside the file, because the decoder allocates a chunk's size before it reads the chunk.
void check_png(const uint8_t *bytes, size_t size, const char *name)
{
    size_t at = sizeof png_magic;
    for (size_t chunk = 0; at < size; ++chunk) {
        if (size - at < 12) fail(CLQ_FORMAT, "image '%s': PNG chunk %zu is cut off", name, chunk);
        const uint8_t *p = bytes + at;
        const uint64_t length = uint64_t(p[0]) << 24 | uint64_t(p[1]) << 16 | uint64_t(p[2]) << 8 | p[3];
        if (length > size - at - 12)
            fail(CLQ_FORMAT, "image '%s': PNG chunk %zu says %llu bytes, %zu are left", name, chunk,
                 static_cast<unsigned long long>(length), size - at - 12);
        if (std::memcmp(p + 4, "IEND", 4) == 0) return;
        at += 12 + length;
    }
    fail(CLQ_FORMAT, "image '%s': the PNG has no end", name);
}

// The tables of a segment, to which `at` points, behind its length. The decoder has room for 256 codes in each and
// reads on until the segment's length is used up, also beyond the segment.
void check_tables(const uint8_t *bytes, size_t size, size_t at, uint32_t length, const char *name)
{
    for (int64_t left = int64_t(length) - 2; left > 0;) {
        uint32_t codes = 0;
        for (size_t i = at + 1; i < at + 17 && i < size; ++i) codes += bytes[i];
        if (codes > 256)
            fail(CLQ_FORMAT, "image '%s': a Huffman table of the JPEG has %u codes: 256 are the most", name, codes);
        at += 17 + codes;
        left -= 17 + int64_t(codes);
    }
}

// Walks from marker to marker as the decoder does. Compressed data has no marker but restarts.
void check_jpeg(const uint8_t *bytes, size_t size, const char *name)
{
    uint32_t scans = 0;
    for (size_t i = 0; i + 1 < size;) {
        const uint8_t marker = bytes[i + 1];
        const bool alone = marker == 0 || marker == 0xff || (marker >= 0xd0 && marker <= 0xd8);
        if (bytes[i] != 0xff || alone) {
            ++i;
            continue;
        }
        if (marker == 0xd9) break;
        if (marker == 0xda) ++scans;
        const uint32_t length = i + 3 < size ? uint32_t(bytes[i + 2]) << 8 | bytes[i + 3] : 0;
        if (marker == 0xc4) check_tables(bytes, size, i + 4, length, name);
        i += 2 + length;
    }
    if (scans > max_scans) fail(CLQ_LIMIT, "image '%s': the JPEG has %u scans, %u are read", name, scans, max_scans);
}

void check_format(const uint8_t *bytes, size_t size, const char *name)
{
    switch (image_format(bytes, size)) {
        case ImageFormat::png:
            return check_png(bytes, size, name);
        case ImageFormat::jpeg:
            return check_jpeg(bytes, size, name);
        case ImageFormat::webp:
            if (!has_decoder(Decoder::webp)) refuse_without(Decoder::webp, base::text_of("image '%s'", name));
            return;
        case ImageFormat::ktx:
            fail(CLQ_UNSUPPORTED, "image '%s' is KTX: PNG and JPEG are read", name);
        case ImageFormat::dds:
            fail(CLQ_UNSUPPORTED, "image '%s' is DDS: PNG and JPEG are read", name);
        case ImageFormat::unknown:
            break;
    }
    fail(CLQ_FORMAT, "image '%s' of %zu bytes is neither PNG, JPEG nor WebP", name, size);
}

void check_size(const stb::Size &found, size_t size, const char *name, const ImageLimits &limits)
{
    const uint64_t pixels = uint64_t(found.width) * found.height;
    if (found.width > limits.max_px || found.height > limits.max_px)
        fail(CLQ_LIMIT, "image '%s' is %u x %u: at most %u pixels a side are read", name, found.width, found.height,
             limits.max_px);
    if (pixels > pixels_for_nothing && pixels / 256 > size)
        fail(CLQ_LIMIT, "image '%s' says %u x %u pixels in %zu bytes: that is not believed", name, found.width,
             found.height, size);
    if (4 * pixels > limits.max_bytes)
        fail(CLQ_LIMIT, "image '%s' of %u x %u would take %llu bytes: %llu are left of the limit", name, found.width,
             found.height, static_cast<unsigned long long>(4 * pixels),
             static_cast<unsigned long long>(limits.max_bytes));
}

}  // namespace

ImageFormat image_format(const uint8_t *bytes, size_t size)
{
    if (starts_with(bytes, size, png_magic, sizeof png_magic)) return ImageFormat::png;
    if (starts_with(bytes, size, "\xff\xd8\xff", 3)) return ImageFormat::jpeg;
    if (starts_with(bytes, size, "RIFF", 4) && starts_with(bytes, size, "WEBP", 4, 8)) return ImageFormat::webp;
    if (starts_with(bytes, size, "\xabKTX ", 5)) return ImageFormat::ktx;
    if (starts_with(bytes, size, "DDS ", 4)) return ImageFormat::dds;
    return ImageFormat::unknown;
}

model::Image decode_image(const uint8_t *bytes, size_t size, const std::string &name, const ImageLimits &limits)
{
    if (size > 0x7fffffff) fail(CLQ_LIMIT, "image '%s' has %zu bytes: too many", name.c_str(), size);
    check_format(bytes, size, name.c_str());
    const bool is_webp = image_format(bytes, size) == ImageFormat::webp;
    const stb::Size found = is_webp ? webp::size_of(bytes, size) : stb::size_of(bytes, size);
    if (found.width == 0 || found.height == 0) fail(CLQ_FORMAT, "image '%s': its header is broken", name.c_str());
    check_size(found, size, name.c_str(), limits);
    model::Image image;
    image.name = name;
    image.width = found.width;
    image.height = found.height;
    image.rgba.resize(size_t(4) * found.width * found.height);
    // 24 bytes per pixel cover 16-bit samples, filtered and unfiltered, and the doubling of a growing buffer.
    const uint64_t cap = size + 24 * uint64_t(found.width) * found.height + (1 << 20);
    const char *reason = is_webp ? webp::decode(bytes, size, found, image.rgba.data())
                                 : stb::decode(bytes, size, cap, found, image.rgba.data());
    if (reason) fail(CLQ_FORMAT, "image '%s' cannot be decoded: %s", name.c_str(), reason);
    return image;
}

}  // namespace claque::asset
