// Numbers of properties in the bytes of an FBX file, for what Assimp does not pass on. The bytes may be anything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace convert
{

using Three = std::array<double, 3>;

uint32_t word_at(const std::string &bytes, size_t at);  // of four bytes, the lowest first
bool is_binary_fbx(const std::string &bytes);
// How many properties of this name in the file's objects have numbers that are so. Its templates come before them.
size_t count(const std::string &bytes, const std::string &name, const std::function<bool(const Three &)> &is_so);
// Whether the file names a program whose name begins so as the last one that saved it.
bool is_last_saved_by(const std::string &bytes, const std::string &program);
// The DiffuseColor of a material in binary FBX, without its factor; false where it has none of its own.
bool find_diffuse_colour(const std::string &bytes, const std::string &material, Three &out);

}  // namespace convert
