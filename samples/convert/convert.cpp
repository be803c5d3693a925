#include "samples/convert/convert.h"

#include <nlohmann/json.hpp>

#include "samples/convert/import.h"
#include "samples/io/json.h"
#include "samples/io/regular_file.h"
#include "samples/scenes/check.h"

namespace convert
{

#ifdef CLAQUE_HAS_ASSIMP

namespace
{

// What the child sends: the warnings as a line of JSON, then the GLB.
std::string packed(const Converted &converted)
{
    using Json = nlohmann::json;
    return Json(converted.warnings).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" + converted.glb;
}

// `what`: the child, which reads files that may damage it.
Converted unpacked(const std::string &what, std::string bytes)
{
    const size_t line = bytes.find('\n');
    Converted out;
    std::string problem;
    const auto warnings = io::parse_json<nlohmann::json>(bytes.substr(0, line), problem);
    if (!problem.empty()) throw scenes::Failure(what + " gave warnings whose text " + problem);
    out.warnings = warnings.get<std::vector<std::string>>();
    bytes.erase(0, line + 1);
    out.glb = std::move(bytes);
    return out;
}

// Assimp reads one version of several.
bool is_binary_mesh_of_ogre(const std::string &path)
{
    char begin[18] = {};  // a number of two bytes, and the text
    const io::RegularFile in(path, most_picture_bytes);
    return in.wrong().empty() && in.read(0, begin, sizeof begin) &&
           std::string(begin, sizeof begin).find("[MeshSerializer_") != std::string::npos;
}

}  // namespace

Converted convert_file(const std::string &path, const Options &options, const Limits &limits)
{
    const std::string what = "reading " + path + " by Assimp";
    try {
        return unpacked(what, run_in_child(what, limits, [&] { return packed(import_file(path, options)); }));
    } catch (const scenes::Failure &failure) {
        if (!is_binary_mesh_of_ogre(path)) throw;
        throw scenes::Failure(
            failure.what() + std::string("; OgreXMLConverter (package ogre-1.12-tools) makes Ogre XML, which is read"));
    }
}

#else

Converted convert_file(const std::string &path, const Options &, const Limits &)
{
    throw scenes::Failure(path +
                          " cannot be converted: this claque was built without Assimp; install libassimp-dev "
                          "and build again");
}

#endif

}  // namespace convert
