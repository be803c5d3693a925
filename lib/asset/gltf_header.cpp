#include "lib/asset/gltf_header.h"

#include <cstdlib>
#include <string_view>

#include "lib/asset/decoders.h"

namespace claque::asset
{

using base::fail;

namespace
{

struct Version {
    long major = 0, minor = 0;
};

Version version_of(const JsonView &view)
{
    const std::string &text = view.text();
    const size_t dot = text.find('.');
    const bool good = dot != std::string::npos && dot > 0 && dot + 1 < text.size() && text.size() < 12 &&
                      text.find_first_not_of("0123456789") == dot &&
                      text.find_first_not_of("0123456789", dot + 1) == std::string::npos;
    if (!good) fail(CLQ_FORMAT, "%s is '%.40s' instead of two numbers and a dot", view.path().c_str(), text.c_str());
    return {std::strtol(text.c_str(), nullptr, 10), std::strtol(text.c_str() + dot + 1, nullptr, 10)};
}

void check_version(const JsonView &asset)
{
    const Version made = version_of(asset["version"]);
    const Version least = asset["minVersion"].exists() ? version_of(asset["minVersion"]) : Version{made.major, 0};
    if (made.major != 2) fail(CLQ_UNSUPPORTED, "glTF version %ld.%ld: version 2 is read", made.major, made.minor);
    if (least.major > 2 || (least.major == 2 && least.minor > 0))
        fail(CLQ_UNSUPPORTED, "the file asks for glTF %ld.%ld at least: 2.0 is read", least.major, least.minor);
}

// Extensions that a file may require: those that are supported, those without a visible effect in GL 1.1, and those
// that are checked where they are used.
constexpr std::string_view followed[] = {
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_lights_punctual",
    "KHR_xmp_json_ld",
    "KHR_xmp",
    "EXT_texture_webp",
    "KHR_texture_basisu",
    "MSFT_texture_dds",
    "EXT_texture_avif",
    "EXT_mesh_gpu_instancing",
};

bool is_followed(std::string_view name)
{
    for (const std::string_view known : followed)
        if (name == known) return true;
    constexpr std::string_view looks = "KHR_materials_";
    return name.substr(0, looks.size()) == looks;
}

}  // namespace

void check_header(const JsonView &document)
{
    check_version(document["asset"]);
    const JsonView used = document["extensionsUsed"], required = document["extensionsRequired"];
    for (size_t i = 0; i < used.count(); ++i) used.at(i).text();
    for (size_t i = 0; i < required.count(); ++i) {
        const std::string &name = required.at(i).text();
        Decoder decoder = Decoder::draco;
        if (is_followed(name)) continue;
        if (!decoder_of(name, decoder)) fail(CLQ_UNSUPPORTED, "the file requires the extension %.100s", name.c_str());
        if (!has_decoder(decoder)) refuse_without(decoder, "the file");
    }
}

}  // namespace claque::asset
