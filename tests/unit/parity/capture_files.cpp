#include "tests/unit/parity/capture_files.h"

#include <fstream>
#include <iterator>

namespace parity_test
{
namespace
{

namespace fs = std::filesystem;

const char json[] = R"({"format": "claque-parity", "version": 1, "kind": "result", "renderer": "a test",
"scene": {"name": "three"}, "width": 16, "height": 12, "time_s": 1.5, "actors": 3, "vertices": 10,
"actor_columns": ["actor", "mesh", "first_vertex", "vertex_count", "later"],
"templates": [{"name": "man", "zones": ["skin", "tunic"]}, {"name": "owl", "zones": ["plumage"]}],
"meshes": [{"template": 0, "level": 2, "vertices": 3, "triangles": 1},
{"template": 1, "level": 0, "vertices": 4, "triangles": 2}]}
)";

// The actor in this column.
uint32_t actor_at(int x) { return x >= 2 && x <= 6 ? 2 : x >= 8 && x <= 13 ? 5 : 0; }

}  // namespace

std::string npy(const std::string &type, const std::string &shape, const void *values, size_t bytes)
{
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    header.append(64 - (11 + header.size()) % 64, ' ');
    header += '\n';
    std::string out("\x93NUMPY\x01\x00", 8);
    out += static_cast<char>(header.size() & 255);
    out += static_cast<char>(header.size() >> 8);
    return out + header + std::string(static_cast<const char *>(values), bytes);
}

CaptureFiles::CaptureFiles()
{
    const auto *info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() / ("claque-parity-" + std::string(info->name()));
    fs::remove_all(root_);
    fs::create_directories(root_);
}

CaptureFiles::~CaptureFiles()
{
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

void CaptureFiles::write(const std::string &name, const std::string &file, const std::string &bytes) const
{
    fs::create_directories(root_ / name);
    std::ofstream(root_ / name / file, std::ios::binary) << bytes;
}

void CaptureFiles::remove(const std::string &name, const std::string &file) const { fs::remove(root_ / name / file); }

void CaptureFiles::replace(const std::string &name, const std::string &file, const std::string &from,
                           const std::string &to) const
{
    std::ifstream in(root_ / name / file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write(name, file, text.replace(at, from.size(), to));
}

void CaptureFiles::write_result(const std::string &name) const
{
    write(name, "capture.json", json);
    write(name, "actors.npy", numbers({2, 0, 0, 3, 77, 5, 0, 3, 3, 77, 6, 1, 6, 4, 77}, 5));
    write(name, "sizes.npy", npy("<f4", "3,", std::vector<float>{1.75f, 1.75f, 0.5f}));
    std::vector<float> positions, normals;
    for (size_t i = 0; i < vertices; ++i) {
        const float f = static_cast<float>(i);
        positions.insert(positions.end(), {0.125f * f, 1 + 0.25f * f, -0.5f});
        normals.insert(normals.end(), {0, 0, 1});
    }
    write(name, "positions.npy", npy("<f4", "10, 3", positions));
    write(name, "normals.npy", npy("<f4", "10, 3", normals));
    std::vector<uint8_t> colour;
    std::vector<float> depth;
    std::vector<uint32_t> actor;
    std::vector<uint16_t> zone;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const uint32_t person = actor_at(x);
            actor.push_back(person);
            zone.push_back(person == 0 ? uint16_t{0} : y < 5 ? uint16_t{1} : uint16_t{2});
            depth.push_back(person == 0 ? 1.0f : 0.5f + 0.015625f * static_cast<float>(person));
            for (int c = 0; c < 3; ++c)
                colour.push_back(
                    static_cast<uint8_t>(person == 0 ? 0 : 30 * zone.back() + 8 * static_cast<int>(person) + c));
        }
    write(name, "colour.npy", npy("|u1", "12, 16, 3", colour));
    write(name, "depth.npy", npy("<f4", "12, 16", depth));
    write(name, "actor.npy", npy("<u4", "12, 16", actor));
    write(name, "zone.npy", npy("<u2", "12, 16", zone));
}

std::string numbers(const std::vector<uint32_t> &table, size_t columns)
{
    return npy("<u4", std::to_string(table.size() / columns) + ", " + std::to_string(columns), table);
}

}  // namespace parity_test
