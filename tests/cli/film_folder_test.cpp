// claque frames check: manifests whose entries are not the files of their frames.
#include <fstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

// Frames "a" and "b" beside a manifest.
class FilmFolder : public Command
{
protected:
    struct Entry {
        std::string frame, file;
        char text;
    };
    Outcome check(const std::vector<Entry> &entries, const std::string &pattern = "f-%d.png") const
    {
        const std::string sha256[] = {"ca978112ca1bbdcafac231b39a23dc4da786eff8147c4e72b9807785afee48bb",
                                      "3e23e8160039594a33894f6564e1b1348bbd7a0088d42c4acb73eeaed59c009d"};
        std::string frames;
        for (const Entry &one : entries)
            frames += (frames.empty() ? "" : ", ") + std::string("{\"frame\": ") + one.frame + ", \"file\": \"" +
                      one.file + "\", \"sha256\": \"" + sha256[one.text - 'a'] + "\"}";
        std::ofstream(path("m.json")) << R"({"claque_manifest": 1, "about": {}, "asked": "0,1", "pattern": ")"
                                      << pattern << R"(", "frames": [)" << frames << "]}";
        std::ofstream(path("f-0.png")) << "a";
        std::ofstream(path("f-1.png")) << "b";
        return claque({"frames", "check", path(".")});
    }
};

TEST_F(FilmFolder, IsWholeWhereEveryFrameHasItsOwnFile)
{
    EXPECT_EQ(check({{"0", "f-0.png", 'a'}, {"1", "f-1.png", 'b'}}).code, 0);
    const auto wrong = [&](const std::vector<Entry> &entries, const std::string &says) {
        const Outcome done = check(entries);
        EXPECT_EQ(done.code, 1) << says;
        EXPECT_NE((done.out + done.err).find(says), std::string::npos) << done.out << done.err;
    };
    wrong({{"0", "f-0.png", 'a'}, {"1", "f-0.png", 'a'}}, "m.json: frame 1 is \"f-0.png\" instead of \"f-1.png\"");
    wrong({{"0", "f-1.png", 'b'}, {"1", "f-0.png", 'a'}}, "m.json: frame 0 is \"f-1.png\" instead of \"f-0.png\"");
    wrong({{"0", "f-0.png", 'a'}, {"0", "f-0.png", 'a'}, {"1", "f-1.png", 'b'}},
          "m.json has \"f-0.png\" a second time");
    for (const std::string &file : {path("f-1.png"), std::string("../f-1.png"), std::string("./f-1.png"),
                                    std::string("x/f-1.png"), std::string(".."), std::string("f-1.png/")})
        wrong({{"0", "f-0.png", 'a'}, {"1", file, 'b'}},
              "m.json: frame 1 is \"" + file + "\", which is no name of a file beside the manifest");
    for (const char *number : {"4294967297", "1.5", "-1", "1e300", "\"1\""})
        wrong({{number, "f-1.png", 'b'}}, std::string(" is no number of a frame"));
    for (const char *pattern : {"", "f-1.png"}) {
        const Outcome done = check({{"0", "f-0.png", 'a'}, {"1", "f-1.png", 'b'}}, pattern);
        EXPECT_EQ(done.code, 1);
        EXPECT_NE(done.err.find("m.json does not say how its files are named"), std::string::npos) << done.err;
    }
}

}  // namespace
}  // namespace cli_test
