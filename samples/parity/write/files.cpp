#include "samples/parity/write/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/scenes/check.h"

namespace parity
{
namespace
{

constexpr const char *all_names[] = {
    "capture.json",      "scene.glb",     "actors.npy",  "sizes.npy",  "model_view.npy", "atlas.npy", "palettes.npy",
    "morph_weights.npy", "positions.npy", "normals.npy", "colour.npy", "depth.npy",      "actor.npy", "zone.npy"};

std::string npy_header(const char *type, const Shape &shape)
{
    constexpr size_t before_text = 10, alignment = 64;  // magic, version, length; values begin at a multiple
    std::string sides;
    for (const size_t side : shape) sides += std::to_string(side) + ", ";
    std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (" + sides + "), }";
    text.append(alignment - (before_text + text.size() + 1) % alignment, ' ');
    text += '\n';
    std::string head("\x93NUMPY\x01\x00", 8);
    head += static_cast<char>(text.size() & 255);
    head += static_cast<char>(text.size() >> 8);
    return head + text;
}

template <class Value>
std::string npy(const char *type, const std::vector<Value> &values, const Shape &shape)
{
    std::string file = npy_header(type, shape);
    const size_t head = file.size();
    file.resize(head + values.size() * sizeof(Value));
    // The machines that samples run on are little-endian, as the arrays are.
    if (!values.empty()) std::memcpy(&file[head], values.data(), values.size() * sizeof(Value));
    return file;
}

}  // namespace

Folder::Folder(const std::string &path) : path_(path)
{
    auto unfinished = std::make_unique<io::Unfinished>(path);
    made_ = mkdir(path.c_str(), 0777) == 0;
    if (made_) unfinished_.push_back(std::move(unfinished));
    else if (errno != EEXIST) throw scenes::Failure(path + " could not be made: " + std::strerror(errno));
    struct stat what = {};
    if (stat(path.c_str(), &what) != 0 || !S_ISDIR(what.st_mode)) throw scenes::Failure(path + " is not a folder");
}

Folder::~Folder()
{
    if (unfinished_.empty()) return;
    for (const std::string &file : written_) unlink(file.c_str());
    if (made_) rmdir(path_.c_str());
}

void Folder::complete()
{
    unfinished_.clear();
    written_.clear();
}

void Folder::clear() const
{
    for (const char *name : all_names) unlink((path_ + "/" + name).c_str());
}

void Folder::write(const std::string &name, const void *bytes, size_t size_bytes)
{
    const std::string path = path_ + "/" + name;
    unfinished_.push_back(std::make_unique<io::Unfinished>(path));
    written_.push_back(path);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(static_cast<const char *>(bytes), static_cast<std::streamsize>(size_bytes));
    file.close();
    if (!file) throw scenes::Failure(path + " could not be written: " + std::strerror(errno));
}

void Folder::array(const std::string &name, const std::vector<float> &values, const Shape &shape)
{
    const std::string file = npy("<f4", values, shape);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint32_t> &values, const Shape &shape)
{
    const std::string file = npy("<u4", values, shape);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint16_t> &values, const Shape &shape)
{
    const std::string file = npy("<u2", values, shape);
    write(name, file.data(), file.size());
}

void Folder::array(const std::string &name, const std::vector<uint8_t> &values, const Shape &shape)
{
    const std::string file = npy("|u1", values, shape);
    write(name, file.data(), file.size());
}

}  // namespace parity
