// Reading takes time in proportion to the file, whatever it holds: work is counted, never timed.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "attacks.h"
#include "lib/asset/bvh.h"
#include "lib/asset/file_cache.h"
#include "lib/asset/zone_clusters.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

// Ten times the count may take so many times the work: n log n, with room for what does not grow evenly.
constexpr uint64_t most_ratio = 16;

uint64_t reading(const Attack &attack, size_t count)
{
    const Bytes bytes = attack.make(count);
    return blocks_entered([&] {
        const Outcome outcome = outcome_of([&] {
            if (attack.bvh) asset::load_bvh(bytes.data(), bytes.size(), {});
            else load(bytes);
        });
        EXPECT_TRUE(outcome.status == 0 || outcome.status == CLQ_LIMIT) << attack.name << ": " << outcome.text;
    });
}

TEST(ReaderWork, GrowsWithTheFileWhateverItCounts)
{
    for (const Attack &attack : reader_attacks()) {
        const uint64_t few = reading(attack, 300), many = reading(attack, 3000);
        EXPECT_GT(few, 3000u) << attack.name << ": nothing is counted";
        EXPECT_LE(many, most_ratio * few) << attack.name;
        RecordProperty(attack.name, std::to_string(double(many) / double(few)));
    }
}

// Images that read the same bytes are one, so that a picture is decoded once however many images show it.
TEST(ReaderWork, OfImagesOnOneViewDoesNotGrowWithTheirTexels)
{
    const auto reading_images = [](size_t count, uint32_t side) {
        const Bytes bytes = images_on_one_view(count, side, false);
        size_t images = 0;
        const uint64_t work = blocks_entered([&] { images = load(bytes).images.size(); });
        EXPECT_EQ(images, 1u);
        return work;
    };
    const uint64_t small = reading_images(200, 8) - reading_images(1, 8);
    const uint64_t large = reading_images(200, 200) - reading_images(1, 200);
    EXPECT_LE(large, small + small / 10);
}

// Extras may tell images of the same bytes apart. Then each is decoded, and counts as if the file held its texels.
TEST(ReaderWork, OfImagesThatExtrasTellApartIsRefusedBeyondTheFilesSize)
{
    const Bytes few = images_on_one_view(20, 64, true), many = images_on_one_view(3000, 256, true);
    EXPECT_EQ(load(few).images.size(), 20u);
    const Outcome outcome = outcome_of(many);
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
    EXPECT_NE(outcome.text.find("would take 262144 bytes: more than 40 times"), std::string::npos) << outcome.text;
}

TEST(ReaderWork, OfAFileThatNamesItselfManyTimesIsToReadItOnce)
{
    std::string folder = (std::filesystem::temp_directory_path() / "claque-work-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    const auto hashing = [&](size_t count) {
        Maker maker;
        for (size_t i = 0; i < count; ++i)
            maker.add("buffers", {{"uri", (i % 2 ? "./" : "") + std::string("self.gltf")}, {"byteLength", 4}});
        const Bytes bytes = maker.text();
        std::ofstream(folder + "/self.gltf", std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return blocks_entered([&] {
            asset::ContentHash hash;
            asset::add_file(folder + "/self.gltf", folder, 1u << 30, hash);
        });
    };
    const uint64_t few = hashing(300), many = hashing(3000);
    std::filesystem::remove_all(folder);
    EXPECT_LE(many, most_ratio * few);
}

// A model that shows its image on `count` triangles, each over nearly all of it.
model::Model stacked(size_t count, bool shifted)
{
    model::Model model;
    model.name = "stack";
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    model.images.push_back({64, 64, std::vector<uint8_t>(4 * 64 * 64, 200), model::AlphaMeaning::opacity, "paint"});
    model.materials.emplace_back();
    model.materials[0].image = 0;
    model::Part &part = model.parts.emplace_back();
    part.material = 0, part.node = 0;
    for (size_t i = 0; i < count; ++i)
        for (const glm::vec2 uv : {glm::vec2(0.01f, 0.01f), glm::vec2(0.9f, 0), glm::vec2(0, 0.9f)}) {
            part.positions.emplace_back(uv.x, uv.y, 0.0f);
            part.uvs.push_back(uv + glm::vec2(shifted ? float(i) * 1e-6f : 0.0f));
        }
    part.joints.assign(3 * count, 0), part.weights.assign(3 * count, 1.0f);
    return model;
}

TEST(ReaderWork, OfProposedZonesGrowsWithTheTrianglesAndNotWithTheirAreas)
{
    for (const bool shifted : {false, true}) {
        const auto proposing = [&](size_t count) {
            const model::Model model = stacked(count, shifted);
            return blocks_entered([&] { asset::propose_zones(model, 0, 4); });
        };
        const uint64_t one = proposing(1), many = proposing(3001);
        // 64 rows of a triangle, and not its 1660 texels.
        EXPECT_LE((many - one) / 3000, shifted ? 64u * 200 : 1000u);
    }
}

TEST(ReaderWork, OfProposedZonesIsRefusedBeyondTheRowsOfTheTriangles)
{
    model::Model model = stacked(1200, true);
    model.images[0] = {1, 4096, std::vector<uint8_t>(4 * 4096, 200), model::AlphaMeaning::opacity, "paint"};
    for (glm::vec2 &uv : model.parts[0].uvs) uv.y *= 4;  // 14 700 rows each
    const Outcome outcome = outcome_of([&] { asset::propose_zones(model, 0, 4); });
    EXPECT_EQ(outcome.status, CLQ_LIMIT);
    EXPECT_NE(outcome.text.find("1200 triangles of 'stack' cover more than 17"), std::string::npos) << outcome.text;
}

TEST(ProposedZones, CoverTheTexelsWhoseCentresLieInTriangles)
{
    for (uint32_t seed = 1; seed <= 200; ++seed) {
        model::Model model = stacked(1, false);
        uint32_t state = seed * 2654435761u;
        const auto next = [&] { return state = state * 1664525u + 1013904223u, float(state >> 8) / 8388608.0f - 0.5f; };
        for (glm::vec2 &uv : model.parts[0].uvs) uv = {next(), next()};
        const asset::ZoneProposal proposal = asset::propose_zones(model, 0, 1);
        std::vector<bool> expected(64 * 64);
        double x[3], y[3];
        for (size_t k = 0; k < 3; ++k)
            x[k] = double(model.parts[0].uvs[k].x) * 64, y[k] = double(model.parts[0].uvs[k].y) * 64;
        const auto mark = [&](double px, double py) {
            px -= 64 * std::floor(px / 64), py -= 64 * std::floor(py / 64);
            expected[size_t(py) * 64 + size_t(px)] = true;
        };
        for (size_t k = 0; k < 3; ++k) mark(x[k], y[k]);
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        for (double py = -64.5; py < 130; ++py)
            for (double px = -64.5; px < 130; ++px) {
                const double a = ((x[1] - px) * (y[2] - py) - (x[2] - px) * (y[1] - py)) / area;
                const double b = ((x[2] - px) * (y[0] - py) - (x[0] - px) * (y[2] - py)) / area;
                if (a >= 0 && b >= 0 && a + b <= 1) mark(px, py);
            }
        for (size_t i = 0; i < expected.size(); ++i)
            ASSERT_EQ(proposal.zones[i] == 0, expected[i]) << "seed " << seed << ", texel " << i;
    }
}

}  // namespace
}  // namespace claque::testing
