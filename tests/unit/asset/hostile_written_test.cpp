// Written characters with one thing broken in each place where it stands: lengths, counts, references.
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <unistd.h>

#include "heap_meter.h"
#include "lib/base/hash.h"
#include "taken_apart.h"
#include "tests/support/patterns.h"

namespace claque::testing
{
namespace
{

// Refused with this status, in a sentence that has one of these words.
void expect_refused(const Bytes &bytes, const std::string &file, const std::string &what, int status,
                    const std::vector<std::string> &words)
{
    const Outcome outcome = outcome_of(bytes, options_for(file));
    EXPECT_EQ(outcome.status, status) << file << " with " << what << ": " << outcome.text;
    EXPECT_TRUE(is_sentence(outcome.text)) << file << " with " << what << ": " << outcome.text;
    EXPECT_TRUE(has_any(outcome.text, words)) << file << " with " << what << ": " << outcome.text;
}

// "accessors[3].count" of "/accessors/3/count".
std::string path_of_place(const std::string &place)
{
    std::string out;
    std::istringstream parts(place.substr(1));
    for (std::string part; std::getline(parts, part, '/');)
        out += std::isdigit(static_cast<unsigned char>(part[0])) ? "[" + part + "]" : (out.empty() ? "" : ".") + part;
    return out;
}

// "accessors[3]" of "accessors[3].count".
std::string element_of(const std::string &path) { return path.substr(0, path.find(']') + 1); }

// The file with another value at each of these places, one at a time. The sentence names the place or its element, or
// has one of these words.
void expect_refused_at(const std::string &file, const std::vector<std::string> &places, const Json &value, int status,
                       std::vector<std::string> words = {})
{
    TakenApart apart(file);
    for (const std::string &place : places) {
        Json &at = apart.json[Json::json_pointer(place)];
        const Json before = at;
        at = value;
        const std::string path = path_of_place(place);
        std::vector<std::string> names = words;
        names.push_back(path.find(']') == std::string::npos ? path : element_of(path));
        expect_refused(apart.bytes(), file, place + " = " + value.dump(), status, names);
        at = before;
    }
}

// Pointers to everything in the file that `pattern` describes in full.
std::vector<std::string> places_of(const std::string &file, const std::string &pattern)
{
    std::vector<std::string> out;
    const Json flat = TakenApart(file).json.flatten();
    for (auto at = flat.begin(); at != flat.end(); ++at)
        if (patterns::describes(pattern, at.key())) out.push_back(at.key());
    return out;
}

const std::string number = "/[0-9]+";
const std::string accessor_references =
    "/meshes" + number + "/primitives" + number + "/(indices|attributes/[A-Z_0-9]+|targets" + number +
    "/[A-Z]+)|/skins" + number + "/inverseBindMatrices|/animations" + number + "/samplers" + number + "/(input|output)";
const std::string other_references =
    "/scene|/scenes" + number + "/nodes" + number + "|/nodes" + number + "/(mesh|skin|children" + number + ")|/meshes" +
    number + "/primitives" + number + "/material|/skins" + number + "/joints" + number + "|/animations" + number +
    "/channels" + number + "/(sampler|target/node)|/accessors" + number +
    "/(sparse/(indices|values)/)?bufferView|/bufferViews" + number + "/buffer|/textures" + number + "/source|/images" +
    number + "/bufferView|/materials" + number + "/pbrMetallicRoughness/baseColorTexture/index";

// Of accessors that something refers to: the plain half of a sparse accessor may have one of its own that nothing uses.
std::vector<std::string> counts_of(const std::string &file)
{
    const Json json = TakenApart(file).json;
    std::set<std::string> out;
    for (const std::string &place : places_of(file, accessor_references))
        out.insert("/accessors/" + json[Json::json_pointer(place)].dump() + "/count");
    return {out.begin(), out.end()};
}

TEST(HostileWritten, AFileCutAnywhereIsRefused)
{
    for (const std::string &file : written::files()) {
        const Bytes whole = read_asset(file);
        for (size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 1 + whole.size() / 150)
            expect_refused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), file,
                           std::to_string(size) + " of " + std::to_string(whole.size()) + " bytes", CLQ_FORMAT,
                           {size == 0 ? "the file is empty" : "GLB", "JSON"});
    }
}

TEST(HostileWritten, ABufferOfItsOwnThatIsCutIsRefused)
{
    const std::filesystem::path folder = written::folder() + "cut-" + std::to_string(getpid());
    std::filesystem::create_directories(folder);
    std::filesystem::copy(written::folder() + "Written Sparse.png", folder);
    const std::filesystem::path buffer = folder / "Written Sparse.bin";
    std::filesystem::copy(written::folder() + "Written Sparse.bin", buffer);
    asset::LoadOptions options;
    options.base_folder = folder.string();
    const Bytes file = read_asset("WrittenSparse.gltf");
    EXPECT_EQ(outcome_of(file, options).text, "");
    for (uintmax_t size = std::filesystem::file_size(buffer); size > 0;) {
        size = size / 2;
        std::filesystem::resize_file(buffer, size);
        const Outcome outcome = outcome_of(file, options);
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << size;
        EXPECT_NE(outcome.text.find("its data has " + std::to_string(size)), std::string::npos) << outcome.text;
        EXPECT_NE(outcome.text.find("buffers[0]"), std::string::npos) << outcome.text;
    }
    std::filesystem::remove_all(folder);
}

TEST(HostileWritten, ACountThatIsNotItsAccessorsIsRefused)
{
    for (const std::string &file : written::files()) {
        const std::vector<std::string> counts = counts_of(file);
        EXPECT_GE(counts.size(), 3u) << file;
        const Json json = TakenApart(file).json;
        for (const std::string &place : counts) {
            // What does not fit is named by the accessor or by what it is for. One without data is as long as it says.
            const std::vector<std::string> users = {"meshes[0].primitives[", "skins[", "animations["};
            const Json &count = json[Json::json_pointer(place)];
            const bool has_data = json[Json::json_pointer(place).parent_pointer()].contains("bufferView");
            expect_refused_at(file, {place}, count.get<uint64_t>() + 1, CLQ_FORMAT, users);
            expect_refused_at(file, {place}, uint64_t(1) << 31, has_data ? CLQ_FORMAT : CLQ_LIMIT, users);
        }
        for (const Json &count : {Json(uint64_t(1) << 61), Json(0), Json(-1), Json(2.5), Json("4")})
            expect_refused_at(file, counts, count, CLQ_FORMAT);
    }
}

TEST(HostileWritten, ALengthBeyondItsBufferIsRefused)
{
    for (const std::string &file : written::files()) {
        const uint64_t length = TakenApart(file).json["buffers"][0]["byteLength"];
        for (const char *name : {"/byteLength", "/byteOffset"}) {
            const std::vector<std::string> places = places_of(file, "/bufferViews" + number + name);
            EXPECT_GE(places.size(), 2u) << file;
            for (const uint64_t value : {length + 1, uint64_t(1) << 62})
                expect_refused_at(file, places, value, CLQ_FORMAT);
        }
        expect_refused_at(file, {"/buffers/0/byteLength"}, length + 1000, CLQ_FORMAT);
    }
}

TEST(HostileWritten, AReferenceToWhatIsNotThereIsRefused)
{
    for (const std::string &file : written::files())
        for (const std::string *references : {&accessor_references, &other_references}) {
            const std::vector<std::string> places = places_of(file, *references);
            EXPECT_GE(places.size(), 3u) << file;
            for (const Json &value : {Json(100000), Json(-1), Json("0")})
                expect_refused_at(file, places, value, CLQ_FORMAT);
        }
}

// Flipped bits and wild counts: whatever a file claims, memory is bounded by its bytes.
TEST(HostileWritten, NoFileTakesMoreThanASmallMultipleOfItsSize)
{
    const auto expect_small = [](const Bytes &bytes, const std::string &file, const std::string &what) {
        uint64_t pixels = 0;
        const asset::LoadOptions options = options_for(file);
        const uint64_t peak = peak_heap_bytes([&] {
            try {
                for (const model::Image &image : load(bytes, options).images) pixels += image.rgba.size();
            } catch (const base::Error &error) {
                EXPECT_NE(error.status(), CLQ_ARGUMENT) << file << " with " << what << ": " << error.what();
            }
        });
        EXPECT_LE(peak, 64 * bytes.size() + (16u << 20) + pixels) << file << " with " << what;
    };
    for (const std::string &file : written::files()) {
        const Bytes whole = read_asset(file);
        for (uint64_t flip = 0; flip < 200; ++flip) {
            Bytes bytes = whole;
            const uint64_t bit = base::hash(flip, bytes.size(), base::Purpose::pick) % (8 * bytes.size());
            bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1u << bit % 8));
            expect_small(bytes, file, "bit " + std::to_string(bit) + " flipped");
        }
        TakenApart apart(file);
        for (Json &accessor : apart.json["accessors"]) {
            const Json before = accessor;
            accessor["count"] = 100000000;
            expect_small(apart.bytes(), file, "a count of 100000000");
            accessor.erase("bufferView");
            expect_small(apart.bytes(), file, "100000000 zeros");
            accessor = before;
        }
    }
}

}  // namespace
}  // namespace claque::testing
