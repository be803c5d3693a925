// Finds the pictures that materials name, and makes textures of them.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "samples/convert/scene.h"

namespace convert
{

class Pictures
{
public:
    explicit Pictures(Scene &scene) : scene_(scene) {}

    // The texture of the GLB; none if the picture is missing or no picture.
    std::optional<size_t> texture_of(const std::string &name, const std::string &material);
    // Of a file that the user names.
    std::optional<size_t> texture_of_file(const std::string &path);
    // Names each picture that is missing, and the materials that show their base colour for it.
    void warn_of_missing() const;
    bool has_holes(size_t texture) const { return with_holes_.count(texture) != 0; }  // of a file that the user names

private:
    std::optional<size_t> add(const std::string &bytes, const std::string &name);

    Scene &scene_;
    std::map<std::string, std::optional<size_t>> known_;
    std::map<std::string, std::vector<std::string>> missing_;  // materials by picture
    std::set<size_t> with_holes_;
};

}  // namespace convert
