// Writes a glTF 2.0 file: JSON, and a binary chunk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace parity
{

class Glb
{
public:
    using Json = nlohmann::ordered_json;

    // glTF's constants.
    static constexpr int unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125, real = 5126;

    // The whole document except buffers, bufferViews and accessors, which these calls fill.
    Json json;

    // Index of a new bufferView. target: 34962 vertices, 34963 indices, 0 neither.
    size_t view(const void *bytes, size_t size_bytes, int target = 0);

    // Index of a new accessor of `count` values in a view of their own.
    template <class Value>
    size_t accessor(const Value *values, size_t count, const char *type, int component, int target,
                    bool normalised = false)
    {
        Json made = {{"bufferView", view(values, count * width_of(type) * sizeof(Value), target)},
                     {"componentType", component},
                     {"count", count},
                     {"type", type}};
        if (normalised) made["normalized"] = true;
        return add(made);
    }
    size_t add(const Json &accessor);

    std::string file() const;

private:
    static size_t width_of(const std::string &type)
    {
        return type == "SCALAR" ? 1 : static_cast<size_t>(type.back() - '0');
    }

    std::string bytes_;
    Json views_ = Json::array(), accessors_ = Json::array();
};

}  // namespace parity
