#include "samples/parity/capture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "samples/io/files.h"
#include "samples/parity/capture_json.h"

namespace parity
{
namespace
{

namespace fs = std::filesystem;

using Bytes = std::vector<unsigned char>;

Bytes bytes_of(const fs::path &path)
{
    std::string bytes;
    const std::string wrong = io::read_whole(path.string(), bytes, io::most_file_bytes);
    if (!wrong.empty()) throw Unreadable(wrong);
    return Bytes(bytes.begin(), bytes.end());
}

std::string shape_text(const std::vector<size_t> &shape)
{
    std::string out = "(";
    for (size_t i = 0; i < shape.size(); ++i) out += (i ? ", " : "") + std::to_string(shape[i]);
    return out + ")";
}

// Returns nothing if the file is absent.
std::optional<Array> array(const fs::path &folder, const char *file, const char *type)
{
    const fs::path path = folder / file;
    std::error_code error;
    if (!fs::exists(path, error)) return std::nullopt;
    return read_npy(bytes_of(path), path.string(), type);
}

void expect_shape(const Array &array, const std::vector<size_t> &shape, const fs::path &path, const char *because)
{
    if (array.shape != shape)
        throw Unreadable(path.string() + " has the shape " + shape_text(array.shape) + ", and " + shape_text(shape) +
                         " follows from " + because);
}

// One value a pixel.
template <class Value>
std::optional<Map<Value>> map_of(const fs::path &folder, const char *file, const char *type, const CaptureInfo &info)
{
    const std::optional<Array> found = array(folder, file, type);
    if (!found) return std::nullopt;
    Map<Value> out;
    out.width = info.width;
    out.height = info.height;
    expect_shape(*found, {static_cast<size_t>(info.height), static_cast<size_t>(info.width)}, folder / file,
                 "capture.json");
    out.values = found->as<Value>();
    return out;
}

std::optional<Picture> picture_of(const fs::path &folder, const CaptureInfo &info)
{
    const std::optional<Array> found = array(folder, "colour.npy", "|u1");
    if (!found) return std::nullopt;
    expect_shape(*found, {static_cast<size_t>(info.height), static_cast<size_t>(info.width), 3}, folder / "colour.npy",
                 "capture.json");
    Picture out;
    out.width = info.width;
    out.height = info.height;
    out.rgb = found->bytes;
    return out;
}

std::optional<std::vector<float>> vectors_of(const fs::path &folder, const char *file,
                                             const std::optional<std::vector<Actor>> &actors)
{
    const std::optional<Array> found = array(folder, file, "<f4");
    if (!found) return std::nullopt;
    size_t vertices = found->shape.empty() ? 0 : found->shape[0];
    if (actors) {
        vertices = 0;
        for (const Actor &a : *actors) vertices = std::max(vertices, a.first_vertex + a.vertex_count);
    }
    expect_shape(*found, {vertices, 3}, folder / file, actors ? "actors.npy" : "one vertex a row");
    return found->as<float>();
}

// Rows of actors.npy by the names of its columns.
class Table
{
public:
    Table(const Array &array, const CaptureInfo &info, std::string path)
        : path_(std::move(path)), columns_(info.actor_columns)
    {
        if (array.shape.size() != 2 || array.shape[1] != columns_.size())
            throw Unreadable(path_ + " has the shape " + shape_text(array.shape) + ", and capture.json names " +
                             std::to_string(columns_.size()) + " columns");
        rows_ = array.shape[0];
        values_ = array.as<uint32_t>();
    }
    size_t rows() const { return rows_; }
    uint32_t at(size_t row, const char *column) const
    {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        if (found == columns_.end()) throw Unreadable(path_ + " has no column '" + column + "'");
        return values_[row * columns_.size() + static_cast<size_t>(found - columns_.begin())];
    }
    [[noreturn]] void fail(size_t row, const std::string &what) const
    {
        throw Unreadable(path_ + ", row " + std::to_string(row) + ": " + what);
    }

private:
    std::string path_;
    const std::vector<std::string> &columns_;
    size_t rows_ = 0;
    std::vector<uint32_t> values_;
};

std::optional<std::vector<Actor>> actors_of(const fs::path &folder, const CaptureInfo &info)
{
    const std::optional<Array> found = array(folder, "actors.npy", "<u4");
    if (!found) return std::nullopt;
    const Table table(*found, info, (folder / "actors.npy").string());
    std::vector<float> sizes;
    if (const std::optional<Array> s = array(folder, "sizes.npy", "<f4")) {
        expect_shape(*s, {table.rows()}, folder / "sizes.npy", "actors.npy");
        sizes = s->as<float>();
    }
    std::vector<Actor> out;
    size_t vertices = 0;
    for (size_t row = 0; row < table.rows(); ++row) {
        const uint32_t mesh = table.at(row, "mesh");
        if (mesh >= info.meshes.size())
            table.fail(row, "mesh " + std::to_string(mesh) + " of " + std::to_string(info.meshes.size()));
        Actor a{table.at(row, "actor"),        info.meshes[mesh].kind,
                info.meshes[mesh].zones,       table.at(row, "first_vertex"),
                table.at(row, "vertex_count"), sizes.empty() || !std::isfinite(sizes[row]) ? 0.0 : double(sizes[row])};
        if (a.id == 0 || (!out.empty() && a.id <= out.back().id))
            table.fail(row, "actor " + std::to_string(a.id) + " is not above the one before");
        if (a.vertex_count != info.meshes[mesh].vertices)
            table.fail(row, std::to_string(a.vertex_count) + " vertices of a mesh that has " +
                                std::to_string(info.meshes[mesh].vertices));
        vertices += a.vertex_count;
        out.push_back(std::move(a));
    }
    const auto expect_count = [&](const char *what, size_t has, size_t says) {
        if (has != says)
            throw Unreadable((folder / "actors.npy").string() + " has " + std::to_string(has) + " " + what +
                             ", and capture.json says " + std::to_string(says));
    };
    expect_count("actors", out.size(), info.actors);
    expect_count("vertices", vertices, info.vertices);
    return out;
}

}  // namespace

Capture read_capture(const std::string &folder)
{
    const fs::path at = folder;
    std::error_code error;
    if (!fs::is_directory(at, error)) throw Unreadable(folder + " is not a folder");
    const Bytes json = bytes_of(at / "capture.json");
    const CaptureInfo info = capture_info(std::string(json.begin(), json.end()), (at / "capture.json").string(),
                                          fs::exists(at / "actors.npy", error));
    Capture out;
    out.folder = folder;
    out.renderer = info.renderer;
    out.scene = info.scene;
    out.width = info.width;
    out.height = info.height;
    out.time_s = info.time_s;
    out.actors = actors_of(at, info);
    out.positions = vectors_of(at, "positions.npy", out.actors);
    out.normals = vectors_of(at, "normals.npy", out.actors);
    out.colour = picture_of(at, info);
    out.depth = map_of<float>(at, "depth.npy", "<f4", info);
    out.actor = map_of<uint32_t>(at, "actor.npy", "<u4", info);
    out.zone = map_of<uint16_t>(at, "zone.npy", "<u2", info);
    return out;
}

}  // namespace parity
