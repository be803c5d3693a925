// Pictures for `claque bench readers`: PNG by this program's writer, JPEG and WebP of one colour or two, bit by bit.
#include "samples/cli/gltf_writer.h"
#include "samples/cli/reader_parts.h"
#include "samples/io/png.h"

namespace cli
{
namespace picture_readers
{
namespace
{

struct Size {
    uint32_t width, height;
};

Size size_of(uint32_t pixels)
{
    const uint32_t rows = std::max(pixels / 100, 1u);
    return {std::max(pixels / rows, 1u), rows};
}

// A triangle that shows the picture.
std::string gltf_of(const std::string &picture, const char *kind)
{
    GltfFile file;
    const std::vector<unsigned char> bytes(picture.begin(), picture.end());
    const size_t image = file.add("images", {{"mimeType", kind}, {"bufferView", file.bytes(bytes)}});
    const bool is_webp = picture.compare(0, 4, "RIFF") == 0;
    const nlohmann::json source = {{"source", image}};
    const size_t texture =
        file.add("textures", is_webp ? nlohmann::json{{"extensions", {{"EXT_texture_webp", source}}}} : source);
    file.primitive()["attributes"]["TEXCOORD_0"] = file.floats("VEC2", {0, 0, 1, 0, 0, 1});
    file.primitive()["material"] =
        file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
    return file.glb();
}

std::string png_of(const Size &size, const io::Words &words)
{
    std::vector<uint8_t> rgb(3 * size_t(size.width) * size.height);
    for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<uint8_t>(i * 7 + i / 971);
    const std::vector<unsigned char> bytes = io::png(rgb.data(), int(size.width), int(size.height), words);
    return gltf_of(std::string(bytes.begin(), bytes.end()), "image/png");
}

std::string png_pixels(uint32_t count) { return png_of(size_of(count), {}); }
std::string png_chunks(uint32_t count) { return png_of({8, 8}, io::Words(count, {"Comment", "x"})); }

void put(std::string &to, std::initializer_list<uint32_t> bytes)
{
    for (const uint32_t byte : bytes) to.push_back(static_cast<char>(byte));
}

// Two bytes, the high one first.
void put_word(std::string &to, uint32_t word) { put(to, {word >> 8 & 0xff, word & 0xff}); }

// A scan of grey blocks whose codes are all a bit 0: no difference from the block before, no coefficients.
void put_scan(std::string &to, uint32_t first, uint32_t last, size_t bits)
{
    put(to, {0xff, 0xda, 0, 8, 1, 1, 0, first, last, 0});
    to.append((bits + 7) / 8, '\0');
}

// `scans`: 0: a picture that is not progressive.
std::string jpeg_of(const Size &size, uint32_t comments, uint32_t scans)
{
    const size_t blocks = size_t((size.width + 7) / 8) * ((size.height + 7) / 8);
    std::string out;
    put(out, {0xff, 0xd8, 0xff, 0xdb, 0, 67, 0});
    out.append(64, '\1');
    for (uint32_t i = 0; i < comments; ++i) put(out, {0xff, 0xfe, 0, 3, 'x'});
    put(out, {0xff, scans ? 0xc2u : 0xc0u, 0, 11, 8});
    put_word(out, size.height), put_word(out, size.width);
    put(out, {1, 1, 0x11, 0});
    for (const uint32_t table : {0x00u, 0x10u}) {  // one code of one bit
        put(out, {0xff, 0xc4, 0, 20, table, 1});
        out.append(16, '\0');
    }
    if (scans == 0) put_scan(out, 0, 63, 2 * blocks);
    for (uint32_t i = 0; i < scans; ++i) put_scan(out, i ? 1 : 0, i ? 63 : 0, blocks);
    put(out, {0xff, 0xd9});
    return gltf_of(out, "image/jpeg");
}

std::string jpeg_pixels(uint32_t count) { return jpeg_of(size_of(count), 0, 0); }
std::string jpeg_segments(uint32_t count) { return jpeg_of({8, 8}, count, 0); }
std::string jpeg_scans(uint32_t count) { return jpeg_of({512, 512}, 0, count); }

// Bits of a WebP stream, the lowest of a byte first.
class Bits
{
public:
    void put(uint32_t value, uint32_t count)
    {
        for (uint32_t i = 0; i < count; ++i) {
            if (used_ % 8 == 0) bytes_.push_back('\0');
            if (value >> i & 1) bytes_.back() = static_cast<char>(bytes_.back() | 1 << used_ % 8);
            ++used_;
        }
    }
    const std::string &bytes() const { return bytes_; }

private:
    std::string bytes_;
    size_t used_ = 0;
};

std::string chunk(const char *name, std::string body)
{
    std::string out = name;
    for (uint32_t k = 0; k < 4; ++k) out.push_back(static_cast<char>(body.size() >> (8 * k) & 0xff));
    if (body.size() % 2) body.push_back('\0');
    return out + body;
}

// Lossless, a bit a pixel: black and green take turns.
std::string webp_of(const Size &size, uint32_t chunks)
{
    Bits bits;
    bits.put(0x2f, 8), bits.put(size.width - 1, 14), bits.put(size.height - 1, 14);
    bits.put(1, 1), bits.put(0, 3);                             // alpha, version
    bits.put(0, 3);                                             // no transform, no cache of colours, one set of codes
    bits.put(1 | 1 << 1, 4), bits.put(255, 8);                  // green: 0 and 255
    for (int i = 0; i < 2; ++i) bits.put(1, 4);                 // red and blue: 0
    bits.put(1 | 1 << 2, 3), bits.put(255, 8), bits.put(1, 4);  // alpha: 255; distances: none
    for (uint32_t i = 0; i < size.width * size.height; ++i) bits.put(i / 3 % 2, 1);
    std::string canvas(10, '\0');
    canvas[0] = 0x10;  // alpha
    for (uint32_t k = 0; k < 3; ++k) {
        canvas[4 + k] = static_cast<char>((size.width - 1) >> (8 * k) & 0xff);
        canvas[7 + k] = static_cast<char>((size.height - 1) >> (8 * k) & 0xff);
    }
    std::string body = "WEBP";
    if (chunks > 0) body += chunk("VP8X", canvas);
    for (uint32_t i = 0; i < chunks; ++i) body += chunk("note", "x");
    return gltf_of(chunk("RIFF", body + chunk("VP8L", bits.bytes())), "image/webp");
}

std::string webp_pixels(uint32_t count) { return webp_of(size_of(count), 0); }
std::string webp_chunks(uint32_t count) { return webp_of({8, 8}, count); }

}  // namespace
}  // namespace picture_readers

std::string gltf_with_pixels(uint32_t count) { return picture_readers::png_pixels(count); }

std::vector<ReaderElement> reader_elements_of_pictures()
{
    using namespace picture_readers;
    return {{"PNG", "pixels", most_elements, png_pixels, read_asset},
            {"PNG", "chunks", most_elements, png_chunks, read_asset},
            {"JPEG", "pixels", most_elements, jpeg_pixels, read_asset},
            {"JPEG", "segments", most_elements, jpeg_segments, read_asset},
            {"JPEG", "scans", 100, jpeg_scans, read_asset},
            {"WebP", "pixels", most_elements, webp_pixels, read_asset},
            {"WebP", "chunks", most_elements, webp_chunks, read_asset}};
}

}  // namespace cli
