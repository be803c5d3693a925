// Writes glTF files for `claque bench readers`.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace cli
{

constexpr int gltf_float = 5126, gltf_byte = 5121, gltf_uint = 5125;

// A glTF file with one buffer, written as GLB: a triangle on node 0 to begin with.
class GltfFile
{
public:
    GltfFile()
    {
        json_ = {{"asset", {{"version", "2.0"}}}, {"scenes", nlohmann::json::array({{{"nodes", {0}}}})}};
        add("nodes", {{"mesh", 0}, {"name", "first"}});
        add("meshes",
            {{"primitives", nlohmann::json::array({{{"attributes", {{"POSITION", floats("VEC3", triangle)}}}}})}});
    }

    size_t add(const char *list, nlohmann::json element)
    {
        json_[list].push_back(std::move(element));
        return json_[list].size() - 1;
    }
    size_t floats(const char *type, const std::vector<float> &values)
    {
        const size_t width = std::strcmp(type, "SCALAR") == 0 ? 1 : size_t(type[3] - '0');
        return accessor(gltf_float, type, values.size() / width, values.data(), values.size() * sizeof(float));
    }
    size_t accessor(int component, const char *type, size_t count, const void *values, size_t bytes)
    {
        const size_t view = buffer_view(values, bytes);
        return add("accessors", {{"componentType", component}, {"type", type}, {"count", count}, {"bufferView", view}});
    }
    size_t bytes(const std::vector<unsigned char> &values) { return buffer_view(values.data(), values.size()); }
    // One more node in the scene.
    size_t node(nlohmann::json node)
    {
        const size_t at = add("nodes", std::move(node));
        json_["scenes"][0]["nodes"].push_back(at);
        return at;
    }
    // A clip with these channels, of two keys each.
    nlohmann::json clip(const nlohmann::json &channels)
    {
        if (!has_keys_) times_ = floats("SCALAR", {0, 1}), places_ = floats("VEC3", {0, 0, 0, 1, 0, 0});
        has_keys_ = true;
        return {{"channels", channels},
                {"samplers", nlohmann::json::array({{{"input", times_}, {"output", places_}}})}};
    }
    nlohmann::json &json() { return json_; }
    nlohmann::json &primitive() { return json_["meshes"][0]["primitives"][0]; }

    std::string glb()
    {
        nlohmann::json &buffers = json_["buffers"];
        if (buffers.is_null()) buffers = nlohmann::json::array();
        buffers.insert(buffers.begin(), nlohmann::json::object({{"byteLength", binary_.size()}}));
        std::string head = json_.dump();
        head.append((4 - head.size() % 4) % 4, ' ');
        std::string out = "glTF";
        const auto word = [&](size_t x) {
            for (int k = 0; k < 4; ++k) out.push_back(static_cast<char>(x >> (8 * k) & 0xff));
        };
        word(2), word(12 + 8 + head.size() + 8 + binary_.size());
        word(head.size()), word(0x4e4f534a);
        out += head;
        word(binary_.size()), word(0x004e4942);
        return out + binary_;
    }

    inline static const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

private:
    size_t buffer_view(const void *values, size_t bytes)
    {
        const size_t at = binary_.size();
        binary_.append(static_cast<const char *>(values), bytes);
        binary_.append((4 - bytes % 4) % 4, '\0');
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes}});
    }

    nlohmann::json json_;
    std::string binary_;
    bool has_keys_ = false;
    size_t times_ = 0, places_ = 0;
};

}  // namespace cli
