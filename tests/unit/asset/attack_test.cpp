// Attacks that no collection has: made here, byte by byte.
#include <sys/stat.h>
#include <unistd.h>

#include "assets.h"
#include "heap_meter.h"
#include "lib/asset/image.h"
#include "png.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t mega = 1u << 20;

Bytes bytes_of(const std::string &text) { return Bytes(text.begin(), text.end()); }

// A folder of its own that goes with the test.
class Folder
{
public:
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "claque-asset-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    const std::string &path() const { return path_; }
    void write(const std::string &name, const Bytes &bytes) const
    {
        std::ofstream(path_ + "/" + name, std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    asset::LoadOptions options() const
    {
        asset::LoadOptions options;
        options.base_folder = path_;
        return options;
    }

private:
    std::string path_;
};

Bytes with_buffer_uri(const std::string &uri)
{
    Maker maker;
    maker.json["buffers"] = Json::array({{{"uri", uri}, {"byteLength", 4}}});
    return maker.text();
}

TEST(Attack, JsonNestedAMillionDeepIsRefusedWithoutDescending)
{
    std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(1000000, '[');
    EXPECT_EQ(outcome_of(bytes_of(deep)).status, CLQ_LIMIT);
    deep += std::string(1000000, ']') + "}";
    EXPECT_EQ(outcome_of(bytes_of(deep)).status, CLQ_LIMIT);
}

// A skeleton may be a chain: nothing that reads it descends by recursion.
TEST(Attack, ChainsOfNodesAndJointsAreReadOrRefusedHoweverLong)
{
    Maker maker;
    maker.triangle();
    constexpr int count = 50000;
    maker.json["nodes"] = Json::array();
    for (int i = 0; i + 1 < count; ++i) maker.json["nodes"].push_back({{"children", {i + 1}}});
    maker.json["nodes"].push_back({{"mesh", 0}});
    const Outcome chain = outcome_of(maker.glb());
    EXPECT_TRUE(chain.status == 0 || chain.status == CLQ_LIMIT) << chain.text;

    std::string bvh = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
    for (int i = 0; i < count; ++i) bvh += "JOINT b\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
    const Outcome skeleton = outcome_of(bytes_of(bvh));
    EXPECT_NE(skeleton.status, 0);
    EXPECT_FALSE(skeleton.text.empty());
}

TEST(Attack, JsonOfManySmallValuesTakesASmallMultipleOfItsSize)
{
    for (const char *value : {"0,", "[],", "{},", "{\"a\":{}},", "\"\",", "[[0]],"}) {
        std::string text = "{\"asset\":{\"version\":\"2.0\"},\"extras\":[";
        while (text.size() < mega) text += value;
        text += "0]}";
        const Bytes bytes = bytes_of(text);
        EXPECT_LE(peak_heap_bytes([&] { EXPECT_EQ(outcome_of(bytes).status, 0) << value; }), 64 * bytes.size())
            << value;
    }
}

TEST(Attack, JsonThatWouldNotFitTheLimitIsRefusedBeforeItIsParsed)
{
    const std::pair<std::string, uint64_t> cases[] = {{std::string(2 * mega, ','), 16 * mega},
                                                      {'"' + std::string(2 * mega, 'a') + "\",", 3 * mega}};
    for (const auto &[values, limit_bytes] : cases) {
        const Bytes bytes = bytes_of("{\"asset\":{\"version\":\"2.0\"},\"extras\":[" + values + "0]}");
        asset::LoadOptions options;
        options.memory_limit_bytes = limit_bytes;
        Outcome outcome;
        EXPECT_LE(peak_heap_bytes([&] { outcome = outcome_of(bytes, options); }), mega);
        EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
    }
}

TEST(Attack, GlbChunkThatLiesAboutItsLengthIsRefused)
{
    Maker maker;
    maker.triangle();
    for (const uint32_t lie : {0xffffffffu, 0xfffffffcu, 0x7ffffffcu, 0u, 4u}) {
        Bytes bytes = maker.glb();
        for (size_t k = 0; k < 4; ++k) bytes[12 + k] = static_cast<uint8_t>(lie >> (8 * k));
        EXPECT_EQ(outcome_of(bytes).status, CLQ_FORMAT) << lie;
    }
}

TEST(Attack, GlbCutAtAnyByteIsRefused)
{
    Maker maker;
    maker.triangle();
    const Bytes whole = maker.glb();
    EXPECT_EQ(outcome_of(whole).status, 0);
    for (size_t length = 0; length < whole.size(); ++length) {
        Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_EQ(outcome_of(cut).status, CLQ_FORMAT) << length;
        if (length < 12) continue;
        // And with a header that says the cut is all there is.
        for (size_t k = 0; k < 4; ++k) cut[8 + k] = static_cast<uint8_t>(length >> (8 * k));
        EXPECT_EQ(outcome_of(cut).status, CLQ_FORMAT) << length;
    }
}

TEST(Attack, RangesThatOverflowAreRefused)
{
    const uint64_t huge[] = {1ull << 63, ~0ull, (1ull << 48) - 1, 1ull << 32, 0xffffffffull, 37};
    for (const uint64_t number : huge) {
        Maker maker;
        maker.triangle();
        const Json good = maker.json;
        maker.json["bufferViews"][0]["byteOffset"] = number;
        EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << number;
        maker.json = good;
        maker.json["bufferViews"][0]["byteLength"] = number;
        EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << number;
        maker.json = good;
        maker.json["accessors"][0]["byteOffset"] = number;
        EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << number;
        maker.json = good;
        maker.json["accessors"][0]["count"] = number;
        EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << number;
    }
}

TEST(Attack, AccessorsWithoutDataCannotAskForMemory)
{
    Maker maker;
    maker.triangle();
    maker.json["accessors"][0].erase("bufferView");
    maker.json["accessors"][0]["count"] = 4294967295u;
    Outcome outcome;
    EXPECT_LE(peak_heap_bytes([&] { outcome = outcome_of(maker.glb()); }), 16 * mega);
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
}

TEST(Attack, OneMeshOnAHundredThousandNodesCannotAskForMemory)
{
    Maker maker;
    const size_t vertices = 3000;
    maker.add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", 0}}}}})}});
    maker.floats("VEC3", vertices, std::vector<float>(3 * vertices, 1.0f));
    for (int i = 0; i < 100000; ++i) maker.add("nodes", {{"mesh", 0}});
    const Bytes bytes = maker.glb();
    Outcome outcome;
    EXPECT_LE(peak_heap_bytes([&] { outcome = outcome_of(bytes); }), 64 * bytes.size() + 16 * mega);
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
}

TEST(Attack, FoldersPipesAndDevicesAreNotFiles)
{
    const Folder folder;
    ASSERT_EQ(mkfifo((folder.path() + "/pipe").c_str(), 0600), 0);
    std::filesystem::create_directory(folder.path() + "/folder");
    folder.write("good.bin", {1, 2, 3, 4});
    EXPECT_EQ(outcome_of(with_buffer_uri("pipe"), folder.options()).status, CLQ_IO);
    EXPECT_EQ(outcome_of(with_buffer_uri("folder"), folder.options()).status, CLQ_IO);
    EXPECT_EQ(outcome_of(with_buffer_uri("absent"), folder.options()).status, CLQ_IO);
    EXPECT_EQ(outcome_of(with_buffer_uri("good.bin"), folder.options()).status, 0);
    EXPECT_EQ(outcome_of(with_buffer_uri("good.bin")).status, CLQ_IO) << "no folder was given";
    EXPECT_EQ(outcome_of([] { asset::read_file("/dev/zero", 1000); }).status, CLQ_IO);
}

TEST(Attack, NothingOutsideTheFolderIsOpened)
{
    const Folder folder;
    for (const char *uri : {"../x.bin", "a/../../x.bin", "%2e%2e/x.bin", "..%2Fx.bin", "/etc/hostname",
                            "%2Fetc%2Fhostname", "a\\..\\x.bin", "x%00.bin", "", "%"})
        EXPECT_EQ(outcome_of(with_buffer_uri(uri), folder.options()).status, CLQ_FORMAT) << uri;
    for (const char *uri : {"http://example.org/x.bin", "file:///etc/hostname", "c:/x.bin"})
        EXPECT_EQ(outcome_of(with_buffer_uri(uri), folder.options()).status, CLQ_UNSUPPORTED) << uri;
}

TEST(Attack, PercentCodesAreDecodedAndPlusStaysPlus)
{
    const Folder folder;
    folder.write("a b+c.bin", {1, 2, 3, 4});
    EXPECT_EQ(outcome_of(with_buffer_uri("a%20b+c.bin"), folder.options()).status, 0);
    EXPECT_EQ(outcome_of(with_buffer_uri("./a%20b%2Bc.bin"), folder.options()).status, 0);
    EXPECT_EQ(outcome_of(with_buffer_uri("a+b+c.bin"), folder.options()).status, CLQ_IO);
}

TEST(Attack, PngOfFewBytesAndManyPixelsIsNotBelieved)
{
    const Bytes bomb = make_png(16384, 16384, 1, Bytes(2049, 0), 16384);
    EXPECT_LT(bomb.size(), 300000u);
    Outcome outcome;
    EXPECT_LE(peak_heap_bytes(
                  [&] { outcome = outcome_of([&] { asset::decode_image(bomb.data(), bomb.size(), "bomb", {}); }); }),
              mega);
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
}

TEST(Attack, PngChunkThatLiesAboutItsLengthIsRefused)
{
    Bytes png = make_png(8, 8, 8, Bytes(9, 0), 8);
    EXPECT_EQ(outcome_of([&] { asset::decode_image(png.data(), png.size(), "good", {}); }).status, 0);
    png[33] = 0x5f;  // the first byte of the length of IDAT
    EXPECT_EQ(outcome_of([&] { asset::decode_image(png.data(), png.size(), "liar", {}); }).status, CLQ_FORMAT);
}

TEST(Attack, PngThatHoldsMoreThanItsPixelsIsRefused)
{
    // 8 x 8 pixels, and 64 MB of zeros in well packed data behind them.
    const Bytes png = make_png(8, 8, 8, Bytes(65536, 0), 1024);
    EXPECT_EQ(outcome_of([&] { asset::decode_image(png.data(), png.size(), "deep", {}); }).status, CLQ_FORMAT);
}

}  // namespace
}  // namespace claque::testing
