#include "tests/support/written_characters.h"

#include <filesystem>
#include <fstream>
#include <random>

#include "tests/support/written_files.h"

namespace written
{
namespace
{

using claque::testing::Bytes;
namespace fs = std::filesystem;

// Several tests may write at once: a file is complete when it gets its name, and has the same bytes each time.
void write(const fs::path &folder, const std::string &name, const Bytes &bytes)
{
    const fs::path path = folder / name;
    const fs::path unfinished = folder / (name + "." + std::to_string(std::random_device()()));
    {
        std::ofstream file(unfinished, std::ios::binary);
        file.write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    fs::rename(unfinished, path);
}

std::string write_all()
{
    const fs::path folder = CLAQUE_WRITTEN_DIR;
    fs::create_directories(folder);
    using namespace claque::testing;
    for (const auto maker :
         {written_person, written_rigid, written_morph, written_skins, written_sparse, written_quantised, written_odd,
          written_clips, written_lines, written_walk, written_refused})
        for (const auto &[name, bytes] : maker()) write(folder, name, bytes);
    const std::string inventory = written_inventory().dump(1);
    write(folder, "inventory.json", Bytes(inventory.begin(), inventory.end()));
    return folder.generic_string() + "/";
}

}  // namespace

std::vector<std::string> files()
{
    return {"WrittenPerson.glb",    "WrittenRigid.glb", "WrittenMorph.gltf", "WrittenSkins.glb", "WrittenSparse.gltf",
            "WrittenQuantised.glb", "WrittenOdd.gltf",  "WrittenClips.glb",  "WrittenLines.gltf"};
}

std::vector<std::string> characters()
{
    std::vector<std::string> shown = files();
    shown.resize(7);
    return shown;
}

std::vector<std::string> people()
{
    return {"WrittenPerson.glb", "WrittenSkins.glb", "WrittenSparse.gltf", "WrittenQuantised.glb"};
}

std::vector<std::string> refused() { return {"WrittenRequires.glb", "WrittenRepeats.glb"}; }

bool is_written(const std::string &name) { return name.rfind("Written", 0) == 0; }

const std::string &folder()
{
    static const std::string path = write_all();
    return path;
}

std::string path_of(const std::string &name, const std::string &collected)
{
    return is_written(name) ? folder() + name : collected + "/" + name;
}

std::string case_name(const std::string &name) { return name.substr(0, name.find('.')); }

}  // namespace written
