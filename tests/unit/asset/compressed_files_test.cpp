// Real compressed characters: against their uncompressed originals, and against what their files say of their ranges.
#include <cmath>

#include "decoder_test.h"
#include "lib/asset/glb.h"
#include "lib/asset/gltf_file.h"

namespace claque::testing
{
namespace
{

// Corners of all triangles, in the parts' own space.
std::vector<glm::vec3> corners_of(const model::Model &model)
{
    std::vector<glm::vec3> out;
    for (const model::Part &part : model.parts)
        for (const uint32_t i : part.indices) out.push_back(part.positions[i]);
    return out;
}

float size_of(const std::vector<glm::vec3> &points)
{
    glm::vec3 low = points[0], high = points[0];
    for (const glm::vec3 &p : points) low = glm::min(low, p), high = glm::max(high, p);
    return glm::length(high - low);
}

float farthest(const std::vector<glm::vec3> &from, const std::vector<glm::vec3> &to)
{
    float worst = 0;
    for (size_t i = 0; i < from.size(); i += 7) {
        float best = INFINITY;
        for (const glm::vec3 &p : to) best = std::fmin(best, glm::dot(p - from[i], p - from[i]));
        worst = std::fmax(worst, best);
    }
    return std::sqrt(worst);
}

// Quantised to 2^bits steps along the longest side of the box.
void expect_twins(const std::string &packed_file, const std::string &plain_file, float steps)
{
    const model::Model packed = load(read_asset(packed_file), options_for(packed_file));
    const model::Model plain = load(read_asset(plain_file), options_for(plain_file));
    const std::vector<glm::vec3> a = corners_of(packed), b = corners_of(plain);
    ASSERT_EQ(a.size(), b.size()) << packed_file;
    const float step = size_of(b) / steps;
    EXPECT_LE(farthest(a, b), step) << packed_file;
    EXPECT_LE(farthest(b, a), step) << packed_file;
    ASSERT_EQ(packed.rig.clips.size(), plain.rig.clips.size());
    EXPECT_EQ(packed.parts.size(), plain.parts.size());
    for (size_t i = 0; i < packed.parts.size() && i < plain.parts.size(); ++i) {
        EXPECT_EQ(packed.parts[i].influence_count, plain.parts[i].influence_count);
        EXPECT_EQ(packed.parts[i].indices.size(), plain.parts[i].indices.size());
    }
}

TEST(CompressedFiles, DracoCharactersAreTheirOriginalsWithinAStepOfQuantisation)
{
    CLAQUE_NEEDS_ASSETS();
    CLAQUE_NEEDS_DECODER(asset::Decoder::draco, "libdraco");
    expect_twins("compressed/CesiumMan-Draco/CesiumMan.gltf", "humanoids/khronos/CesiumMan.glb", 1024);
    expect_twins("compressed/Casual_Male-draco.gltf", "humanoids/quaternius-ultimate/Casual_Male.gltf", 4096);
}

// The reader of a file, and its JSON beside it.
struct Opened {
    Bytes bytes;
    asset::LoadOptions options;
    asset::Budget budget{1u << 30};
    asset::Container container;
    std::unique_ptr<asset::JsonDocument> document;
    std::unique_ptr<asset::File> file;

    explicit Opened(const std::string &name) : bytes(read_asset(name)), options(options_for(name))
    {
        budget.add_input(bytes.size());
        container = asset::open_container(bytes.data(), bytes.size());
        document = std::make_unique<asset::JsonDocument>(container.json, container.json_size, 1u << 30);
        file = std::make_unique<asset::File>(document->root(), container, options, budget);
    }
};

// The stored integers or floats of accessors lie in [min, max] and reach both, as the file says.
size_t expect_ranges(Opened &opened)
{
    const asset::JsonView list = opened.document->root()["accessors"];
    size_t compared = 0;
    for (uint32_t i = 0; i < list.count(); ++i) {
        const asset::Accessor &a = opened.file->accessors.at(i);
        if (!list.at(i)["min"].exists() || !opened.file->accessors.has_data(i)) continue;
        const std::vector<float> values = opened.file->accessors.floats(i, a.width, "a range");
        std::vector<float> low(a.width), high(a.width);
        list.at(i)["min"].numbers(low.data(), a.width);
        list.at(i)["max"].numbers(high.data(), a.width);
        // Of normalised integers the file gives what is stored.
        const float unit = !a.normalized                          ? 1.0f
                           : a.component == asset::Component::i16 ? 32767.0f
                           : a.component == asset::Component::u16 ? 65535.0f
                           : a.component == asset::Component::i8  ? 127.0f
                                                                  : 255.0f;
        for (uint32_t k = 0; k < a.width; ++k) {
            float least = INFINITY, most = -INFINITY;
            for (size_t v = k; v < values.size(); v += a.width)
                least = std::fmin(least, values[v]), most = std::fmax(most, values[v]);
            EXPECT_NEAR(least * unit, low[k], 1e-4f * (1 + std::fabs(low[k]))) << i << " " << k;
            EXPECT_NEAR(most * unit, high[k], 1e-4f * (1 + std::fabs(high[k]))) << i << " " << k;
        }
        ++compared;
    }
    return compared;
}

TEST(CompressedFiles, MeshoptAccessorsReachExactlyTheRangesThatTheirFileStates)
{
    CLAQUE_NEEDS_ASSETS();
    CLAQUE_NEEDS_DECODER(asset::Decoder::meshopt, "libmeshoptimizer");
    Opened opened("compressed/valid-Asian_F_1_Busi.glb");
    EXPECT_GT(expect_ranges(opened), 50u);
}

TEST(CompressedFiles, WebpPicturesOfRealFilesAreRead)
{
    CLAQUE_NEEDS_ASSETS();
    CLAQUE_NEEDS_DECODER(asset::Decoder::meshopt, "libmeshoptimizer");
    CLAQUE_NEEDS_DECODER(asset::Decoder::webp, "libwebp");
    const std::string file = "compressed/valid-Asian_F_1_Busi.glb";
    const model::Model model = load(read_asset(file), options_for(file));
    ASSERT_GE(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].width, 2048u);
    EXPECT_EQ(model.images[0].height, 2048u);
    double sum = 0;
    for (const uint8_t value : model.images[0].rgba) sum += value;
    const double mean = sum / static_cast<double>(model.images[0].rgba.size());
    EXPECT_GT(mean, 40);
    EXPECT_LT(mean, 230);
}

TEST(CompressedFiles, DamagedGiveASentence)
{
    CLAQUE_NEEDS_ASSETS();
    const struct {
        const char *file;
        uint64_t runs;
    } files[] = {{"compressed/Casual_Male-draco.gltf", 40}, {"compressed/valid-Asian_F_1_Busi.glb", 12}};
    for (const auto &row : files) {
        const Bytes bytes = read_asset(row.file);
        const asset::Container container = asset::open_container(bytes.data(), bytes.size());
        if (!container.has_binary) continue;
        const size_t first = static_cast<size_t>(container.binary - bytes.data());
        expect_sentences(bytes, first, container.binary_size, row.runs, 7, options_for(row.file));
    }
}

}  // namespace
}  // namespace claque::testing
