// How many files of the collection load, by what they are, as docs/measurements.md has it. Each file's own reasons are
// held by Inventory, Hostile and the tests of trajectories, areas and claque convert.
#include <claque/assets.h>
#include <claque/trajectories.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace
{

namespace fs = std::filesystem;

struct Count {
    size_t files = 0, loaded = 0;
    std::map<std::string, size_t> refused;  // by the name of the status
};

clq_status load_asset(clq_context *context, const char *path)
{
    clq_asset *made = nullptr;
    const clq_status status = clq_asset_load_file(context, path, nullptr, &made);
    clq_asset_destroy(made);
    return status;
}

// With units and rates for files that do not say them.
clq_status load_tracks(clq_context *context, const char *path)
{
    clq_trajectories_def def = clq_trajectories_def_init();
    clq_trajectories *made = nullptr;
    clq_status status = clq_trajectories_load(context, path, &def, &made);
    def.rate_hz = 25, def.metres_per_unit = 1;
    if (status == CLQ_ARGUMENT) status = clq_trajectories_load(context, path, &def, &made);
    clq_trajectories_destroy(made);
    return status;
}

clq_status load_area(clq_context *context, const char *path)
{
    clq_area *made = nullptr;
    const clq_status status = clq_area_load(context, path, &made);
    clq_area_destroy(made);
    return status;
}

struct Kind {
    const char *name;
    std::function<bool(const std::string &)> holds;  // paths below the collection
    clq_status (*load)(clq_context *, const char *);
    size_t loaded;  // of the collection, with every decoder
};

bool ends(const std::string &path, const std::set<std::string> &endings)
{
    return endings.count(fs::path(path).extension().string()) > 0;
}

bool begins(const std::string &path, const std::string &folder) { return path.compare(0, folder.size(), folder) == 0; }

const std::vector<Kind> &kinds()
{
    static const std::vector<Kind> all = {
        {"glTF made to be refused",
         [](const std::string &p) {
             return begins(p, "hostile/") && ends(p, {".gltf", ".glb"});
         },
         load_asset, 91},
        {"glTF",
         [](const std::string &p) {
             return !begins(p, "hostile/") && ends(p, {".gltf", ".glb"});
         },
         load_asset, 98},
        {"BVH", [](const std::string &p) { return ends(p, {".bvh"}); }, load_asset, 4},
        {"trajectories",
         [](const std::string &p) {
             static const std::set<std::string> beside = {"H.txt", "groups.txt", "info.txt", "geo.xml", "map.xml"};
             return begins(p, "tracks/") && !begins(p, "tracks/LICENSES/") &&
                    beside.count(fs::path(p).filename().string()) == 0 &&
                    ends(p, {".txt", ".sqlite", ".traj", ".csv", ".gz", ".pp", ".vsp", ".ndjson", ".xml"});
         },
         load_tracks, 22},
        {"areas",
         [](const std::string &p) {
             return begins(p, "tracks/") &&
                    (ends(p, {".wkt", ".nav", ".scenario", ".sqlite"}) || fs::path(p).filename() == "geo.xml");
         },
         load_area, 17},
    };
    return all;
}

TEST(Collection, HasAsManyFilesThatLoadAsItIsSaidToHave)
{
    const std::string folder = CLAQUE_ASSETS_DIR;
    if (!fs::exists(folder + "/inventory.json")) GTEST_SKIP() << "no characters in " << folder;
#if !defined CLAQUE_HAS_DRACO || !defined CLAQUE_HAS_MESHOPT || !defined CLAQUE_HAS_WEBP || \
    !defined CLAQUE_HAS_EXPAT || !defined CLAQUE_HAS_SQLITE3 || !defined CLAQUE_HAS_Z
    GTEST_SKIP() << "this build lacks a decoder";
#endif
    const clq_context_def def = clq_context_def_init();
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    std::vector<std::string> paths;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path().string().substr(folder.size() + 1));
    std::sort(paths.begin(), paths.end());
    for (const Kind &kind : kinds()) {
        Count count;
        for (const std::string &path : paths) {
            if (!kind.holds(path)) continue;
            ++count.files;
            const clq_status status = kind.load(context, (folder + "/" + path).c_str());
            if (status == CLQ_OK) ++count.loaded;
            else ++count.refused[clq_status_name(status)];
            EXPECT_NE(status, CLQ_OUT_OF_MEMORY) << path;
            EXPECT_NE(status, CLQ_ARGUMENT) << path << ": " << clq_last_error();
        }
        std::string text = std::to_string(count.loaded) + " of " + std::to_string(count.files);
        for (const auto &[name, files] : count.refused) text += ", " + name + " " + std::to_string(files);
        std::printf("%s: %s\n", kind.name, text.c_str());
        RecordProperty(kind.name, text);
        EXPECT_EQ(count.loaded, kind.loaded) << kind.name;
    }
    clq_context_destroy(context);
}

}  // namespace
