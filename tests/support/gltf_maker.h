// Makes small glTF files for tests: an accessor at a time into one buffer, written as GLB or as JSON with a data URI.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace claque::testing
{

using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;

constexpr int i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126;

class Maker
{
public:
    Maker() { json = {{"asset", {{"version", "2.0"}}}}; }

    // A buffer view over these bytes; returns its index.
    template <class T>
    int view(const std::vector<T> &values)
    {
        while (binary.size() % 4 != 0) binary.push_back(0);
        const size_t at = binary.size();
        binary.resize(at + values.size() * sizeof(T));
        std::memcpy(binary.data() + at, values.data(), values.size() * sizeof(T));
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", values.size() * sizeof(T)}});
    }

    template <class T>
    int accessor(int component, const char *type, size_t count, const std::vector<T> &values)
    {
        return add("accessors",
                   {{"componentType", component}, {"type", type}, {"count", count}, {"bufferView", view(values)}});
    }
    int floats(const char *type, size_t count, const std::vector<float> &v) { return accessor(f32, type, count, v); }

    int add(const char *list, Json element)
    {
        json[list].push_back(std::move(element));
        return static_cast<int>(json[list].size()) - 1;
    }

    // One triangle, its mesh and a node in scene 0; more attributes can be set on primitive().
    void triangle()
    {
        const int positions = floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
        add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}}}}})}});
        add("nodes", {{"mesh", 0}});
        json["scenes"] = Json::array({{{"nodes", {0}}}});
    }
    Json &primitive() { return json["meshes"][0]["primitives"][0]; }

    Bytes glb() const { return glb_of(finished().dump()); }
    Bytes text() const
    {
        const std::string s = finished().dump();
        return Bytes(s.begin(), s.end());
    }

    Bytes glb_of(std::string head) const
    {
        while (head.size() % 4 != 0) head.push_back(' ');
        Bytes body = binary;
        while (body.size() % 4 != 0) body.push_back(0);
        Bytes out = {'g', 'l', 'T', 'F'};
        const auto word = [&](size_t x) {
            for (int k = 0; k < 4; ++k) out.push_back(static_cast<uint8_t>(x >> (8 * k)));
        };
        word(2);
        word(12 + 8 + head.size() + (body.empty() ? 0 : 8 + body.size()));
        word(head.size());
        word(0x4e4f534a);
        out.insert(out.end(), head.begin(), head.end());
        if (body.empty()) return out;
        word(body.size());
        word(0x004e4942);
        out.insert(out.end(), body.begin(), body.end());
        return out;
    }

    Json json;
    Bytes binary;

private:
    Json finished() const
    {
        Json out = json;
        if (!binary.empty() && !out.contains("buffers"))
            out["buffers"] = Json::array({{{"byteLength", binary.size()}}});
        return out;
    }
};

}  // namespace claque::testing
