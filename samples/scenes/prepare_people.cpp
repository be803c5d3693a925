// Asks for the built-in characters as scenes and clq_template_builtin do, with an empty folder XDG_CACHE_HOME. It holds
// them afterwards, or the program fails.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <thread>

#include "samples/scenes/library.h"

namespace
{

size_t prepare(scenes::Library &library)
{
    size_t count = 0;
    const auto add = [&](const clq_template *) { ++count; };
    for (const std::string &name : scenes::person_names) {
        add(library.builtin(name));
        add(library.builtin(name, {}));
        add(library.looking(name, true));
        add(library.builtin(name, scenes::amphitheatre_levels));
    }
    for (const char *name : {"decurion", "patrician"}) add(library.builtin(name, scenes::multitude_levels));
    for (const char *name : {"herald", "owl"}) add(library.builtin(name));
    return count;
}

size_t files_below(const std::filesystem::path &folder)
{
    return static_cast<size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

}  // namespace

int main()
{
    try {
        scenes::Library library(static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u)));
        const size_t asked = prepare(library);
        const char *cache = std::getenv("XDG_CACHE_HOME");
        const size_t kept = files_below(std::filesystem::path(cache ? cache : "") / "claque");
        if (kept != asked) {
            std::fprintf(stderr, "%zu templates were asked for, and %zu were stored in '%s/claque'\n", asked, kept,
                         cache);
            return 1;
        }
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
