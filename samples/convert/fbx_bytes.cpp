#include "samples/convert/fbx_bytes.h"

#include <cstdlib>
#include <cstring>

namespace convert
{
namespace
{

// The numbers behind the name of a property of binary FBX: three texts, then a letter for the type of each number.
bool binary_numbers(const std::string &bytes, size_t at, Three &out)
{
    for (int text = 0; text < 3; ++text) {
        if (at + 5 > bytes.size() || bytes[at] != 'S') return false;
        const size_t length = word_at(bytes, at + 1);
        if (length > bytes.size() - at - 5) return false;
        at += 5 + length;
    }
    for (double &number : out) {
        const char type = at < bytes.size() ? bytes[at] : char(0);
        const size_t size = type == 'D' ? 8 : type == 'F' || type == 'I' ? 4 : 0;
        if (size == 0 || at + 1 + size > bytes.size()) return &number != &out[0];
        float single = 0;
        if (type == 'D') std::memcpy(&number, &bytes[at + 1], 8);
        else if (type == 'F') std::memcpy(&single, &bytes[at + 1], 4), number = double(single);
        else number = double(static_cast<int32_t>(word_at(bytes, at + 1)));
        at += 1 + size;
    }
    return true;
}

// The same of its text form: "Name", "type", "label", "flags",1,2,3
bool text_numbers(const std::string &bytes, size_t at, Three &out)
{
    for (int comma = 0; comma < 4; ++comma, ++at) {
        at = bytes.find_first_of(",\n", at);
        if (at == std::string::npos || bytes[at] == '\n') return false;
    }
    for (double &number : out) {
        const std::string text = bytes.substr(at, 40);
        char *end = nullptr;
        const double found = std::strtod(text.c_str(), &end);
        if (end == text.c_str()) return &number != &out[0];
        number = found;
        at += static_cast<size_t>(end - text.c_str());
        if (at >= bytes.size() || bytes[at] != ',') return true;
        ++at;
    }
    return true;
}

std::string text_of(const std::string &text)
{
    const auto size = static_cast<uint32_t>(text.size());
    std::string out = "S";
    for (int k = 0; k < 4; ++k) out += static_cast<char>(size >> 8 * k & 255);
    return out + text;
}

}  // namespace

uint32_t word_at(const std::string &bytes, size_t at)
{
    uint32_t out = 0;
    for (size_t k = 4; k-- > 0 && at + 4 <= bytes.size();) out = out << 8 | static_cast<unsigned char>(bytes[at + k]);
    return out;
}

bool is_binary_fbx(const std::string &bytes) { return bytes.compare(0, 18, "Kaydara FBX Binary") == 0; }

size_t count(const std::string &bytes, const std::string &name, const std::function<bool(const Three &)> &is_so)
{
    const bool binary = is_binary_fbx(bytes);
    size_t at = bytes.find(binary ? "\x07Objects" : "\nObjects:"), found = 0;
    if (at == std::string::npos) return 0;
    while ((at = bytes.find(name, at)) != std::string::npos) {
        // The text of a property's type may be the name again.
        const bool is_name = binary || (at >= 4 && bytes.compare(at - 4, 4, "P: \"") == 0);
        at += name.size();
        Three numbers = {0, 0, 0};
        if (is_name && (binary ? binary_numbers : text_numbers)(bytes, at, numbers)) found += is_so(numbers);
    }
    return found;
}

bool is_last_saved_by(const std::string &bytes, const std::string &program)
{
    constexpr size_t header_bytes = 65536, value_bytes = 64;  // type and flags stand before the value
    const std::string head = bytes.substr(0, header_bytes), name = "LastSaved|ApplicationName";
    const size_t at = head.find(name);
    return at != std::string::npos && head.substr(at + name.size(), value_bytes).find(program) != std::string::npos;
}

bool find_diffuse_colour(const std::string &bytes, const std::string &material, Three &out)
{
    if (!is_binary_fbx(bytes)) return false;
    const std::string name = text_of("DiffuseColor"), mark("\0\1Material", 10);
    const size_t at = bytes.find(text_of(material + mark));
    if (at == std::string::npos) return false;
    const size_t found = bytes.find(name, at), next = bytes.find(mark, at + 5 + material.size() + mark.size());
    return found < next && binary_numbers(bytes, found + name.size(), out);
}

}  // namespace convert
