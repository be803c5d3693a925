#include "samples/cli/characters.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <unistd.h>

#include "samples/cli/files.h"
#include "samples/cli/progress.h"
#include "samples/io/ending.h"
#include "samples/io/regular_file.h"

namespace cli
{

using scenes::check;

namespace
{

bool is_builtin(const std::string &path)
{
    // A name without folder or extension, and no such file.
    return path.find_first_of("./") == std::string::npos && access(path.c_str(), F_OK) != 0;
}

// `hidden`: lives as long as the options.
clq_asset_options options_of(std::vector<const char *> &hidden, const FileArguments &of_file,
                             const ClipArguments &clips)
{
    clq_asset_options options = clq_asset_options_init();
    of_file.placement.give(options, hidden);
    options.bvh_metres_per_unit = clips.unit_m;
    return options;
}

}  // namespace

clq_template *in_levels(scenes::Library &library, const std::string &path, const FileArguments &of_file,
                        const ClipArguments &clips, const clq_zone_map_def *zones, uint32_t texture_px)
{
    const Waiting waiting("making levels of detail of " + path);
    clq_template *made = nullptr;
    clq_status status = CLQ_OK;
    if (clips.files.empty()) {
        std::vector<const char *> names;
        const clq_asset_options options = options_of(names, of_file, clips);
        const clq_levels_def levels = clq_levels_def_init();
        clq_prepare_def def = clq_prepare_def_init();
        def.levels = &levels, def.max_texture_px = texture_px;
        def.zone_maps = &zones, def.zone_map_count = zones ? 1 : 0;
        if (is_builtin(path)) def.builtin = path.c_str(), def.clip_count = clips.vary;
        else def.path = path.c_str(), def.options = &options;
        status = clq_template_prepare(library.context(), &def, &made, nullptr);
    } else {
        // An asset of its own: levels are parts, and the box of the character is that of the finest.
        const scenes::Own<clq_asset> asset = load_asset(library, path, of_file, clips);
        if (zones) check(clq_asset_set_zone_map(library.context(), asset.get(), zones), path);
        status = clq_asset_make_levels(library.context(), asset.get(), nullptr, nullptr);
        if (status == CLQ_OK) status = clq_asset_build(library.context(), asset.get(), texture_px, &made);
    }
    if (status == CLQ_LIMIT)
        clq_context_log(library.context(), CLQ_LOG_WARNING,
                        (path + " is shown in full at every distance, as with --lod off: " + clq_last_error()).c_str());
    else if (status != CLQ_ARGUMENT) check(status, path);
    return made;
}

namespace
{

scenes::Own<clq_template> template_of(scenes::Library &library, const LoadedCharacter &loaded, const std::string &path,
                                      const FileArguments &of_file, const ClipArguments &clips, scenes::Lod levels)
{
    clq_template *made = nullptr;
    if (is_prepared(path)) {
        expect_unplaced(of_file, path + " is prepared already, with claque prepare");
        if (!clips.files.empty() || clips.vary > 0)
            throw scenes::Failure(path + " is prepared already; add clips earlier, with claque prepare --clips");
        return library.load_prepared(path, of_file.placement.colours);
    } else {
        if (levels == scenes::Lod::on) made = in_levels(library, path, of_file, clips);
        if (!made) check(clq_asset_build(library.context(), loaded.asset.get(), 0, &made), path);
    }
    return scenes::Own<clq_template>(made);
}

}  // namespace

bool is_other_format(const std::string &path)
{
    static const std::set<std::string> others = {".fbx", ".dae", ".obj", ".3ds", ".x",   ".blend", ".md5mesh", ".ms3d",
                                                 ".b3d", ".lwo", ".smd", ".ply", ".stl", ".iqm",   ".md2",     ".egg"};
    const std::string ogre = ".mesh.xml";
    return others.count(io::ending_of(path)) != 0 ||
           (path.size() > ogre.size() && path.compare(path.size() - ogre.size(), ogre.size(), ogre) == 0);
}

bool is_character_file(const std::string &path)
{
    static const std::set<std::string> own = {".glb", ".gltf", ".vrm", ".clq"};
    if (own.count(io::ending_of(path)) != 0 || is_other_format(path)) return true;
    char first[4] = {};
    const io::RegularFile file(path, io::most_file_bytes);
    return file.wrong().empty() && file.read(0, first, sizeof first) && std::memcmp(first, "glTF", sizeof first) == 0;
}

FileArguments in_own_size(FileArguments of_file, const std::string &path)
{
    if (scenes::is_file(path) && !is_prepared(path) && !of_file.placement.has_size()) of_file.placement.scale = 1;
    return of_file;
}

scenes::Own<clq_asset> load_asset(scenes::Library &library, const std::string &path, const FileArguments &of_file,
                                  const ClipArguments &clips, uint32_t *first_clip)
{
    clq_asset *made = nullptr;
    if (is_builtin(path)) {
        expect_unplaced(of_file, path + " is built in");
        if (clips.vary > 0) check(clq_asset_builtin_varied(library.context(), path.c_str(), clips.vary, &made));
        else check(clq_asset_builtin(library.context(), path.c_str(), &made));
    } else {
        if (clips.vary > 0)
            throw scenes::Failure(path + " is no built-in character; only the clips of those can be varied");
        std::vector<const char *> names;
        const clq_asset_options options = options_of(names, of_file, clips);
        const clq_status read = clq_asset_load_file(library.context(), path.c_str(), &options, &made);
        if (read != CLQ_OK && is_other_format(path))
            throw scenes::Failure(path + " is no glTF: 'claque convert " + path + " --out NAME.glb' makes one of it");
        if (read != CLQ_OK && io::ending_of(path) == ".toml")
            throw scenes::Failure(path + " is no character: 'claque render --scenario " + path +
                                  "' shows a scenario, and --colours " + path + " is for a colour map");
        check(read);
    }
    scenes::Own<clq_asset> asset(made);
    const uint32_t first = add_clips(library, made, clips);
    if (first_clip) *first_clip = first;
    return asset;
}

LoadedCharacter load_character(scenes::Library &library, const std::string &path, const FileArguments &given,
                               const ClipArguments &clips, scenes::Lod levels)
{
    const FileArguments of_file = in_own_size(given, path);
    LoadedCharacter loaded;
    if (!is_prepared(path)) loaded.asset = load_asset(library, path, of_file, clips, &loaded.first_clip);
    if (loaded.asset && info_of(loaded.asset.get()).vertex_count == 0 && info_of(loaded.asset.get()).clip_count > 0)
        throw scenes::Failure(path + " has clips and nothing to draw: --clips " + path + " adds them to a character");
    loaded.tmpl = library.shared([&] { return template_of(library, loaded, path, of_file, clips, levels); });
    return loaded;
}

clq_asset_info info_of(const clq_asset *asset)
{
    clq_asset_info info = clq_asset_info_init();
    check(clq_asset_get_info(asset, &info));
    return info;
}

clq_template_info info_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    return info;
}

}  // namespace cli
