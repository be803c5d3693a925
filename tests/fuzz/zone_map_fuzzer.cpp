// Zone maps and proposals, for a picture of any colours.
#include <claque/zones.h>

#include "tests/fuzz/shown.h"
#include "tests/support/written_image.h"

namespace
{

using namespace fuzzing;

// A square with a picture of these many pixels, as a file.
Bytes square(Feed &feed)
{
    using namespace claque::testing;
    const uint32_t width = 1 + feed.below(16), height = 1 + feed.below(16);
    Maker maker;
    const int positions = maker.floats("VEC3", 4, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int uvs = maker.floats("VEC2", 4, {0, 0, 1, 0, 1, 1, 0, 0.5f});
    const int indices = maker.accessor(u16, "SCALAR", 6, std::vector<uint16_t>{0, 1, 2, 0, 2, 3});
    const claque::testing::Bytes png = png_of(width, height, [&](uint32_t, uint32_t) {
        return Colour{feed.take<uint8_t>(), feed.take<uint8_t>(), feed.take<uint8_t>(), 255};
    });
    maker.add("images", {{"bufferView", maker.view(png)}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    Json base = {{"baseColorTexture", {{"index", 0}}}};
    if (feed.below(2)) base["baseColorFactor"] = {0.5, 0.25, 1, 1};
    maker.add("materials", {{"pbrMetallicRoughness", base}});
    maker.add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                                                      {"indices", indices},
                                                      {"material", 0}}})}});
    maker.add("nodes", {{"mesh", 0}});
    maker.json["scenes"] = Json::array({{{"nodes", {0}}}});
    return maker.glb();
}

void propose(const clq_asset *asset, uint32_t max_zones)
{
    clq_asset_image image = clq_asset_image_init();
    ASSERT_EQ(clq_asset_get_image(asset, 0, &image), CLQ_OK) << clq_last_error();
    std::vector<uint16_t> texels(size_t(image.width_px) * image.height_px, 777);
    std::vector<uint8_t> rgb(3 * size_t(max_zones));
    clq_zone_proposal proposal = clq_zone_proposal_init();
    proposal.max_zones = max_zones, proposal.rgb = rgb.data();
    proposal.texels = texels.data(), proposal.capacity_texels = texels.size();
    if (!done(clq_asset_propose_zones(asset, 0, &proposal), {CLQ_ARGUMENT})) return;
    EXPECT_LE(proposal.zone_count, max_zones);
    for (const uint16_t texel : texels) EXPECT_TRUE(texel < proposal.zone_count || texel == CLQ_NO_ZONE) << texel;
}

// Returns whether the map was taken.
bool set_map(clq_context *context, clq_asset *asset, Feed &feed)
{
    const char *names[] = {"skin", "cloth", "hair", "cloth", "", nullptr, "leather belt", "\xff\xfe"};
    clq_zone_map_def def = clq_zone_map_def_init();
    def.image = feed.below(40) == 39 ? feed.take<uint8_t>() : 0;
    def.width_px = feed.below(17), def.height_px = feed.below(17);
    def.zone_count = feed.below(12) == 11 ? feed.take<uint16_t>() % 300 : 1 + feed.below(6);
    std::vector<clq_zone_map_zone> zones(def.zone_count);
    std::vector<clq_hsb_range> ranges(def.zone_count, clq_hsb_range_init());
    for (size_t i = 0; i < zones.size(); ++i) {
        const uint8_t kind = feed.take<uint8_t>();
        zones[i] = {names[kind % 8], (kind & 8) != 0, (kind & 16) != 0 ? &ranges[i] : nullptr};
        if (kind >= 0xf0) ranges[i].hue_min_deg = feed.take<float>(), ranges[i].saturation_max = feed.take<float>();
    }
    std::vector<uint16_t> texels(size_t(def.width_px) * def.height_px);
    for (uint16_t &texel : texels) {
        const uint8_t value = feed.take<uint8_t>();
        texel = value == 255 ? uint16_t(CLQ_NO_ZONE) : value >= 250 ? value : uint16_t(value % (def.zone_count + 1));
    }
    def.texels = texels.data(), def.zones = zones.data();
    return done(clq_asset_set_zone_map(context, asset, &def), {CLQ_ARGUMENT, CLQ_LIMIT});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    Feed feed(bytes, size);
    const Bytes file = square(feed);
    clq_context *context = new_context();
    clq_asset *asset = nullptr;
    EXPECT_EQ(clq_asset_load(context, file.data(), file.size(), nullptr, &asset), CLQ_OK) << clq_last_error();
    propose(asset, feed.below(60));
    for (int map = 0; map < 2; ++map) {
        set_map(context, asset, feed);
        clq_template *tmpl = nullptr;
        if (!done(clq_asset_build(context, asset, 0, &tmpl), {})) break;
        show(context, tmpl);
        clq_template_destroy(tmpl);
    }
    clq_asset_destroy(asset);
    end(context);
    return 0;
}
