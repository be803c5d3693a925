#include "samples/convert/glb_writer.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace convert
{
namespace
{

constexpr int type_u8 = 5121, type_u16 = 5123, type_u32 = 5125, type_f32 = 5126;

size_t width_of(const char *type)
{
    if (std::strcmp(type, "SCALAR") == 0) return 1;
    if (std::strcmp(type, "MAT4") == 0) return 16;
    return static_cast<size_t>(type[3] - '0');
}

void append_word(std::string &out, size_t value)
{
    for (int k = 0; k < 4; ++k) out += static_cast<char>(static_cast<unsigned char>(value >> (8 * k)));
}

void append_chunk(std::string &out, const char (&kind)[5], std::string bytes, char filler)
{
    while (bytes.size() % 4 != 0) bytes += filler;
    append_word(out, bytes.size());
    out.append(kind, 4);
    out += bytes;
}

}  // namespace

GlbWriter::GlbWriter() { json = {{"asset", {{"version", "2.0"}, {"generator", "claque convert"}}}}; }

size_t GlbWriter::add(const char *list, Json element)
{
    json[list].push_back(std::move(element));
    return json[list].size() - 1;
}

size_t GlbWriter::bytes(const void *bytes, size_t size)
{
    while (binary_.size() % 4 != 0) binary_ += '\0';
    const size_t at = binary_.size();
    binary_.append(static_cast<const char *>(bytes), size);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", size}});
}

template <class T>
size_t GlbWriter::accessor(int component, const char *type, size_t width, const std::vector<T> &all)
{
    const size_t view = bytes(all.data(), all.size() * sizeof(T));
    return add("accessors",
               {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", all.size() / width}});
}

size_t GlbWriter::floats(const char *type, const std::vector<float> &all)
{
    return accessor(type_f32, type, width_of(type), all);
}

size_t GlbWriter::positions(const std::vector<float> &xyz)
{
    const size_t made = floats("VEC3", xyz);
    std::vector<float> low(xyz.begin(), xyz.begin() + 3), high = low;
    for (size_t i = 0; i < xyz.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], xyz[i]);
        high[i % 3] = std::max(high[i % 3], xyz[i]);
    }
    json["accessors"][made]["min"] = low;
    json["accessors"][made]["max"] = high;
    return made;
}

size_t GlbWriter::times(const std::vector<float> &seconds)
{
    const size_t made = floats("SCALAR", seconds);
    json["accessors"][made]["min"] = {seconds.front()};
    json["accessors"][made]["max"] = {seconds.back()};
    return made;
}

size_t GlbWriter::indices(const std::vector<uint32_t> &all)
{
    const uint32_t most = *std::max_element(all.begin(), all.end());
    if (most < 0xff) return accessor(type_u8, "SCALAR", 1, std::vector<uint8_t>(all.begin(), all.end()));
    if (most < 0xffff) return accessor(type_u16, "SCALAR", 1, std::vector<uint16_t>(all.begin(), all.end()));
    return accessor(type_u32, "SCALAR", 1, all);
}

size_t GlbWriter::joints(const std::vector<uint16_t> &all) { return accessor(type_u16, "VEC4", 4, all); }

std::string GlbWriter::glb() const
{
    Json finished = json;
    if (!binary_.empty()) finished["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    std::string chunks;
    // Names of old files are in any encoding.
    append_chunk(chunks, "JSON", finished.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
    if (!binary_.empty()) append_chunk(chunks, "BIN\0", binary_, '\0');
    if (chunks.size() + 12 > 0xffffffffu) throw std::length_error("the scene is larger than a GLB may be");
    std::string out = "glTF";
    append_word(out, 2);
    append_word(out, chunks.size() + 12);
    return out + chunks;
}

}  // namespace convert
