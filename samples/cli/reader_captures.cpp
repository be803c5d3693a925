// NumPy's arrays and parity folders for `claque bench readers`.
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "samples/cli/files.h"
#include "samples/cli/reader_parts.h"
#include "samples/io/npy.h"
#include "samples/io/unfinished.h"
#include "samples/parity/compare.h"

namespace cli
{
namespace capture_readers
{
namespace
{

using Json = nlohmann::json;

std::string npy_numbers(uint32_t count) { return io::npy("<u4", {count}, std::vector<uint32_t>(count)); }

std::string npy_dimensions(uint32_t count)
{
    return io::npy("<u4", std::vector<size_t>(count, 1), std::vector<uint32_t>(1));
}

template <class Work>
Reading timed_parity(const Work &work)
{
    return timed([&] {
        try {
            work();
            return std::string("ok");
        } catch (const parity::Unreadable &) {
            return std::string("refused");
        }
    });
}

Reading read_array(scenes::Library &, const std::string &bytes)
{
    const std::vector<unsigned char> file(bytes.begin(), bytes.end());
    return timed_parity([&] { parity::read_npy(file, "array", "<u4"); });
}

using Files = std::map<std::string, std::string>;

// A result of people of one vertex each, in one row of the picture.
struct Folder {
    uint32_t people = 1, meshes = 1, templates = 1, zones = 1, columns = 4, width = 8, height = 1;

    std::string packed() const
    {
        Files files;
        files["capture.json"] = json().dump();
        std::vector<uint32_t> table, actor(size_t(width) * height);
        for (uint32_t i = 0; i < people; ++i) {
            table.insert(table.end(), {i + 1, i % meshes, i, 1});
            table.resize(size_t(i + 1) * columns);
        }
        for (size_t i = 0; i < actor.size(); ++i) actor[i] = 1 + static_cast<uint32_t>(i / 3) % people;
        const size_t rows = height, pixels = width;
        files["actors.npy"] = io::npy("<u4", {people, columns}, table);
        files["positions.npy"] = io::npy("<f4", {people, 3}, std::vector<float>(3 * size_t(people), 0.5f));
        files["normals.npy"] = io::npy("<f4", {people, 3}, std::vector<float>(3 * size_t(people), 0.5f));
        files["actor.npy"] = io::npy("<u4", {rows, pixels}, actor);
        files["zone.npy"] = io::npy("<u2", {rows, pixels}, std::vector<uint16_t>(actor.size(), 1));
        files["depth.npy"] = io::npy("<f4", {rows, pixels}, std::vector<float>(actor.size(), 0.5f));
        files["colour.npy"] = io::npy("|u1", {rows, pixels, 3}, std::vector<uint8_t>(3 * actor.size(), 90));
        std::string out;
        for (const auto &[name, bytes] : files) out += name + " " + std::to_string(bytes.size()) + "\n" + bytes;
        return out;
    }

private:
    Json json() const
    {
        Json out = {{"format", "claque-parity"},
                    {"version", 1},
                    {"kind", "result"},
                    {"renderer", "bench"},
                    {"scene", "bench"},
                    {"width", width},
                    {"height", height},
                    {"time_s", 0},
                    {"actors", people},
                    {"vertices", people},
                    {"actor_columns", {"actor", "mesh", "first_vertex", "vertex_count"}}};
        for (uint32_t i = 4; i < columns; ++i) out["actor_columns"].push_back("c" + std::to_string(i));
        for (uint32_t i = 0; i < templates; ++i)
            out["templates"].push_back({{"name", "t" + std::to_string(i)}, {"zones", Json::array()}});
        for (uint32_t i = 0; i < zones; ++i) out["templates"][0]["zones"].push_back("z" + std::to_string(i));
        for (uint32_t i = 0; i < meshes; ++i)
            out["meshes"].push_back({{"template", i % templates}, {"level", 0}, {"vertices", 1}, {"triangles", 0}});
        return out;
    }
};

std::string people(uint32_t count)
{
    Folder folder;
    folder.people = count, folder.width = 300;
    return folder.packed();
}

std::string meshes(uint32_t count)
{
    Folder folder;
    folder.meshes = count;
    return folder.packed();
}

std::string templates(uint32_t count)
{
    Folder folder;
    folder.templates = count;
    return folder.packed();
}

std::string zones(uint32_t count)
{
    Folder folder;
    folder.zones = count;
    return folder.packed();
}

std::string meshes_and_zones(uint32_t count)
{
    Folder folder;
    folder.meshes = folder.zones = folder.people = count;
    return folder.packed();
}

std::string columns(uint32_t count)
{
    Folder folder;
    folder.columns = 4 + count;
    return folder.packed();
}

std::string pixels(uint32_t count)
{
    Folder folder;
    folder.height = std::max(count / 100, 1u), folder.width = std::max(count / folder.height, 1u);
    folder.people = std::min(count, 50u);
    return folder.packed();
}

// A folder that goes with its files, at a signal too.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        const io::SignalsHeld held;  // until its name is noted
        if (!mkdtemp(path_.data())) throw scenes::Failure(path_ + " could not be made");
        note(path_);
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::string &path() const { return path_; }

    void write(const std::string &name, const std::string &bytes)
    {
        const std::string file = path_ + "/" + name;
        note(file);
        write_whole(file, bytes);
    }

private:
    void note(const std::string &path) { unfinished_.push_back(std::make_unique<io::Unfinished>(path)); }

    std::string path_ = (std::filesystem::temp_directory_path() / "claque-bench-XXXXXX").string();
    std::vector<std::unique_ptr<io::Unfinished>> unfinished_;  // the folder and its files
};

// Writes the files to a folder, reads them, and compares the result with itself.
Reading read_folder(scenes::Library &, const std::string &bytes)
{
    TemporaryFolder folder;
    for (size_t at = 0; at < bytes.size();) {
        const size_t blank = bytes.find(' ', at), line = bytes.find('\n', at);
        const size_t size = std::stoul(bytes.substr(blank + 1, line - blank - 1));
        folder.write(bytes.substr(at, blank - at), bytes.substr(line + 1, size));
        at = line + 1 + size;
    }
    parity::Capture capture;
    Reading out = timed_parity([&] { capture = parity::read_capture(folder.path()); });
    if (out.loaded != "ok") return out;
    const Reading compared = timed_parity([&] { parity::compare(capture, capture, 60); });
    out.build_ms = compared.load_ms, out.built = compared.loaded;
    return out;
}

}  // namespace
}  // namespace capture_readers

std::vector<ReaderElement> reader_elements_of_captures()
{
    using namespace capture_readers;
    return {{"npy", "numbers", most_elements, npy_numbers, read_array},
            {"npy", "dimensions", 20000, npy_dimensions, read_array},
            {"parity", "people", most_elements, people, read_folder},
            {"parity", "meshes", most_elements, meshes, read_folder},
            {"parity", "templates", most_elements, templates, read_folder},
            {"parity", "zones of a template", 65535, zones, read_folder},
            {"parity", "people, meshes and zones", 65535, meshes_and_zones, read_folder},
            {"parity", "columns of people", most_elements, columns, read_folder},
            {"parity", "pixels", most_elements, pixels, read_folder}};
}

}  // namespace cli
