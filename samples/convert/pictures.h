// Finds the pictures that materials name, and makes textures of them.
#pragma once

#include <map>
#include <optional>

#include "samples/convert/scene.h"

namespace convert
{

class Pictures
{
public:
    explicit Pictures(Scene &scene) : scene_(scene) {}

    // The texture of the GLB; none, with a warning, if the picture is missing or no picture.
    std::optional<size_t> texture_of(const std::string &name, const std::string &material);
    // Of a file that the user names.
    std::optional<size_t> texture_of_file(const std::string &path);

private:
    std::optional<size_t> add(const std::string &bytes, const std::string &name);

    Scene &scene_;
    std::map<std::string, std::optional<size_t>> known_;
};

}  // namespace convert
