#include "samples/scenes/roles/mechanism_file.h"

#include <algorithm>
#include <filesystem>

#include "samples/scenes/check.h"

namespace scenes::roles
{
namespace
{

namespace fs = std::filesystem;

fs::path without_links(const std::string &mechanism, const std::string &path)
{
    std::error_code error;
    const fs::path found = fs::canonical(path, error);
    if (error)
        throw Failure("the mechanism " + mechanism + " cannot be loaded: " +
                      (path == mechanism ? "" : "the folder " + path + " of --allow-mechanisms: ") + error.message());
    return found;
}

}  // namespace

MechanismFile::MechanismFile(const std::string &folder, const std::string &file)
{
    if (folder.empty())
        throw Failure("the mechanism " + file +
                      " is not loaded: it is a program, and only --allow-mechanisms FOLDER lets scenarios of the "
                      "command line load programs, those in FOLDER");
    const fs::path found = without_links(file, file), trusted = without_links(file, folder);
    if (std::mismatch(trusted.begin(), trusted.end(), found.begin(), found.end()).first != trusted.end())
        throw Failure("the mechanism " + file + " is not loaded: it is " + found.string() + ", which is not in " +
                      trusted.string() + ", the folder of --allow-mechanisms");
    // The loader would wait for a pipe.
    if (!fs::is_regular_file(found)) throw Failure("the mechanism " + file + " is not loaded: it is no regular file");
    path_ = found.string();
}

}  // namespace scenes::roles
