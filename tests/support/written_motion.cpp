#include "tests/support/written_motion.h"

#include <cmath>

namespace claque::testing
{

Four turn(const Triple &axis, float degrees)
{
    const float half = degrees * 0.00872664626f;
    const Triple part = times(unit(axis), std::sin(half));
    return {part[0], part[1], part[2], std::cos(half)};
}

std::vector<float> times_from(float first, float step, size_t count)
{
    std::vector<float> out;
    for (size_t i = 0; i < count; ++i) out.push_back(first + step * static_cast<float>(i));
    return out;
}

std::vector<float> turns(const Triple &axis, const std::vector<float> &degrees)
{
    std::vector<float> out;
    for (const float angle : degrees) {
        const Four rotation = turn(axis, angle);
        out.insert(out.end(), rotation.begin(), rotation.end());
    }
    return out;
}

std::vector<float> with_tangents(const std::vector<float> &values, size_t width, float bend)
{
    std::vector<float> out;
    const size_t keys = values.size() / width;
    for (size_t key = 0; key < keys; ++key) {
        const size_t before = key == 0 ? 0 : key - 1, after = key + 1 == keys ? key : key + 1;
        for (const int part : {0, 1, 2})
            for (size_t k = 0; k < width; ++k) {
                const float slope = values[after * width + k] - values[before * width + k];
                out.push_back(part == 1 ? values[key * width + k] : bend * slope * (part == 0 ? 1.0f : 1.5f));
            }
    }
    return out;
}

void ClipMaker::add(int node, const char *path, const char *interpolation, const std::vector<float> &times,
                    const std::vector<float> &values)
{
    const std::string target = path;
    const char *const type = target == "rotation" ? "VEC4" : target == "weights" ? "SCALAR" : "VEC3";
    const size_t width = target == "rotation" ? 4 : target == "weights" ? 1 : 3;
    add(node, path, interpolation, times, maker_.floats(type, values.size() / width, values));
}

void ClipMaker::add(int node, const char *path, const char *interpolation, const std::vector<float> &times, int output)
{
    const int input = maker_.floats("SCALAR", times.size(), times);
    Json &accessor = maker_.json["accessors"][static_cast<size_t>(input)];
    accessor["min"] = Json::array({times.front()}), accessor["max"] = Json::array({times.back()});
    animation_["channels"].push_back(
        {{"sampler", animation_["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation_["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

}  // namespace claque::testing
