#include "samples/io/png.h"

#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include <png.h>

#include "samples/io/regular_file.h"

namespace io
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
    int width, height, channels, bits, level;  // of compression
};

// libpng leaves by longjmp, so no object here has a destructor.
bool encode(png_structp writer, png_infop info, const Rows &rows, png_textp texts, int count)
{
    if (setjmp(png_jmpbuf(writer))) return false;
    png_set_IHDR(writer, info, static_cast<png_uint_32>(rows.width), static_cast<png_uint_32>(rows.height), rows.bits,
                 rows.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(writer, rows.level);
    png_set_text(writer, info, texts, count);
    png_write_info(writer, info);
    const size_t row_bytes = static_cast<size_t>(rows.bits / 8 * rows.channels) * static_cast<size_t>(rows.width);
    for (int y = 0; y < rows.height; ++y) png_write_row(writer, rows.bytes + row_bytes * static_cast<size_t>(y));
    png_write_end(writer, info);
    return true;
}

std::vector<unsigned char> written(const Rows &rows, const Words &words)
{
    std::vector<unsigned char> file;
    std::vector<png_text> texts;
    for (const auto &[key, value] : words) {
        png_text text = {};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = const_cast<char *>(key.c_str());
        text.text = const_cast<char *>(value.c_str());
        text.text_length = value.size();
        texts.push_back(text);
    }
    png_structp writer =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, [](png_structp, const char *) {});
    png_infop info = writer ? png_create_info_struct(writer) : nullptr;
    bool done = false;
    if (info) {
        png_set_write_fn(writer, &file, append, nullptr);
        done = encode(writer, info, rows, texts.data(), static_cast<int>(texts.size()));
    }
    png_destroy_write_struct(&writer, &info);
    if (!done) throw std::runtime_error("libpng could not encode the picture");
    return file;
}

uint32_t big_endian(const unsigned char *p)
{
    return static_cast<uint32_t>(p[0]) << 24 | static_cast<uint32_t>(p[1]) << 16 | static_cast<uint32_t>(p[2]) << 8 |
           p[3];
}

}  // namespace

std::vector<unsigned char> png(const uint8_t *rgb, int width, int height, const Words &words)
{
    return written({rgb, width, height, 3, 8, 6}, words);
}

std::vector<unsigned char> quick_png(const std::vector<uint8_t> &values, int width, int height, int channels)
{
    return written({values.data(), width, height, channels, 8, 3}, {});
}

std::vector<unsigned char> quick_png(const std::vector<uint16_t> &values, int width, int height, int channels)
{
    std::vector<unsigned char> bytes;  // big-endian
    bytes.reserve(2 * values.size());
    for (const uint16_t value : values) {
        bytes.push_back(static_cast<unsigned char>(value >> 8));
        bytes.push_back(static_cast<unsigned char>(value));
    }
    return written({bytes.data(), width, height, channels, 16, 3}, {});
}

std::string text_in_png(const std::string &path, const std::string &keyword)
{
    constexpr uint32_t longest = 1 << 20;
    const RegularFile file(path, most_file_bytes);
    unsigned char head[8];
    if (!file.wrong().empty() || !file.read(0, head, sizeof head) || png_sig_cmp(head, 0, 8) != 0) return {};
    uint32_t size = 0;
    for (uint64_t at = 8; file.read(at, head, sizeof head) && std::memcmp(head + 4, "IDAT", 4) != 0; at += 12 + size) {
        size = big_endian(head);
        if (std::memcmp(head + 4, "tEXt", 4) != 0 || size <= keyword.size() || size > longest) continue;
        std::string chunk(size, 0);
        if (!file.read(at + sizeof head, chunk.data(), size)) return {};
        if (chunk.compare(0, keyword.size() + 1, keyword.c_str(), keyword.size() + 1) == 0)
            return chunk.substr(keyword.size() + 1);
    }
    return {};
}

bool is_whole_png(const std::string &path)
{
    const RegularFile file(path, most_file_bytes);
    unsigned char head[8], tail[12];
    if (!file.wrong().empty() || file.size() < sizeof head + sizeof tail) return false;
    if (!file.read(0, head, sizeof head) || !file.read(file.size() - sizeof tail, tail, sizeof tail)) return false;
    return png_sig_cmp(head, 0, 8) == 0 && std::memcmp(tail + 4, "IEND", 4) == 0;
}

}  // namespace io
