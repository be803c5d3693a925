#include "samples/convert/losses.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace convert
{
namespace
{

constexpr double tolerance = 1e-4;  // exporters write 0.9999998 for 1

uint32_t word_at(const std::string &bytes, size_t at)
{
    uint32_t out = 0;
    for (size_t k = 4; k-- > 0 && at + 4 <= bytes.size();) out = out << 8 | static_cast<unsigned char>(bytes[at + k]);
    return out;
}

void find_in_iqm(const std::string &bytes, std::vector<std::string> &out)
{
    const uint32_t joints = word_at(bytes, 68), clips = word_at(bytes, 84);
    if (joints == 0 && clips == 0) return;
    out.push_back("its skeleton of " + std::to_string(joints) + " joints and its " + std::to_string(clips) +
                  " clips are lost, because Assimp reads neither from IQM: for a character that moves, export glTF "
                  "from the program that made it, or from Blender");
}

using Three = std::array<double, 3>;

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

// How many properties of this name in the file's objects have numbers that are so. Its templates come before them.
template <class IsSo>
size_t count(const std::string &bytes, const std::string &name, const IsSo &is_so)
{
    const bool binary = bytes.compare(0, 18, "Kaydara FBX Binary") == 0;
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

bool is_not(const Three &numbers, double value)
{
    for (const double number : numbers)
        if (std::fabs(number - value) > tolerance) return true;
    return false;
}

bool is_uneven(const Three &scale)
{
    const double wanted = tolerance * std::fabs(scale[0]);
    return std::fabs(scale[1] - scale[0]) > wanted || std::fabs(scale[2] - scale[0]) > wanted;
}

void find_in_fbx(const std::string &bytes, std::vector<std::string> &out)
{
    size_t geometric = 0;
    for (const char *name : {"GeometricTranslation", "GeometricRotation"})
        geometric += count(bytes, name, [](const Three &numbers) { return is_not(numbers, 0); });
    geometric += count(bytes, "GeometricScaling", [](const Three &numbers) { return is_not(numbers, 1); });
    if (geometric > 0)
        out.push_back("it has geometric transforms (" + std::to_string(geometric) +
                      "), which move a mesh and not the nodes below it, and Assimp moves both: parts may stand "
                      "elsewhere; reset them before exporting (Reset XForm in 3ds Max), or export glTF");
    const auto inherits = [&](double type) {
        return count(bytes, "InheritType", [type](const Three &numbers) { return numbers[0] == type; });
    };
    const size_t uneven = count(bytes, "Lcl Scaling", is_uneven),
                 scaled = count(bytes, "Lcl Scaling", [](const Three &numbers) { return is_not(numbers, 1); });
    const size_t rrss = uneven > 0 ? inherits(0) : 0, rrs = scaled > 0 ? inherits(2) : 0;
    if (rrss + rrs > 0)
        out.push_back(std::to_string(rrss + rrs) + " nodes inherit scales by the rule " + (rrss > 0 ? "RrSs" : "Rrs") +
                      ", and Assimp takes all for RSrs: parts may have another size or place; export with scales "
                      "applied (Freeze Transformations in Maya), or export glTF");
}

}  // namespace

std::vector<std::string> losses_in(const std::string &bytes)
{
    std::vector<std::string> out;
    if (bytes.compare(0, 15, "INTERQUAKEMODEL") == 0) find_in_iqm(bytes, out);
    const bool is_text = bytes.find("FBXHeaderExtension:") < 4096;
    if (is_text || bytes.compare(0, 18, "Kaydara FBX Binary") == 0) find_in_fbx(bytes, out);
    return out;
}

}  // namespace convert
