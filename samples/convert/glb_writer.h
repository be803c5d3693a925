// Writes GLB: JSON as a tree, numbers as accessors of one buffer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace convert
{

using Json = nlohmann::json;

class GlbWriter
{
public:
    GlbWriter();

    size_t add(const char *list, Json element);  // returns its index

    size_t bytes(const void *bytes, size_t size);                    // a buffer view
    size_t floats(const char *type, const std::vector<float> &all);  // an accessor; type: SCALAR, VEC2 ... MAT4
    size_t positions(const std::vector<float> &xyz);                 // VEC3, with its range
    size_t times(const std::vector<float> &seconds);                 // SCALAR, with its range
    size_t indices(const std::vector<uint32_t> &all);                // as short as they fit
    size_t joints(const std::vector<uint16_t> &all);                 // VEC4

    std::string glb() const;  // throws std::length_error beyond 4 GiB

    Json json;

private:
    template <class T>
    size_t accessor(int component, const char *type, size_t width, const std::vector<T> &all);

    std::string binary_;
};

}  // namespace convert
