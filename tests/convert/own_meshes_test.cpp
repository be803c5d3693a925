// Two meshes written here: what is converted has both of them, with the normals and texture coordinates of their file.
#include <array>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "lib/asset/gltf.h"
#include "samples/convert/convert.h"
#include "tests/cli/run.h"

namespace convert_test
{
namespace
{

struct Corner {
    glm::vec3 normal;
    glm::vec2 uv;  // as in the file, whose v points up
};

// By position.
const std::map<std::array<float, 3>, Corner> corners = {{{0, 0, 0}, {{0, 0.6f, 0.8f}, {0.125f, 0.25f}}},
                                                        {{1, 0, 0}, {{0, 0.6f, 0.8f}, {0.75f, 0.25f}}},
                                                        {{0, 1, 0}, {{0, 0.6f, 0.8f}, {0.125f, 0.875f}}},
                                                        {{5, 0, 0}, {{1, 0, 0}, {0.5f, 0}}},
                                                        {{5, 1, 2}, {{0, 1, 0}, {1, 0.5f}}},
                                                        {{5, 0, 2}, {{0, 0, 1}, {0, 1}}}};

class OwnMeshes : public cli_test::Command
{
protected:
    claque::model::Model converted()
    {
        std::ofstream file(path("two.obj"));
        for (const auto &[at, corner] : corners)
            file << "v " << at[0] << ' ' << at[1] << ' ' << at[2] << "\nvn " << corner.normal.x << ' '
                 << corner.normal.y << ' ' << corner.normal.z << "\nvt " << corner.uv.x << ' ' << corner.uv.y << '\n';
        const auto triangle = [&](const char *name, std::array<std::array<float, 3>, 3> places) {
            file << "o " << name << "\nf";
            for (const auto &at : places) {
                const auto number = 1 + std::distance(corners.begin(), corners.find(at));
                file << ' ' << number << '/' << number << '/' << number;
            }
            file << '\n';
        };
        triangle("left", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
        triangle("right", {{{5, 0, 0}, {5, 1, 2}, {5, 0, 2}}});
        file.close();
        convert::Options options;
        options.picture = path("one.tga");  // without one, texture coordinates are not read
        std::ofstream(options.picture, std::ios::binary)
            << std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x18\0", 18) << "bgr";
        const std::string glb = convert::convert_file(path("two.obj"), options, {}).glb;
        return claque::asset::load_gltf(reinterpret_cast<const uint8_t *>(glb.data()), glb.size(), {});
    }
};

TEST_F(OwnMeshes, AreAllThereInTheirOrder)
{
    const claque::model::Model made = converted();
    ASSERT_EQ(made.parts.size(), 2u);
    EXPECT_EQ(made.parts[0].name, "left");
    EXPECT_EQ(made.parts[1].name, "right");
    for (const claque::model::Part &part : made.parts) EXPECT_EQ(part.indices.size(), 3u) << part.name;
}

TEST_F(OwnMeshes, HaveTheNormalsAndTextureCoordinatesOfTheirFile)
{
    size_t seen = 0;
    for (const claque::model::Part &part : converted().parts) {
        ASSERT_EQ(part.normals.size(), part.positions.size()) << part.name;
        ASSERT_EQ(part.uvs.size(), part.positions.size()) << part.name;
        for (size_t i = 0; i < part.positions.size(); ++i, ++seen) {
            const glm::vec3 &p = part.positions[i];
            const auto found = corners.find({p.x, p.y, p.z});
            ASSERT_NE(found, corners.end()) << p.x << ' ' << p.y << ' ' << p.z;
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(part.normals[i][k], found->second.normal[k], 1e-6f) << k;
            EXPECT_NEAR(part.uvs[i].x, found->second.uv.x, 1e-6f);
            EXPECT_NEAR(part.uvs[i].y, 1 - found->second.uv.y, 1e-6f) << "v of glTF points down";
        }
    }
    EXPECT_EQ(seen, corners.size());
}

// Counter-clockwise as in the file, so that a surface does not turn inside out.
TEST_F(OwnMeshes, TurnTheFrontOfTheirTrianglesToTheSameSide)
{
    for (const claque::model::Part &part : converted().parts) {
        ASSERT_EQ(part.indices.size(), 3u);
        const auto at = [&](size_t k) { return part.positions[part.indices[k]]; };
        const glm::vec3 front = glm::cross(at(1) - at(0), at(2) - at(0));
        if (part.name == "left") EXPECT_EQ(front, glm::vec3(0, 0, 1));
        else EXPECT_EQ(front, glm::vec3(2, 0, 0));
    }
}

}  // namespace
}  // namespace convert_test
