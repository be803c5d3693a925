#include "samples/convert/pictures.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

#include "samples/convert/picture_codec.h"
#include "samples/io/files.h"

namespace convert
{
namespace
{

namespace fs = std::filesystem;

std::string lower(std::string text)
{
    for (char &c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string slashed(std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::string base_of(const std::string &name)
{
    const std::string path = slashed(name);
    return path.substr(path.find_last_of('/') + 1);
}

// Old files name pictures by paths of machines that are gone, and in any case: the base name counts, in the folder of
// the file and in those below it.
std::string find_below(const fs::path &folder, const std::string &name)
{
    std::error_code ignored;
    std::vector<std::string> found;
    const std::string wanted = lower(base_of(name));
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, ignored), end;
    for (int entries = 0; at != end && entries < 10000; at.increment(ignored), ++entries) {
        if (at.depth() >= 2) at.disable_recursion_pending();
        if (at->is_regular_file(ignored) && lower(at->path().filename().string()) == wanted)
            found.push_back(at->path().string());
    }
    // The nearest, and of those the first by name: the order of a folder's entries is the file system's.
    std::sort(found.begin(), found.end(), [](const std::string &a, const std::string &b) {
        const auto depth = [](const std::string &path) { return std::count(path.begin(), path.end(), '/'); };
        return depth(a) != depth(b) ? depth(a) < depth(b) : a < b;
    });
    return found.empty() ? "" : found[0];
}

std::string bytes_of_file(const std::string &path)
{
    std::string bytes;
    (void)io::read_whole(path, bytes, most_picture_bytes);  // the caller warns
    return bytes;
}

// A picture in the file itself.
std::string bytes_of_embedded(const aiTexture &from)
{
    if (from.mHeight == 0) return as_png_or_jpeg(std::string(reinterpret_cast<const char *>(from.pcData), from.mWidth));
    std::string rgba;
    for (size_t i = 0; i < size_t(from.mWidth) * from.mHeight; ++i) {
        const aiTexel &texel = from.pcData[i];
        for (const uint8_t value : {texel.r, texel.g, texel.b, texel.a}) rgba += static_cast<char>(value);
    }
    return png_of(rgba, from.mWidth, from.mHeight);
}

}  // namespace

std::optional<size_t> Pictures::add(const std::string &bytes, const std::string &name)
{
    if (bytes.empty()) return std::nullopt;
    const char *type = bytes[0] == '\x89' ? "image/png" : "image/jpeg";
    const size_t image = scene_.glb.add(
        "images", {{"name", name}, {"mimeType", type}, {"bufferView", scene_.glb.bytes(bytes.data(), bytes.size())}});
    return scene_.glb.add("textures", {{"source", image}});
}

std::optional<size_t> Pictures::texture_of_file(const std::string &path)
{
    const auto [place, is_new] = known_.emplace("file " + path, std::nullopt);
    if (!is_new) return place->second;
    const std::string bytes = bytes_of_file(path);
    place->second = add(as_png_or_jpeg(bytes), base_of(path));
    if (place->second && convert::has_holes(bytes)) with_holes_.insert(*place->second);
    if (!place->second) scene_.warn("the picture " + path + " is missing or no picture that is read");
    return place->second;
}

std::optional<size_t> Pictures::texture_of(const std::string &name, const std::string &material)
{
    const auto [place, is_new] = known_.emplace(name, std::nullopt);
    if (!is_new) {
        if (!place->second) missing_[name].push_back(material);
        return place->second;
    }
    if (const aiTexture *embedded = scene_.from.GetEmbeddedTexture(name.c_str())) {
        place->second = add(bytes_of_embedded(*embedded), base_of(name));
    } else {
        const fs::path folder = fs::path(scene_.path).parent_path();
        const std::string found = find_below(folder.empty() ? fs::path(".") : folder, name);
        if (!found.empty()) place->second = add(as_png_or_jpeg(bytes_of_file(found)), base_of(found));
    }
    if (!place->second) missing_[name].push_back(material);
    return place->second;
}

void Pictures::warn_of_missing() const
{
    for (const auto &[picture, materials] : missing_)
        scene_.warn(
            "the picture '" + base_of(picture) + "' is missing or no picture that is read: " + listed(materials) +
            (materials.size() == 1 ? " shows its" : " show their") + " base colour; --picture FILE gives them one");
}

}  // namespace convert
