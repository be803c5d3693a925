#include "tests/reference/asset_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace claque::reference
{
namespace
{

namespace fs = std::filesystem;

#ifdef CLAQUE_HAS_DRACO
constexpr clq_status no_draco = CLQ_OK;
#else
constexpr clq_status no_draco = CLQ_UNSUPPORTED;
#endif
#ifdef CLAQUE_HAS_MESHOPT
constexpr clq_status no_meshopt = CLQ_OK;
#else
constexpr clq_status no_meshopt = CLQ_UNSUPPORTED;
#endif
#ifdef CLAQUE_HAS_WEBP
constexpr clq_status no_webp = CLQ_OK;
#else
constexpr clq_status no_webp = CLQ_UNSUPPORTED;
#endif

constexpr std::array<Refusal, 9> refusals{{
    // Breaks the specification on purpose, as its own text says: sparse indices that repeat.
    {"conformance/magnum/mesh-sparse.gltf", CLQ_FORMAT, "sparse index"},
    // Where the library has no decoder, it names the extension.
    {"compressed/CesiumMan-Draco/CesiumMan.gltf", no_draco, "KHR_draco_mesh_compression"},
    {"compressed/Casual_Male-draco.gltf", no_draco, "KHR_draco_mesh_compression"},
    {"environment/kenney-town/fountain-round.glb", no_draco, "KHR_draco_mesh_compression"},
    {"environment/kenney-town/stairs-stone-round.glb", no_draco, "KHR_draco_mesh_compression"},
    {"environment/godot-town/town_model.gltf", no_webp, "EXT_texture_webp"},
    // Requires meshopt and WebP both; whichever is named first is right.
    {"compressed/valid-Asian_F_1_Busi.glb", no_meshopt != CLQ_OK ? no_meshopt : no_webp, "EXT_"},
    // Those that tests write: what requires an extension that claque does not know, and the same sparse indices.
    {"WrittenRequires.glb", CLQ_UNSUPPORTED, "EXT_structural_metadata"},
    {"WrittenRepeats.glb", CLQ_FORMAT, "sparse index"},
}};

// The reference unpacks nothing; tests/unit/asset compares what the library unpacks.
bool is_packed(const std::string &file)
{
    const Refusal *known = nullptr;
    for (const Refusal &refusal : refusals)
        if (file == refusal.file) known = &refusal;
    return known && known->named != std::string("EXT_texture_webp") && known->status != CLQ_FORMAT;
}

template <class Wanted>
std::vector<std::string> files_where(const Wanted &wanted)
{
    std::vector<std::string> files;
    const std::string folder = assets_folder();
    if (!folder.empty())
        for (const auto &entry : fs::recursive_directory_iterator(folder)) {
            const std::string relative = fs::relative(entry.path(), folder).generic_string();
            const std::string extension = entry.path().extension().string();
            const bool is_character = extension == ".gltf" || extension == ".glb";
            if (is_character && relative.rfind("hostile/", 0) != 0 && wanted(relative)) files.push_back(relative);
        }
    std::sort(files.begin(), files.end());
    if (files.empty()) files.push_back("");
    return files;
}

}  // namespace

std::string assets_folder()
{
    const std::string folder = std::string(CLAQUE_ASSETS_DIR) + "/";
    return fs::is_directory(folder) ? folder : std::string();
}

std::vector<std::string> loadable_files()
{
    return files_where([](const std::string &file) { return refusal_of(file) == nullptr && !is_packed(file); });
}

std::vector<std::string> refused_files()
{
    return files_where([](const std::string &file) { return refusal_of(file) != nullptr; });
}

std::string case_name(const std::string &file)
{
    std::string name;
    for (const char c : file) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name.empty() ? "no_assets" : name;
}

const Refusal *refusal_of(const std::string &file)
{
    for (const Refusal &refusal : refusals)
        if (file == refusal.file && refusal.status != CLQ_OK) return &refusal;
    return nullptr;
}

}  // namespace claque::reference
