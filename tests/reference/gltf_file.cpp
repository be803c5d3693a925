#include "tests/reference/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace claque::reference
{
namespace
{

using Bytes = std::vector<unsigned char>;

Bytes read_bytes(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot open " + path);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

uint32_t word_at(const Bytes &bytes, size_t offset)
{
    uint32_t word = 0;
    for (size_t i = 0; i < 4; ++i) word |= static_cast<uint32_t>(bytes.at(offset + i)) << (8 * i);
    return word;
}

Bytes decode_base64(const std::string &text, size_t first)
{
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int, 256> value{};
    value.fill(-1);
    for (size_t i = 0; i < digits.size(); ++i) value[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
    Bytes bytes;
    uint32_t bits = 0;
    int held = 0;
    for (size_t i = first; i < text.size(); ++i) {
        const int digit = value[static_cast<unsigned char>(text[i])];
        if (digit < 0) continue;
        bits = (bits << 6) | static_cast<uint32_t>(digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<unsigned char>((bits >> held) & 255));
    }
    return bytes;
}

std::string decode_percent(const std::string &uri)
{
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool escaped = uri[i] == '%' && i + 2 < uri.size();
        text += escaped ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
        if (escaped) i += 2;
    }
    return text;
}

template <typename T>
double as(const unsigned char *at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

size_t component_bytes(int type)
{
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
    }
    throw std::runtime_error("component type " + std::to_string(type));
}

double component(int type, bool normalized, const unsigned char *at)
{
    switch (type) {
        case 5120:
            return normalized ? std::max(as<int8_t>(at) / 127, -1.0) : as<int8_t>(at);
        case 5121:
            return normalized ? as<uint8_t>(at) / 255 : as<uint8_t>(at);
        case 5122:
            return normalized ? std::max(as<int16_t>(at) / 32767, -1.0) : as<int16_t>(at);
        case 5123:
            return normalized ? as<uint16_t>(at) / 65535 : as<uint16_t>(at);
        case 5125:
            return as<uint32_t>(at);
    }
    return as<float>(at);
}

struct ElementShape {
    size_t columns, rows;
};

ElementShape shape_of(const std::string &type)
{
    if (type == "SCALAR") return {1, 1};
    const size_t n = static_cast<size_t>(type.back() - '0');
    return type[0] == 'M' ? ElementShape{n, n} : ElementShape{1, n};
}

// Columns of matrices of small components start at multiples of four bytes.
size_t column_bytes(const ElementShape &shape, int type)
{
    const size_t bytes = shape.rows * component_bytes(type);
    return shape.columns > 1 ? (bytes + 3) / 4 * 4 : bytes;
}

}  // namespace

GltfFile::GltfFile(const std::string &path)
{
    const Bytes bytes = read_bytes(path);
    if (bytes.size() >= 20 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
        for (size_t at = 12; at + 8 <= bytes.size();) {
            const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at + 8);
            const auto last = first + static_cast<std::ptrdiff_t>(word_at(bytes, at));
            if (word_at(bytes, at + 4) == 0x4e4f534a) json_ = nlohmann::json::parse(first, last);
            if (word_at(bytes, at + 4) == 0x004e4942 && glb_chunk_.empty()) glb_chunk_.assign(first, last);
            at += 8 + word_at(bytes, at);
        }
    } else {
        json_ = nlohmann::json::parse(bytes.begin(), bytes.end());
    }
    const std::string folder = path.substr(0, path.find_last_of('/') + 1);
    for (const auto &buffer : list("buffers")) load_buffer(buffer, folder);
}

const nlohmann::json &GltfFile::list(const char *name) const
{
    static const nlohmann::json empty = nlohmann::json::array();
    const auto found = json_.find(name);
    return found == json_.end() ? empty : *found;
}

void GltfFile::load_buffer(const nlohmann::json &buffer, const std::string &folder)
{
    const std::string uri = buffer.value("uri", "");
    if (uri.empty()) buffers_.push_back(glb_chunk_);
    else if (uri.compare(0, 5, "data:") == 0) buffers_.push_back(decode_base64(uri, uri.find(',') + 1));
    else buffers_.push_back(read_bytes(folder + decode_percent(uri)));
}

const unsigned char *GltfFile::address(size_t view, size_t offset_bytes) const
{
    const auto &v = list("bufferViews").at(view);
    return &buffers_.at(v.at("buffer").get<size_t>()).at(v.value("byteOffset", size_t{0}) + offset_bytes);
}

std::vector<double> GltfFile::numbers(size_t index) const
{
    const auto &accessor = list("accessors").at(index);
    const int type = accessor.at("componentType");
    const bool normalized = accessor.value("normalized", false);
    const size_t count = accessor.at("count");
    const ElementShape shape = shape_of(accessor.at("type"));
    const size_t width = shape.columns * shape.rows;
    const size_t packed = shape.columns * column_bytes(shape, type);
    std::vector<double> result(count * width, 0.0);

    const auto read_element = [&](size_t element, const unsigned char *at) {
        for (size_t c = 0; c < shape.columns; ++c)
            for (size_t r = 0; r < shape.rows; ++r)
                result.at(element * width + c * shape.rows + r) =
                    component(type, normalized, at + c * column_bytes(shape, type) + r * component_bytes(type));
    };
    if (accessor.contains("bufferView")) {
        const size_t view = accessor["bufferView"];
        const size_t stride = list("bufferViews").at(view).value("byteStride", packed);
        const size_t offset = accessor.value("byteOffset", size_t{0});
        for (size_t i = 0; i < count; ++i) read_element(i, address(view, offset + i * stride));
    }
    if (accessor.contains("sparse")) {
        const auto &sparse = accessor["sparse"];
        const auto &where = sparse.at("indices");
        const auto &what = sparse.at("values");
        const int where_type = where.at("componentType");
        for (size_t i = 0; i < sparse.at("count").get<size_t>(); ++i) {
            const size_t at = where.value("byteOffset", size_t{0}) + i * component_bytes(where_type);
            const size_t from = what.value("byteOffset", size_t{0}) + i * packed;
            read_element(static_cast<size_t>(component(where_type, false, address(where.at("bufferView"), at))),
                         address(what.at("bufferView"), from));
        }
    }
    return result;
}

}  // namespace claque::reference
