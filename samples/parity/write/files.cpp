#include "samples/parity/write/files.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/io/files.h"
#include "samples/io/npy.h"
#include "samples/scenes/check.h"

namespace parity
{
namespace
{

constexpr const char *all_names[] = {
    "capture.json",      "scene.glb",     "actors.npy",  "sizes.npy",  "model_view.npy", "atlas.npy", "palettes.npy",
    "morph_weights.npy", "positions.npy", "normals.npy", "colour.npy", "depth.npy",      "actor.npy", "zone.npy"};

// The folder that `path` leads to, by links as well.
std::string place_of(std::string path)
{
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr), std::free);
    return real ? real.get() : path;
}

// A folder is replaced as a whole: one in which a shell works would be gone for that shell.
void expect_replaceable(const std::string &place, const std::string &path)
{
    struct stat what = {};
    if (stat(place.c_str(), &what) != 0) return;
    if (!S_ISDIR(what.st_mode)) throw scenes::Failure(path + " is not a folder");
    const std::string here = place_of(".") + "/";
    if (here.compare(0, place.size() + 1, place + "/") == 0)
        throw scenes::Failure(path +
                              " holds the folder that the command runs in, which it cannot replace: run it "
                              "from another folder");
}

void remove_names(const std::string &folder)
{
    for (const char *name : all_names) unlink((folder + "/" + name).c_str());
}

void remove_capture(const std::string &folder)
{
    remove_names(folder);
    rmdir(folder.c_str());
}

// Puts `draft` in the place of `path`, or changes nothing. Returns where the older folder is then.
std::string replaced(const std::string &path, const std::string &draft)
{
    if (renameat2(AT_FDCWD, draft.c_str(), AT_FDCWD, path.c_str(), RENAME_EXCHANGE) == 0) return draft;
    if (errno != EINVAL && errno != ENOSYS) throw scenes::Failure(io::why(path, "written"));
    // A file system that cannot exchange two names.
    std::string older = draft + ".old";
    if (std::rename(path.c_str(), older.c_str()) != 0) throw scenes::Failure(io::why(path, "written"));
    if (std::rename(draft.c_str(), path.c_str()) == 0) return older;
    const std::string wrong = io::why(path, "written");
    if (std::rename(older.c_str(), path.c_str()) != 0)
        throw scenes::Failure(wrong + "; what was there is now " + older);
    throw scenes::Failure(wrong);
}

// Files that are no capture's stay in the folder where they were.
void move_others(const std::string &from, const std::string &to)
{
    for (const auto &entry : std::filesystem::directory_iterator(from)) {
        const std::string name = entry.path().filename();
        if (std::rename((from + "/" + name).c_str(), (to + "/" + name).c_str()) != 0)
            throw scenes::Failure(io::why(from + "/" + name, "moved into the new folder beside it"));
    }
}

}  // namespace

Folder::Folder(const std::string &path) : path_(place_of(path)), draft_(io::draft_of(path_))
{
    expect_replaceable(path_, path);
    remove_capture(draft_);  // of a process that was killed
    unfinished_.push_back(std::make_unique<io::Unfinished>(draft_));
    if (mkdir(draft_.c_str(), 0777) != 0) throw scenes::Failure(io::why(path, "made"));
}

Folder::~Folder()
{
    if (!unfinished_.empty()) remove_capture(draft_);
}

void Folder::write(const std::string &name, const void *bytes, size_t size_bytes)
{
    const std::string draft = draft_ + "/" + name;
    unfinished_.push_back(std::make_unique<io::Unfinished>(draft));
    const std::string wrong = io::write_new(draft, path_ + "/" + name, bytes, size_bytes, false);
    if (!wrong.empty()) throw scenes::Failure(wrong);
}

void Folder::complete()
{
    const io::SignalsHeld held;
    struct stat older = {};
    if (stat(path_.c_str(), &older) != 0) {
        if (std::rename(draft_.c_str(), path_.c_str()) != 0) throw scenes::Failure(io::why(path_, "written"));
        return unfinished_.clear();
    }
    if (chmod(draft_.c_str(), older.st_mode & 07777) != 0) throw scenes::Failure(io::why(path_, "written"));
    const std::string before = replaced(path_, draft_);
    unfinished_.clear();
    remove_names(before);
    move_others(before, path_);
    if (rmdir(before.c_str()) != 0) throw scenes::Failure(io::why(before, "removed"));
}

void Folder::array(const std::string &name, const std::vector<float> &values, const Shape &shape)
{
    const std::string file = io::npy("<f4", shape, values);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint32_t> &values, const Shape &shape)
{
    const std::string file = io::npy("<u4", shape, values);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint16_t> &values, const Shape &shape)
{
    const std::string file = io::npy("<u2", shape, values);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint8_t> &values, const Shape &shape)
{
    const std::string file = io::npy("|u1", shape, values);
    write(name, file.data(), file.size());
}

}  // namespace parity
