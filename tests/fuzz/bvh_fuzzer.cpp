// BVH files: loads them, and retargets what loads to its own skeleton.
#include <claque/assets.h>

#include "tests/fuzz/fuzzer.h"

namespace
{

using namespace fuzzing;

clq_asset *loaded(clq_context *context, const uint8_t *bytes, size_t size)
{
    clq_asset_options options = clq_asset_options_init();
    options.memory_limit_bytes = 64u << 20;
    options.bvh_metres_per_unit = 0.056444;
    clq_asset *asset = nullptr;
    done(clq_asset_load(context, bytes, size, &options, &asset), {CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT, CLQ_IO});
    return asset;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const std::string hierarchy = "HIERARCHY\n";  // so that no input is another format
    Bytes file(hierarchy.begin(), hierarchy.end());
    const bool whole = size >= 4 && std::memcmp(bytes, "HIER", 4) == 0;
    if (whole) file.clear();
    file.insert(file.end(), bytes, bytes + size);
    clq_context *context = new_context();
    if (clq_asset *asset = loaded(context, file.data(), file.size())) {
        clq_asset_info info = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK) << clq_last_error();
        clq_clip_info clip = clq_clip_info_init();
        const bool moves = info.clip_count > 0 && clq_asset_get_clip(asset, 0, &clip) == CLQ_OK;
        for (const clq_retarget_mode mode : {CLQ_RETARGET_CHANNELS, CLQ_RETARGET_MOTION}) {
            clq_asset *target = loaded(context, file.data(), file.size());
            clq_clips_def def = clq_clips_def_init();
            def.mode = mode, def.rate_hz = 5;
            if (moves && clip.duration_s > 100) def.end_s = 10;
            clq_clips_report report = clq_clips_report_init();
            done(clq_asset_add_clips(context, target, asset, &def, &report), {CLQ_ARGUMENT, CLQ_LIMIT});
            clq_asset_destroy(target);
        }
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_asset_build(context, asset, 0, &tmpl), CLQ_ARGUMENT) << "there is nothing to show";
        clq_asset_destroy(asset);
    }
    end(context);
    return 0;
}
