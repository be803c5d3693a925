#include "samples/convert/losses.h"

#include <cmath>

#include "samples/convert/fbx_bytes.h"

namespace convert
{
namespace
{

constexpr double tolerance = 1e-4;  // exporters write 0.9999998 for 1

void find_in_iqm(const std::string &bytes, std::vector<std::string> &out)
{
    const uint32_t joints = word_at(bytes, 68), clips = word_at(bytes, 84);
    if (joints == 0 && clips == 0) return;
    out.push_back("its skeleton of " + std::to_string(joints) + " joints and its " + std::to_string(clips) +
                  " clips are lost, because Assimp reads neither from IQM: for a character that moves, export glTF "
                  "from the program that made it, or from Blender");
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
    if (is_text || is_binary_fbx(bytes)) find_in_fbx(bytes, out);
    return out;
}

}  // namespace convert
