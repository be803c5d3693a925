#include "lib/api/assets/installed_people.h"

#include <climits>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <new>
#include <sys/stat.h>

#include "lib/asset/owned_folder.h"
#include "lib/base/error.h"

namespace claque::api
{

namespace
{

namespace fs = std::filesystem;

// The file of libclaque-assets.so, without links. Empty if it was linked statically, or loaded by a relative path: that
// leads elsewhere once the program has changed its folder.
fs::path library_file()
{
    static const char here = 0;
    Dl_info info = {};
    char path[PATH_MAX];
    if (!dladdr(&here, &info) || !info.dli_fname || *info.dli_fname != '/' || !realpath(info.dli_fname, path))
        return "";
    const fs::path file = path;
    return file.filename().string().rfind("libclaque-assets.so", 0) == 0 ? file : "";
}

// The first file of another build, if there is none of this one.
std::string file_of_another_build(const std::string &folder, const std::string &build)
{
    std::string first;
    std::error_code trouble;
    for (fs::directory_iterator entry(folder, trouble), end; entry != end; entry.increment(trouble)) {
        const std::string name = entry->path().filename().string();
        if (name.rfind(build, 0) == 0) return "";
        if (entry->path().extension() == ".clq" && (first.empty() || name < first)) first = name;
    }
    return first;
}

Template loaded(clq_context *context, const asset::OwnedFolder &people, const std::string &build,
                const std::string &name)
{
    const std::vector<uint8_t> bytes = people.read(name);
    if (bytes.empty()) {
        const std::string other = file_of_another_build(people.path(), build);
        if (!other.empty())
            base::fail(CLQ_IO, "'%s/%s' is of another build of claque, and the names of this one begin with %s",
                       people.path().c_str(), other.c_str(), build.c_str());
        return nullptr;
    }
    clq_template *tmpl = nullptr;
    const clq_status status = clq_template_load(context, bytes.data(), bytes.size(), &tmpl);
    if (status == CLQ_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != CLQ_OK)
        base::fail(status, "'%s/%s' cannot be used: %s", people.path().c_str(), name.c_str(), clq_last_error());
    return Template(tmpl);
}

}  // namespace

Template installed_template(clq_context *context, const std::string &build, const std::string &name)
{
    const fs::path library = library_file();
    const std::string folder = (library.parent_path() / CLAQUE_PEOPLE_FOLDER).lexically_normal().string();
    struct stat facts = {};
    std::error_code absent;
    if (library.empty() || !fs::exists(folder, absent) || stat(library.c_str(), &facts) != 0) return nullptr;
    try {
        return loaded(context, asset::OwnedFolder(folder, {facts.st_uid, 0, "install claque again"}), build, name);
    } catch (const base::Error &error) {
        clq_context_log(context, CLQ_LOG_WARNING,
                        (std::string("prepared people are passed over: ") + error.what()).c_str());
    }
    return nullptr;
}

}  // namespace claque::api
