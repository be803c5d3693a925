#include "samples/labels/images.h"

#include <csetjmp>

#include <png.h>

#include "samples/scenes/check.h"

namespace labels
{
namespace
{

void append(png_structp writer, png_bytep bytes, size_t size_bytes)
{
    auto &file = *static_cast<std::vector<unsigned char> *>(png_get_io_ptr(writer));
    file.insert(file.end(), bytes, bytes + size_bytes);
}

struct Rows {
    const unsigned char *bytes;
    size_t row_bytes;
    int width, height, channels, depth;
};

// libpng leaves by longjmp, so no object here has a destructor.
bool encode(png_structp writer, png_infop info, const Rows &rows)
{
    if (setjmp(png_jmpbuf(writer))) return false;
    png_set_IHDR(writer, info, static_cast<png_uint_32>(rows.width), static_cast<png_uint_32>(rows.height), rows.depth,
                 rows.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(writer, 3);
    png_write_info(writer, info);
    for (int y = 0; y < rows.height; ++y) png_write_row(writer, rows.bytes + rows.row_bytes * static_cast<size_t>(y));
    png_write_end(writer, info);
    return true;
}

std::vector<unsigned char> written(const Rows &rows)
{
    std::vector<unsigned char> file;
    png_structp writer =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, [](png_structp, const char *) {});
    png_infop info = writer ? png_create_info_struct(writer) : nullptr;
    bool done = false;
    if (info) {
        png_set_write_fn(writer, &file, append, nullptr);
        done = encode(writer, info, rows);
    }
    png_destroy_write_struct(&writer, &info);
    if (!done) throw scenes::Failure("libpng could not encode a picture of labels");
    return file;
}

}  // namespace

std::vector<unsigned char> png8(const std::vector<uint8_t> &values, int width, int height, int channels)
{
    const size_t row = static_cast<size_t>(channels) * static_cast<size_t>(width);
    return written({values.data(), row, width, height, channels, 8});
}

std::vector<unsigned char> png16(const std::vector<uint16_t> &values, int width, int height, int channels)
{
    std::vector<unsigned char> bytes;  // big-endian
    bytes.reserve(2 * values.size());
    for (const uint16_t value : values)
        bytes.push_back(static_cast<unsigned char>(value >> 8)), bytes.push_back(static_cast<unsigned char>(value));
    const size_t row = 2 * static_cast<size_t>(channels) * static_cast<size_t>(width);
    return written({bytes.data(), row, width, height, channels, 16});
}

}  // namespace labels
