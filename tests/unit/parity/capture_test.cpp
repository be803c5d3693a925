// Reading a result's folder: complete, partial and invalid ones.
#include "samples/parity/capture.h"

#include "tests/unit/parity/capture_files.h"

namespace parity
{
namespace
{

class CaptureFolder : public parity_test::CaptureFiles
{
protected:
    CaptureFolder() { write_result("r"); }

    // The message of refusing the folder, its path as ".".
    std::string refusal(const std::string &name = "r") const
    {
        try {
            read_capture(folder(name));
            return "read";
        } catch (const Unreadable &error) {
            std::string said = error.what();
            const size_t at = said.find(folder(name));
            return at == std::string::npos ? said : said.replace(at, folder(name).size(), ".");
        }
    }
};

TEST_F(CaptureFolder, IsReadWhole)
{
    const Capture c = read_capture(folder("r"));
    EXPECT_EQ(c.renderer, "a test");
    EXPECT_EQ(c.width, 16);
    EXPECT_EQ(c.time_s, 1.5);
    ASSERT_EQ(c.actors->size(), 3u);
    EXPECT_EQ((*c.actors)[1].id, 5u);
    EXPECT_EQ((*c.actors)[1].kind, "man, level 2");
    EXPECT_EQ((*c.actors)[1].first_vertex, 3u);
    EXPECT_EQ(*(*c.actors)[2].zones, (std::vector<std::string>{"plumage"}));
    EXPECT_EQ((*c.actors)[2].size_m, 0.5);
    EXPECT_EQ(c.positions->size(), 30u);
    EXPECT_EQ(c.colour->rgb.size(), 16u * 12 * 3);
    EXPECT_EQ(c.actor->at(3, 0), 2u);
    EXPECT_EQ(c.zone->at(9, 11), 2u);
    EXPECT_EQ(c.depth->at(0, 0), 1.0f);
}

// So that a folder of many meshes and zones takes no more memory than it has bytes, many times over.
TEST_F(CaptureFolder, HoldsTheZonesOfATemplateOnce)
{
    const Capture c = read_capture(folder("r"));
    EXPECT_EQ((*c.actors)[0].zones, (*c.actors)[1].zones);
    EXPECT_NE((*c.actors)[0].zones, (*c.actors)[2].zones);
    replace("r", "capture.json", "\"man\"", "\"" + std::string(1025, 'm') + "\"");
    EXPECT_NE(refusal().find("'name' has to be a string of at most 1024 bytes"), std::string::npos) << refusal();
}

TEST_F(CaptureFolder, MayLeaveOutAnyArray)
{
    for (const char *file : {"actors.npy", "sizes.npy", "positions.npy", "normals.npy", "colour.npy", "depth.npy",
                             "actor.npy", "zone.npy"}) {
        remove("r", file);
        EXPECT_EQ(refusal(), "read") << file;
    }
}

TEST_F(CaptureFolder, IsRefusedIfItHoldsNoResult)
{
    EXPECT_EQ(refusal("nowhere"), ". is not a folder");
    remove("r", "capture.json");
    EXPECT_EQ(refusal(), "./capture.json could not be opened: No such file or directory");
    write("r", "capture.json", "{");
    EXPECT_EQ(refusal(), "./capture.json is not JSON");
    write("r", "capture.json",
          "{\"scene\": " + std::string(300000, '[') + std::string(300000, ']') + ", \"format\": \"claque-parity\"}");
    EXPECT_EQ(refusal(), "./capture.json is nested more than 64 deep");
    for (const char *text : {"[]", "3", "{}", "null"}) {
        write("r", "capture.json", text);
        EXPECT_EQ(refusal(), "./capture.json has no 'format'; docs/parity.md lists what a result needs");
    }
}

TEST_F(CaptureFolder, WithAnInvalidFieldIsRefused)
{
    const std::vector<std::vector<std::string>> wrong = {
        {"\"claque-parity\"", "\"other\"", "./capture.json: its format is not claque-parity"},
        {"\"kind\": \"result\"", "\"kind\": \"scene\"",
         "./capture.json: its kind is 'scene', and a result is expected"},
        {"\"actors\": 3", "\"actors\": 2", "./actors.npy has 3 actors, and capture.json says 2"},
        {"\"vertices\": 10", "\"vertices\": 11", "./actors.npy has 10 vertices, and capture.json says 11"},
        {"\"version\": 1", "\"version\": 2", "./capture.json is of version 2, and version 1 can be read"},
        {"\"width\": 16", "\"width\": 0", "./capture.json: 'width' has to be a number from 1.0 to 16384.0"},
        {"\"width\": 16", "\"width\": \"16\"", "./capture.json: 'width' has to be a number from 1.0 to 16384.0"},
        {"\"width\": 16", "\"width\": 16.5", "./capture.json: 'width' has to be a whole number"},
        {"\"width\": 16", "\"width\": 4294967312", "./capture.json: 'width' has to be a number from 1.0 to 16384.0"},
        {"\"time_s\": 1.5", "\"time_s\": null",
         "./capture.json: 'time_s' has to be a number from -1000000000000.0 to 1000000000000.0"},
        {"\"template\": 1", "\"template\": 2", "./capture.json: a mesh names template 2 of 2"},
        {"\"level\": 2", "\"level\": 2.5", "./capture.json: 'level' has to be a whole number"},
        {"\"actor_columns\": [", "\"actor_columns\": [1, ",
         "./capture.json: 'actor_columns' has to be a list of strings"},
        {"\"mesh\"", "\"mash\"", "./actors.npy has no column 'mesh'"},
        {", \"later\"", "", "./actors.npy has the shape (3, 5), and capture.json names 4 columns"},
        {"\"vertices\": 3", "\"vertices\": 4", "./actors.npy, row 0: 3 vertices of a mesh that has 4"},
        {"\"height\": 12", "\"height\": 13",
         "./colour.npy has the shape (12, 16, 3), and (13, 16, 3) follows from capture.json"}};
    for (const auto &w : wrong) {
        write_result("r");
        replace("r", "capture.json", w[0], w[1]);
        EXPECT_EQ(refusal(), w[2]);
    }
}

TEST_F(CaptureFolder, NeedsEveryFieldThatThePageMarksAsNeeded)
{
    for (const char *field : {"format", "version", "kind", "renderer", "scene", "width", "height", "time_s", "actors",
                              "vertices", "actor_columns", "templates", "meshes"}) {
        write_result("r");
        replace("r", "capture.json", "\"" + std::string(field) + "\": ", "\"x\": ");
        EXPECT_EQ(refusal(),
                  "./capture.json has no '" + std::string(field) + "'; docs/parity.md lists what a result needs");
    }
    for (const char *field : {"actors", "vertices", "actor_columns", "templates", "meshes"}) {
        write_result("r");
        remove("r", "actors.npy");
        replace("r", "capture.json", "\"" + std::string(field) + "\": ", "\"x\": ");
        EXPECT_EQ(refusal(), "read") << field << " belongs to actors.npy";
    }
}

TEST_F(CaptureFolder, WithInconsistentArraysIsRefused)
{
    using parity_test::npy;
    using parity_test::numbers;
    const auto refuses = [this](const char *file, const std::string &bytes, const char *sentence) {
        write_result("r");
        write("r", file, bytes);
        EXPECT_EQ(refusal(), sentence);
    };
    refuses("positions.npy", npy("<f4", "9, 3", std::vector<float>(27)),
            "./positions.npy has the shape (9, 3), and (10, 3) follows from actors.npy");
    refuses("sizes.npy", npy("<f4", "2,", std::vector<float>(2)),
            "./sizes.npy has the shape (2), and (3) follows from actors.npy");
    refuses("depth.npy", npy("<f4", "192,", std::vector<float>(192)),
            "./depth.npy has the shape (192), and (12, 16) follows from capture.json");
    refuses("actor.npy", npy("<i8", "12, 16", std::vector<int64_t>(192)),
            "./actor.npy holds '<i8', and '<u4' is expected: .astype(np.uint32) before saving");
    refuses("actors.npy", numbers({5, 0, 0, 3, 0, 2, 0, 3, 3, 0, 6, 1, 6, 4, 0}, 5),
            "./actors.npy, row 1: actor 2 is not above the one before");
    refuses("actors.npy", numbers({0, 0, 0, 3, 0, 5, 0, 3, 3, 0, 6, 1, 6, 4, 0}, 5),
            "./actors.npy, row 0: actor 0 is not above the one before");
    refuses("actors.npy", numbers({2, 9, 0, 3, 0, 5, 0, 3, 3, 0, 6, 1, 6, 4, 0}, 5),
            "./actors.npy, row 0: mesh 9 of 2");
    refuses("actors.npy", numbers({2, 0, 4000000000u, 3, 0, 5, 0, 3, 3, 0, 6, 1, 6, 4, 0}, 5),
            "./positions.npy has the shape (10, 3), and (4000000003, 3) follows from actors.npy");
    refuses("colour.npy", "", "./colour.npy is not a NumPy array: it does not begin as one");
}

}  // namespace
}  // namespace parity
