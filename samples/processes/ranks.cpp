#include "samples/processes/ranks.h"

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>

namespace processes
{
namespace
{

constexpr const char *module_name = "claque-mpi.so";

// Beside the program in a build tree; beside the libraries once it is installed.
std::string module_path()
{
    namespace fs = std::filesystem;
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (const fs::path &folder : {program, program.parent_path() / CLAQUE_MODULE_FOLDER})
        if (fs::exists(folder / module_name, none)) return (folder / module_name).string();
    return module_name;
}

}  // namespace

int ranks_started()
{
    for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})  // Open MPI; MPICH and others
        if (const char *value = std::getenv(name)) return std::max(1, std::atoi(value));
    return 1;
}

std::unique_ptr<Ranks> join_ranks()
{
    if (ranks_started() == 1) return nullptr;
    // MPI loads libraries of its own, which look for its symbols among those of the whole process.
    void *module = dlopen(module_path().c_str(), RTLD_NOW | RTLD_GLOBAL);
    const auto make = module ? reinterpret_cast<MakeRanks>(dlsym(module, "claque_make_ranks")) : nullptr;
    if (!make)
        throw std::runtime_error("mpirun started " + std::to_string(ranks_started()) + " processes, but " +
                                 module_name + ", which lets them share the work, cannot be loaded (" + dlerror() +
                                 "): build claque where libopenmpi-dev is installed, or start it without mpirun");
    return std::unique_ptr<Ranks>(make());
}

}  // namespace processes
