// Surfaces, skins and channels as accessors of a glTF file.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tests/support/gltf_maker.h"
#include "tests/support/written_shapes.h"

namespace claque::testing
{

// Three floats an element, with the bounds that POSITION needs.
int add_triples(Maker &maker, const std::vector<Triple> &values);

// How JOINTS_n and WEIGHTS_n are stored; weights of integers are normalized.
struct InfluenceFormat {
    size_t sets = 1;
    int joints = u8, weights = f32;
};

// Four influences of each vertex in a row, from influence number 4 * set on; the weights add up to 1 over all sets.
std::vector<uint16_t> joints_of(const Surface &surface, size_t set);
std::vector<float> weights_of(const Surface &surface, size_t set);

// Positions, normals, texture coordinates, influences where there are any, and indices of 16 bits.
Json primitive_of(Maker &maker, const Surface &surface, int material, const InfluenceFormat &format = {});

// Numbers, rounded, as normalized integers of one type.
template <class T>
std::vector<T> normalized_of(const std::vector<float> &values)
{
    std::vector<T> out;
    const float most = static_cast<float>(std::numeric_limits<T>::max());
    for (const float value : values) out.push_back(static_cast<T>(value * most + (value < 0 ? -0.5f : 0.5f)));
    return out;
}

// An image and the texture of the same number; the bytes lie in the buffer.
int add_texture(Maker &maker, const Bytes &png);

// A material of this name; `texture` < 0: its colour alone.
int add_material(Maker &maker, const char *name, int texture, std::array<float, 4> colour = {1, 1, 1, 1});

std::string base64_of(const Bytes &bytes);

}  // namespace claque::testing
