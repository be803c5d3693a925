// Every file of the hostile collection, held against what the Khronos validator said about it.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "assets.h"
#include "heap_meter.h"
#include "tests/support/patterns.h"

namespace claque::testing
{
namespace
{

struct Row {
    std::string file;
    std::string errors;  // "-": no report exists
    std::set<std::string> codes;
};

std::vector<std::string> split(const std::string &text, char at)
{
    std::vector<std::string> out;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) out.push_back(part);
    return out;
}

std::vector<Row> rows()
{
    std::vector<Row> out;
    std::ifstream table(assets_folder() + "/hostile/EXPECTED.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        const std::vector<std::string> cells = split(line, '\t');
        Row row{"hostile/" + cells.at(0), cells.at(1), {}};
        for (const std::string &code : split(cells.at(3), ',')) row.codes.insert(code);
        out.push_back(row);
    }
    return out;
}

struct Reason {
    int status;
    const char *words;  // of the refusal
};

// Errors in what is read, wherever they stand in the file, and what is said of them. What is not here is about things
// that are passed over (cameras, bounds, targets of views, names of attributes) or harmless (empty lists, a skeleton
// without common root).
const std::map<std::string, Reason> reasons = {
    {"ACCESSOR_INDEX_OOB", {CLQ_FORMAT, "the primitive has"}},
    {"ACCESSOR_MATRIX_ALIGNMENT", {CLQ_FORMAT, "not a multiple of 4"}},
    {"ACCESSOR_NORMALIZED_INVALID", {CLQ_FORMAT, "cannot be normalized"}},
    {"ACCESSOR_OFFSET_ALIGNMENT", {CLQ_FORMAT, "not a multiple of 4"}},
    {"ACCESSOR_TOO_LONG", {CLQ_FORMAT, "ends at byte"}},
    {"ACCESSOR_TOTAL_OFFSET_ALIGNMENT", {CLQ_FORMAT, "not a multiple of 4"}},
    {"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", {CLQ_FORMAT, "instead of 1"}},
    {"ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", {CLQ_FORMAT, "without morph targets"}},
    {"ANIMATION_DUPLICATE_TARGETS", {CLQ_FORMAT, "another channel of the same clip"}},
    {"ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", {CLQ_FORMAT, "key times are not floats"}},
    {"ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", {CLQ_FORMAT, "2 keys at least"}},
    {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", {CLQ_FORMAT, "elements instead of"}},
    {"BUFFER_BYTE_LENGTH_MISMATCH", {CLQ_FORMAT, "says 17 bytes, the GLB's binary chunk has 16"}},
    {"BUFFER_MISSING_GLB_DATA", {CLQ_FORMAT, "and there is none"}},
    {"BUFFER_VIEW_TOO_LONG", {CLQ_FORMAT, "ends at byte 32 of buffer 0, which has 16"}},
    {"GLB_CHUNK_TOO_BIG", {CLQ_FORMAT, "GLB chunk 0 is cut off"}},
    {"GLB_DUPLICATE_CHUNK", {CLQ_FORMAT, "is a second JSON"}},
    {"GLB_EMPTY_CHUNK", {CLQ_FORMAT, "has no JSON in it"}},
    {"GLB_INVALID_VERSION", {CLQ_UNSUPPORTED, "GLB version 0"}},
    {"GLB_LENGTH_MISMATCH", {CLQ_FORMAT, "the GLB header says"}},
    {"GLB_LENGTH_TOO_SMALL", {CLQ_FORMAT, "has no JSON in it"}},
    {"GLB_UNEXPECTED_END_OF_CHUNK_HEADER", {CLQ_FORMAT, "GLB chunk 0 is cut off"}},
    {"GLB_UNEXPECTED_END_OF_HEADER", {CLQ_FORMAT, "neither glTF nor BVH"}},
    {"GLB_UNEXPECTED_FIRST_CHUNK", {CLQ_FORMAT, "GLB chunk 0 is not the JSON"}},
    {"INVALID_IBM_ACCESSOR_COUNT", {CLQ_FORMAT, "2 matrices for 3 joints"}},
    {"INVALID_JSON", {CLQ_FORMAT, "the JSON is broken"}},
    {"MESH_INVALID_WEIGHTS_COUNT", {CLQ_FORMAT, "2 numbers for 1 morph targets"}},
    {"MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", {CLQ_FORMAT, "with a byteStride"}},
    {"NODE_LOOP", {CLQ_FORMAT, "is its own ancestor"}},
    {"NODE_MATRIX_NON_TRS", {CLQ_FORMAT, "instead of 0 0 0 1"}},
    {"NODE_PARENT_OVERRIDE", {CLQ_FORMAT, "is a child of nodes[0] and of nodes[1]"}},
    {"NODE_WEIGHTS_INVALID", {CLQ_FORMAT, "2 numbers, its mesh has 1 morph targets"}},
    {"PATTERN_MISMATCH", {CLQ_FORMAT, "instead of two numbers and a dot"}},
    {"SCENE_NON_ROOT_NODE", {CLQ_FORMAT, "which is no root node"}},
    {"SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", {CLQ_UNSUPPORTED, "needs buffer 0"}},  // whose data it leaves to others
    {"UNKNOWN_ASSET_MAJOR_VERSION", {CLQ_UNSUPPORTED, "glTF version 1.0"}},
    {"UNRESOLVED_REFERENCE", {CLQ_FORMAT, "which does not exist: there are"}},
    {"UNUSED_EXTENSION_REQUIRED", {CLQ_UNSUPPORTED, "the file requires the extension"}},
    {"UNSATISFIED_DEPENDENCY", {CLQ_FORMAT, "has a skin but no mesh"}},
    {"VALUE_MULTIPLE_OF", {CLQ_FORMAT, "not a multiple of 4"}},
    {"INVALID_URI", {CLQ_FORMAT, "has an empty parameter"}},
    {"TYPE_MISMATCH", {CLQ_FORMAT, "instead of an object"}},
    {"UNDEFINED_PROPERTY", {CLQ_FORMAT, "is missing"}}};

// Files whose errors sound as if they were in what is read, and are not: what the faulty thing is.
const std::set<std::string> passed_over = {
    "hostile/validator/material/unresolved_emissive.gltf",    // an emissive texture
    "hostile/validator/material/unresolved_normal.gltf",      // a normal map
    "hostile/validator/image/invalid_data_uri.gltf",          // an image that no material uses
    "hostile/validator/image/invalid_uri_scheme.gltf",        // likewise
    "hostile/validator/camera/empty_objects.gltf",            // cameras
    "hostile/validator/root/extensions_non_objects.gltf",     // extensions that no reader knows
    "hostile/validator/mesh/invalid_indexed_attribute.gltf",  // attributes that no reader knows
    "hostile/validator/ext/KHR_animation_pointer/animation/channel/target/missing_pointer.gltf"};  // not animated

// What may be said of a file that must be refused.
std::vector<Reason> reasons_of(const Row &row)
{
    std::vector<Reason> out;
    if (row.errors == "-" || row.errors == "0" || passed_over.count(row.file)) return out;
    for (const std::string &code : row.codes)
        if (const auto found = reasons.find(code); found != reasons.end()) out.push_back(found->second);
    if (row.file == "hostile/validator/json/empty_file.gltf") out.push_back({CLQ_FORMAT, "the file is empty"});
    return out;
}

// An element of the file, something in quotes, or a part that each file has once.
const std::string names_a_place =
    "[^]*([A-Za-z]+\\[[0-9]+\\]|'[^']+'|GLB|JSON|asset|scene|the extension [A-Z]|glTF)[^]*";

TEST(Hostile, EveryFileLoadsOrIsRefusedForTheReasonOfItsFaults)
{
    CLAQUE_NEEDS_ASSETS();
    size_t must_load = 0, must_refuse = 0, others = 0;
    for (const Row &row : rows()) {
        const Outcome outcome = outcome_of(read_asset(row.file), options_for(row.file));
        const std::string said = row.file + ": " + std::to_string(outcome.status) + ", " + outcome.text;
        if (row.errors == "0") {
            ++must_load;
            EXPECT_TRUE(outcome.status == 0 || outcome.status == CLQ_UNSUPPORTED) << said;
        }
        const std::vector<Reason> faults = reasons_of(row);
        if (!faults.empty()) {
            ++must_refuse;
            EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [&](const Reason &reason) {
                return outcome.status == reason.status && outcome.text.find(reason.words) != std::string::npos;
            })) << said;
        }
        EXPECT_EQ(outcome.status == 0, outcome.text.empty()) << said;
        if (outcome.status == 0) continue;
        others += faults.empty();
        EXPECT_TRUE(outcome.status == CLQ_FORMAT || outcome.status == CLQ_UNSUPPORTED ||
                    (outcome.status == CLQ_IO && outcome.text.find("cannot be opened") != std::string::npos))
            << said;
        EXPECT_TRUE(is_sentence(outcome.text)) << said;
        EXPECT_TRUE(outcome.text == "the file is empty" || patterns::describes(names_a_place, outcome.text)) << said;
    }
    EXPECT_EQ(must_load, 41u);
    EXPECT_EQ(must_refuse, 57u);
    EXPECT_EQ(others, 53u);
}

TEST(Hostile, NoFileTakesMoreThanASmallMultipleOfItsSize)
{
    CLAQUE_NEEDS_ASSETS();
    for (const Row &row : rows()) {
        const Bytes bytes = read_asset(row.file);
        const asset::LoadOptions options = options_for(row.file);
        uint64_t pixels = 0;
        const uint64_t peak = peak_heap_bytes([&] {
            try {
                for (const model::Image &image : load(bytes, options).images) pixels += image.rgba.size();
            } catch (const base::Error &) {
            }
        });
        EXPECT_LE(peak, 64 * bytes.size() + (16u << 20) + pixels) << row.file;
    }
}

}  // namespace
}  // namespace claque::testing
