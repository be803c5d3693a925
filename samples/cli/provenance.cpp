#include "samples/cli/provenance.h"

#include <claque/base.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/types.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <sha256.h>

#include "samples/io/files.h"
#include "samples/scenes/check.h"

extern char **environ;

namespace cli
{
namespace
{

constexpr const char *caps = "GALLIUM_OVERRIDE_CPU_CAPS", *portable_caps = "ssse3";

// The program and the libraries of claque that it has loaded.
std::set<std::string> own_files()
{
    std::set<std::string> files = {"/proc/self/exe"};
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const size_t at = line.find('/');
        if (at != std::string::npos && line.find("/libclaque", at) != std::string::npos) files.insert(line.substr(at));
    }
    return files;
}

std::string build()
{
    std::string hashes;
    for (const std::string &file : own_files()) hashes += sha256_of_file(file);
    std::ostringstream words;
    words << CLQ_VERSION_MAJOR << '.' << CLQ_VERSION_MINOR << '.' << CLQ_VERSION_PATCH << ' '
          << sha256_of(hashes.data(), hashes.size()).substr(0, 16);
    return words.str();
}

// What of a processor Mesa's compiler of shaders asks for: its sums may differ in the last bit.
std::string processor()
{
    utsname system = {};
    uname(&system);
    std::string found = system.machine;
    const char *restricted = std::getenv(caps);
    if (restricted) return found + " restricted to " + restricted;
    std::ifstream about("/proc/cpuinfo");
    for (std::string line; std::getline(about, line);) {
        if (line.rfind("flags", 0) != 0) continue;
        std::istringstream words(line);
        std::set<std::string> flags;
        for (std::string word; words >> word;) flags.insert(word);
        for (const char *one : {"ssse3", "sse4_1", "avx", "f16c", "fma", "avx2", "avx512f"})
            if (flags.count(one)) found += std::string(" ") + one;
        break;
    }
    return found;
}

// How many threads draw does not change pixels. Of claque's instruction sets fma alone does.
nlohmann::ordered_json drivers()
{
    std::set<std::string> all;
    for (char **one = environ; *one; ++one)
        for (const char *prefix :
             {"GALLIUM_", "GALLIVM_", "LP_", "SP_", "ST_", "DRAW_", "MESA_", "LIBGL_", "CLAQUE_SIMD=fma"})
            if (std::strncmp(*one, prefix, std::strlen(prefix)) == 0) all.insert(*one);
    nlohmann::ordered_json found = nlohmann::ordered_json::object();
    for (const std::string &one : all) {
        const size_t equals = one.find('=');
        if (equals == std::string::npos || one.rfind("LP_NUM_THREADS=", 0) == 0) continue;
        found[one.substr(0, equals)] = one.substr(equals + 1);
    }
    return found;
}

}  // namespace

std::string sha256_of(const void *bytes, size_t size)
{
    std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
    SHA256Data(static_cast<const uint8_t *>(bytes), size, text.data());
    return text.data();
}

std::string sha256_of_file(const std::string &path)
{
    SHA256_CTX sum;
    SHA256_Init(&sum);
    const std::string wrong = io::read_in_pieces(path, io::most_file_bytes, [&](const char *piece, size_t size) {
        SHA256_Update(&sum, reinterpret_cast<const uint8_t *>(piece), size);
    });
    if (!wrong.empty()) throw scenes::Failure(wrong);
    std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
    SHA256_End(&sum, text.data());
    return text.data();
}

bool is_still(const std::string &path, const std::string &sha256)
{
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) && sha256_of_file(path) == sha256;
}

void use_portable_drivers() { setenv(caps, portable_caps, 0); }

nlohmann::ordered_json provenance(const std::string &gl)
{
    return {{"build", build()}, {"gl", gl}, {"processor", processor()}, {"drivers", drivers()}};
}

}  // namespace cli
