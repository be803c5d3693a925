// glTF and GLB files: loads, builds, makes levels, proposes zones, prepares and draws what loads.
#include <claque/assets.h>
#include <claque/prepare.h>
#include <claque/zones.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "tests/fuzz/shown.h"

namespace
{

using namespace fuzzing;

constexpr uint32_t max_texels = 64 * 64, max_triangles = 600;

clq_asset_options options()
{
    clq_asset_options out = clq_asset_options_init();
    out.memory_limit_bytes = 128u << 20;
    return out;
}

// Facts and positions, within the arrays that the asset says are enough.
clq_asset_info ask(const clq_asset *asset)
{
    clq_asset_info info = clq_asset_info_init();
    EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK) << clq_last_error();
    for (uint32_t i = 0; i < info.part_count; ++i) {
        clq_asset_part part = clq_asset_part_init();
        EXPECT_EQ(clq_asset_get_part(asset, i, &part), CLQ_OK) << clq_last_error();
    }
    for (uint32_t i = 0; i < info.node_count; ++i) {
        clq_asset_node node = clq_asset_node_init();
        EXPECT_EQ(clq_asset_get_node(asset, i, &node), CLQ_OK) << clq_last_error();
    }
    std::vector<float> positions(3 * size_t(info.vertex_count) + 1);
    for (uint32_t i = 0; i < info.clip_count && i < 4; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        EXPECT_EQ(clq_asset_get_clip(asset, i, &clip), CLQ_OK) << clq_last_error();
        for (const float time_s : {clip.start_s, clip.start_s + 0.4f * clip.duration_s, 1e9f})
            EXPECT_EQ(clq_asset_get_positions(asset, i, time_s, positions.data(), positions.size()), CLQ_OK)
                << clq_last_error();
    }
    EXPECT_EQ(clq_asset_get_positions(asset, CLQ_NONE, 0, positions.data(), positions.size()), CLQ_OK);
    return info;
}

void build(clq_context *context, const clq_asset *asset)
{
    clq_template *tmpl = nullptr;
    if (!done(clq_asset_build(context, asset, 64, &tmpl), {CLQ_ARGUMENT, CLQ_LIMIT})) return;
    show(context, tmpl);
    clq_template_destroy(tmpl);
}

void give_zones(clq_context *context, clq_asset *asset, const clq_asset_info &info, uint32_t max_zones)
{
    for (uint32_t i = 0; i < info.image_count && i < 2; ++i) {
        clq_asset_image image = clq_asset_image_init();
        EXPECT_EQ(clq_asset_get_image(asset, i, &image), CLQ_OK) << clq_last_error();
        const size_t texels = size_t(image.width_px) * image.height_px;
        if (texels > max_texels) continue;
        std::vector<uint16_t> map(texels);
        std::vector<uint8_t> rgb(3 * max_zones);
        clq_zone_proposal proposal = clq_zone_proposal_init();
        proposal.max_zones = max_zones, proposal.rgb = rgb.data();
        proposal.texels = map.data(), proposal.capacity_texels = texels;
        if (!done(clq_asset_propose_zones(asset, i, &proposal), {CLQ_ARGUMENT, CLQ_LIMIT})) continue;
        EXPECT_LE(proposal.zone_count, max_zones);
        const std::vector<clq_zone_map_zone> zones(proposal.zone_count, {"cloth", true, nullptr});
        clq_zone_map_def def = clq_zone_map_def_init();
        def.image = i, def.width_px = image.width_px, def.height_px = image.height_px, def.texels = map.data();
        def.zone_count = proposal.zone_count, def.zones = zones.data();
        done(clq_asset_set_zone_map(context, asset, &def), {CLQ_ARGUMENT, CLQ_LIMIT});
    }
}

bool make_levels(clq_context *context, clq_asset *asset, const clq_asset_info &info)
{
    if (info.triangle_count > max_triangles) return false;
    const uint32_t targets[] = {info.triangle_count / 2 + 4, info.triangle_count / 4 + 4, 6};
    clq_levels_def def = clq_levels_def_init();
    def.targets = targets;
    while (def.target_count < 3 && (def.target_count == 0 || targets[def.target_count] < targets[def.target_count - 1]))
        ++def.target_count;
    uint32_t count = 0;
    if (!done(clq_asset_make_levels(context, asset, &def, &count), {CLQ_ARGUMENT, CLQ_LIMIT})) return false;
    for (uint32_t i = 0; i < count; ++i) {
        clq_level_report report = clq_level_report_init();
        EXPECT_EQ(clq_asset_get_level_report(asset, i, &report), CLQ_OK) << clq_last_error();
    }
    return true;
}

// From a file, and to a folder from which it is then loaded.
void prepare(clq_context *context, const uint8_t *bytes, size_t size)
{
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("claque-fuzz-gltf-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::string path = folder / "character", made = folder / "made";
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char *>(bytes), static_cast<long>(size));
    const clq_asset_options allowed = options();
    clq_prepare_def def = clq_prepare_def_init();
    def.path = path.c_str(), def.options = &allowed, def.max_texture_px = 32, def.folder = made.c_str();
    Bytes first;
    for (int run = 0; run < 2; ++run) {
        clq_prepare_report report = clq_prepare_report_init();
        clq_template *tmpl = nullptr;
        if (!done(clq_template_prepare(context, &def, &tmpl, &report),
                  {CLQ_ARGUMENT, CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT, CLQ_IO}))
            break;
        EXPECT_EQ(report.from_disk, run == 1) << report.text;
        if (run == 0) first = bytes_of(tmpl);
        else EXPECT_EQ(bytes_of(tmpl), first);
        clq_template_destroy(tmpl);
    }
    std::filesystem::remove_all(folder);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0) return 0;
    clq_context *context = new_context();
    const clq_asset_options allowed = options();
    clq_asset *asset = nullptr;
    const uint64_t choice = number_of(bytes, size);
    if (done(clq_asset_load(context, bytes, size, &allowed, &asset),
             {CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT, CLQ_IO})) {
        const clq_asset_info info = ask(asset);
        build(context, asset);
        if (choice % 2 == 0) give_zones(context, asset, info, 1 + choice / 64 % 8);
        if (choice % 3 == 0 && make_levels(context, asset, info)) build(context, asset);
        if (choice % 16 == 0) prepare(context, bytes, size);
        clq_asset_destroy(asset);
    }
    end(context);
    return 0;
}
