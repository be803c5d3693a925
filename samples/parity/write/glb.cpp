#include "samples/parity/write/glb.h"

namespace parity
{
namespace
{

constexpr size_t alignment = 4;  // of chunks, and of every view, which suits all component types

void append(std::string &out, uint32_t number)
{
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(number >> shift & 255);
}

void append_chunk(std::string &out, const std::string &bytes, uint32_t kind)
{
    append(out, static_cast<uint32_t>(bytes.size()));
    append(out, kind);
    out += bytes;
}

}  // namespace

size_t Glb::view(const void *bytes, size_t size_bytes, int target)
{
    Json made = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size_bytes}};
    if (target != 0) made["target"] = target;
    bytes_.append(static_cast<const char *>(bytes), size_bytes);
    bytes_.append((alignment - bytes_.size() % alignment) % alignment, '\0');
    views_.push_back(made);
    return views_.size() - 1;
}

size_t Glb::add(const Json &accessor)
{
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
}

std::string Glb::file() const
{
    Json whole = json;
    whole["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    whole["bufferViews"] = views_;
    whole["accessors"] = accessors_;
    std::string text = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.append((alignment - text.size() % alignment) % alignment, ' ');
    std::string chunks, out;
    append_chunk(chunks, text, 0x4E4F534A);    // "JSON"
    append_chunk(chunks, bytes_, 0x004E4942);  // "BIN"
    append(out, 0x46546C67);                   // "glTF"
    append(out, 2);
    append(out, static_cast<uint32_t>(12 + chunks.size()));
    return out + chunks;
}

}  // namespace parity
