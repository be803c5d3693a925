// inspect, dump, split and prepare: their outputs, read by independent readers.
#include <cmath>
#include <cstring>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/support/collected_file.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

using Files = Command;
using Json = nlohmann::json;

Json inspected(const std::string &file)
{
    const Outcome outcome = claque({"inspect", file, "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << outcome.out.substr(0, 200);
    return json;
}

struct Table {
    std::string shape;
    std::vector<float> values;
};

// Reads .npy 1.0 by its published description.
Table read_npy(const std::string &path)
{
    const std::string bytes = file_text(path);
    Table table;
    if (bytes.size() < 10 || bytes.substr(0, 8) != std::string("\x93NUMPY\x01\x00", 8)) return table;
    const size_t text = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    const std::string header = bytes.substr(10, text);
    EXPECT_EQ((10 + text) % 64, 0u);
    EXPECT_EQ(header.back(), '\n');
    EXPECT_NE(header.find("'descr': '<f4'"), std::string::npos);
    EXPECT_NE(header.find("'fortran_order': False"), std::string::npos);
    const size_t shape = header.find("'shape': (");
    table.shape = header.substr(shape + 9, header.find(')', shape) - shape - 8);
    table.values.resize((bytes.size() - 10 - text) / sizeof(float));
    std::memcpy(table.values.data(), bytes.data() + 10 + text, table.values.size() * sizeof(float));
    return table;
}

TEST_F(Files, InspectAsJsonSaysWhatTheCitizenIs)
{
    const Json json = inspected("citizen");
    EXPECT_EQ(json["loaded"]["clips"].size(), 23u);
    EXPECT_EQ(json["split"]["zones"].size(), 8u);
    EXPECT_EQ(json["split"]["clean"].get<int>() + json["split"]["dirty"].get<int>(),
              json["split"]["triangles"].get<int>());
    EXPECT_GT(json["loaded"]["clips"][1]["duration_s"].get<double>(), 0.5);
    EXPECT_EQ(json["loaded"]["part_list"].size(), json["loaded"]["parts"].get<size_t>());
}

TEST_F(Files, InspectAsTextNamesPartsClipsAndZones)
{
    const Outcome outcome = claque({"inspect", "citizen"});
    EXPECT_EQ(outcome.code, 0);
    for (const char *word : {"triangles", "clean", "dirty", "applaud", "tunic", "influences"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
}

TEST_F(Files, DumpHasARowAVertex)
{
    const std::string out = path("rest.npy");
    ASSERT_EQ(claque({"dump", "citizen", "--out", out}).code, 0);
    const Table table = read_npy(out);
    const size_t vertices = inspected("citizen")["loaded"]["vertices"].get<size_t>();
    EXPECT_EQ(table.shape, "(" + std::to_string(vertices) + ", 3)");
    ASSERT_EQ(table.values.size(), 3 * vertices);
    float low = 1e9f, high = -1e9f;
    for (size_t i = 1; i < table.values.size(); i += 3) {
        low = std::min(low, table.values[i]);
        high = std::max(high, table.values[i]);
    }
    EXPECT_NEAR(low, 0.0f, 0.05f) << "sandals on the ground";
    EXPECT_NEAR(high, 1.75f, 0.08f);
}

TEST_F(Files, DumpTakesClipsByNameAndNumberAndClampsTheTime)
{
    const Json clips = inspected("citizen")["loaded"]["clips"];
    const std::string name = clips[1]["name"];
    const auto dump = [&](const std::string &clip, const std::string &time, const std::string &file) {
        const Outcome outcome = claque({"dump", "citizen", "--clip", clip, "--time", time, "--out", path(file)});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return file_text(path(file));
    };
    const std::string half = dump(name, "0.5", "a.npy");
    EXPECT_EQ(half, dump("1", "0.5", "b.npy"));
    EXPECT_NE(half, dump(name, "0.25", "c.npy"));
    EXPECT_EQ(dump(name, "-5", "d.npy"), dump(name, "0", "e.npy"));
    EXPECT_EQ(dump(name, "1e6", "f.npy"), dump(name, "999", "g.npy"));
}

TEST_F(Files, SplitReportsAndDrawsTheZoneMap)
{
    const std::string picture = path("split.png");
    const Outcome outcome = claque({"split", "citizen", "--picture", picture, "--scale", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char *word : {"clean", "dirty", "skin", "sandals", "zones"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
    const std::string png = file_text(picture);
    ASSERT_GT(png.size(), 1000u);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(static_cast<unsigned char>(png[18]), 4) << "512 texels at 2 pixels each are 1024";
    EXPECT_EQ(left(), (std::vector<std::string>{"split.png"}));
}

TEST_F(Files, APreparedCitizenIsSplitAsTheCitizenIs)
{
    const std::string clq = path("citizen.clq");
    ASSERT_EQ(claque({"prepare", "citizen", "--out", clq}).code, 0);
    EXPECT_EQ(inspected(clq)["split"], inspected("citizen")["split"]);
}

TEST_F(Files, APreparedFileThatIsCutIsRefused)
{
    const std::string clq = path("citizen.clq"), cut = path("cut.clq");
    ASSERT_EQ(claque({"prepare", "citizen", "--out", clq}).code, 0);
    const std::string whole = file_text(clq);
    std::ofstream(cut, std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_EQ(claque({"inspect", cut}).code, 1);
}

struct CharacterFile {
    const char *name, *clip;
    size_t clips;
    int triangles;
};

class FilesOf : public Files, public testing::WithParamInterface<CharacterFile>
{
};

TEST_P(FilesOf, CharactersAreInspectedDumpedSplitAndPrepared)
{
    const CharacterFile &listed = GetParam();
    const std::string file = written::path_of(listed.name, CLAQUE_ASSETS_DIR);
    CLAQUE_NEEDS_FILE(file);
    const Json json = inspected(file);
    EXPECT_EQ(json["loaded"]["clips"].size(), listed.clips);
    EXPECT_EQ(json["loaded"]["triangles"].get<int>(), listed.triangles);
    EXPECT_EQ(claque({"dump", file, "--clip", listed.clip, "--time", "0.3", "--out", path("a.npy")}).code, 0);
    EXPECT_EQ(read_npy(path("a.npy")).shape, "(" + json["loaded"]["vertices"].dump() + ", 3)");
    EXPECT_EQ(claque({"split", file, "--picture", path("a.png")}).code, 0);
    EXPECT_EQ(claque({"prepare", file, "--out", path("a.clq")}).code, 0);
}

INSTANTIATE_TEST_SUITE_P(Collected, FilesOf, testing::Values(CharacterFile{"animals/khronos/Fox.glb", "Run", 3, 576}),
                         [](const auto &) { return std::string("Fox"); });
INSTANTIATE_TEST_SUITE_P(Written, FilesOf,
                         testing::Values(CharacterFile{"WrittenPerson.glb", "walk", 3, 580},
                                         CharacterFile{"WrittenRigid.glb", "jolt", 2, 220},
                                         CharacterFile{"WrittenMorph.gltf", "talk", 2, 200},
                                         CharacterFile{"WrittenSparse.gltf", "nod", 4, 500}),
                         [](const auto &file) { return written::case_name(file.param.name); });

}  // namespace
}  // namespace cli_test
