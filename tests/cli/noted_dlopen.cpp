// Preloaded into a program: notes each library that it opens, a name a line, in the file of CLAQUE_NOTED_DLOPEN
// (tests/cli/loaded_code_test.cpp).
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>

namespace
{

using Open = void *(*)(const char *name, int flags);

void note(const char *name)
{
    const char *path = std::getenv("CLAQUE_NOTED_DLOPEN");
    std::FILE *notes = path ? std::fopen(path, "a") : nullptr;
    if (!notes) return;
    std::fprintf(notes, "%s\n", name ? name : "the program itself");
    std::fclose(notes);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void *dlopen(const char *name, int flags) noexcept
{
    note(name);
    static const auto open = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "dlopen"));
    return open(name, flags);
}
