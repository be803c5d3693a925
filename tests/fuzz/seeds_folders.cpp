// A parity folder of two individuals in a picture of 4 x 3, and its arrays alone.
#include "tests/fuzz/files.h"
#include "tests/fuzz/parity_files.h"
#include "tests/fuzz/seeds.h"
#include "tests/unit/parity/capture_files.h"

namespace fuzzing
{
namespace
{

const char capture[] =
    "{\"format\":\"claque-parity\",\"version\":1,\"kind\":\"result\",\"renderer\":\"a test\",\"scene\":{\"name\":"
    "\"two\"},\"width\":4,\"height\":3,\"time_s\":1.5,\"actors\":2,\"vertices\":6,"
    "\"actor_columns\":[\"actor\",\"mesh\",\"first_vertex\","
    "\"vertex_count\"],\"templates\":[{\"name\":\"man\",\"zones\":[\"skin\",\"tunic\"]}],\"meshes\":[{\"template\":0,"
    "\"level\":2,\"vertices\":3,\"triangles\":1}]}";

Files folder()
{
    using parity_test::npy;
    std::vector<float> positions, normals, depth;
    std::vector<uint8_t> colour;
    std::vector<uint32_t> actor;
    std::vector<uint16_t> zone;
    for (size_t i = 0; i < 6; ++i) {
        positions.insert(positions.end(), {0.5f * static_cast<float>(i), 1, -0.5f});
        normals.insert(normals.end(), {0, 0, 1});
    }
    for (uint32_t i = 0; i < 12; ++i) {
        actor.push_back(i % 4 == 0 ? 0 : i % 4 < 3 ? 2 : 5);
        zone.push_back(static_cast<uint16_t>(actor.back() == 0 ? 0 : 1 + i / 8));
        depth.push_back(actor.back() == 0 ? 1.0f : 0.5f);
        for (uint32_t c = 0; c < 3; ++c) colour.push_back(static_cast<uint8_t>(20 * i + c));
    }
    const std::string files[parity_file_count] = {capture,
                                                  parity_test::numbers({2, 0, 0, 3, 5, 0, 3, 3}, 4),
                                                  npy("<f4", "2,", std::vector<float>{1.75f, 0.5f}),
                                                  npy("<f4", "6, 3", positions),
                                                  npy("<f4", "6, 3", normals),
                                                  npy("|u1", "3, 4, 3", colour),
                                                  npy("<f4", "3, 4", depth),
                                                  npy("<u4", "3, 4", actor),
                                                  npy("<u2", "3, 4", zone)};
    Files out;
    for (uint8_t i = 0; i < parity_file_count; ++i) out.emplace_back(i, Bytes(files[i].begin(), files[i].end()));
    return out;
}

}  // namespace

void add_folder_seeds(std::vector<Seed> &out)
{
    Files files = folder();
    for (const auto &[number, bytes] : files)
        if (number > 0) out.push_back({"npy", parity_files[number], bytes});
    out.push_back({"parity", "whole", packed(files)});
    Bytes other = files[6].second;  // depth
    other.back() = 0x40;
    files.emplace_back(uint8_t(128 + 6), other);
    out.push_back({"parity", "other-depth", packed(files)});
    out.push_back({"parity", "colour", packed({files[0], files[5]})});
}

}  // namespace fuzzing
