// Every file of the hostile collection, held against what the Khronos validator said about it.
#include <set>
#include <sstream>

#include "assets.h"
#include "heap_meter.h"

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

// Errors in what is read, wherever they stand in the file. What is not here is about things that are passed over
// (cameras, bounds, targets of views, names of attributes) or harmless (empty lists, a skeleton without common root).
const std::set<std::string> read_codes = {"ACCESSOR_INDEX_OOB",
                                          "ACCESSOR_MATRIX_ALIGNMENT",
                                          "ACCESSOR_NORMALIZED_INVALID",
                                          "ACCESSOR_OFFSET_ALIGNMENT",
                                          "ACCESSOR_TOO_LONG",
                                          "ACCESSOR_TOTAL_OFFSET_ALIGNMENT",
                                          "ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION",
                                          "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS",
                                          "ANIMATION_DUPLICATE_TARGETS",
                                          "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT",
                                          "ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS",
                                          "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT",
                                          "BUFFER_BYTE_LENGTH_MISMATCH",
                                          "BUFFER_MISSING_GLB_DATA",
                                          "BUFFER_VIEW_TOO_LONG",
                                          "GLB_CHUNK_TOO_BIG",
                                          "GLB_DUPLICATE_CHUNK",
                                          "GLB_EMPTY_CHUNK",
                                          "GLB_INVALID_VERSION",
                                          "GLB_LENGTH_MISMATCH",
                                          "GLB_LENGTH_TOO_SMALL",
                                          "GLB_UNEXPECTED_END_OF_CHUNK_HEADER",
                                          "GLB_UNEXPECTED_END_OF_HEADER",
                                          "GLB_UNEXPECTED_FIRST_CHUNK",
                                          "INVALID_IBM_ACCESSOR_COUNT",
                                          "INVALID_JSON",
                                          "MESH_INVALID_WEIGHTS_COUNT",
                                          "MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE",
                                          "NODE_LOOP",
                                          "NODE_MATRIX_NON_TRS",
                                          "NODE_PARENT_OVERRIDE",
                                          "NODE_WEIGHTS_INVALID",
                                          "PATTERN_MISMATCH",
                                          "SCENE_NON_ROOT_NODE",
                                          "SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE",
                                          "UNKNOWN_ASSET_MAJOR_VERSION",
                                          "UNRESOLVED_REFERENCE",
                                          "UNUSED_EXTENSION_REQUIRED",
                                          "UNSATISFIED_DEPENDENCY",
                                          "VALUE_MULTIPLE_OF",
                                          "INVALID_URI",
                                          "TYPE_MISMATCH",
                                          "UNDEFINED_PROPERTY"};

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

bool must_be_refused(const Row &row)
{
    if (row.errors == "-" || row.errors == "0" || passed_over.count(row.file)) return false;
    for (const std::string &code : row.codes)
        if (read_codes.count(code)) return true;
    return false;
}

TEST(Hostile, EveryFileLoadsOrIsRefusedAsItsFaultsDeserve)
{
    CLAQUE_NEEDS_ASSETS();
    size_t must_load = 0, must_refuse = 0;
    for (const Row &row : rows()) {
        const Outcome outcome = outcome_of(read_asset(row.file), options_for(row.file));
        if (row.errors == "0") {
            ++must_load;
            EXPECT_TRUE(outcome.status == 0 || outcome.status == CLQ_UNSUPPORTED) << row.file << ": " << outcome.text;
        }
        if (must_be_refused(row)) {
            ++must_refuse;
            EXPECT_NE(outcome.status, 0) << row.file << " loaded";
        }
        EXPECT_NE(outcome.status, CLQ_ARGUMENT) << row.file << " blames the caller: " << outcome.text;
        EXPECT_EQ(outcome.status == 0, outcome.text.empty()) << row.file;
    }
    EXPECT_EQ(must_load, 41u);
    EXPECT_EQ(must_refuse, 57u);
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
