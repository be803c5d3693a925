#include "lib/base/near_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "lib/base/near_names.h"

namespace claque::base
{

std::string near_files(const std::string &path)
{
    const std::filesystem::path wanted(path);
    const size_t letters = wanted.stem().string().size();
    constexpr size_t most_files = 4096;
    std::error_code error;
    std::filesystem::directory_iterator at(wanted.has_parent_path() ? wanted.parent_path() : ".", error), end;
    std::vector<std::string> names;
    // "e.glb" is a part of "Soldie.glb" by its ending.
    for (size_t seen = 0; !error && at != end && seen < most_files; at.increment(error), ++seen)
        if (2 * at->path().stem().string().size() >= letters) names.push_back(at->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string near = near_names(wanted.filename().string(), names);
    return near.empty() ? "" : ": " + near;
}

}  // namespace claque::base
