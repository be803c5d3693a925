#include "tests/convert/old_files.h"

#include <cmath>

#include <assimp/config.h>
#include <gtest/gtest.h>

#include "samples/convert/import.h"

namespace convert_test
{
namespace
{

double size_of(const std::vector<Point> &points)
{
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (const Point &p : points) low = std::fmin(low, p[k]), high = std::fmax(high, p[k]);
        sum += (high - low) * (high - low);
    }
    return std::sqrt(sum);
}

double worst_difference(const std::vector<Point> &expected, const std::vector<float> &found)
{
    double worst = 0;
    for (size_t i = 0; i < expected.size(); ++i)
        for (size_t k = 0; k < 3; ++k) {
            const double difference = std::fabs(expected[i][k] - double(found[3 * i + k]));
            worst = std::isfinite(difference) ? std::fmax(worst, difference) : INFINITY;
        }
    return worst;
}

}  // namespace

convert::Options as_it_is()
{
    convert::Options options;
    options.up = 'y';
    options.unit_m = 1;
    return options;
}

scenes::Own<clq_context> new_context()
{
    clq_context *made = nullptr;
    scenes::check(clq_context_create(nullptr, &made));
    return scenes::Own<clq_context>(made);
}

scenes::Own<clq_asset> read_glb(clq_context *context, const std::string &glb)
{
    clq_asset *made = nullptr;
    scenes::check(clq_asset_load(context, glb.data(), glb.size(), nullptr, &made));
    return scenes::Own<clq_asset>(made);
}

Both::Both(const std::string &path) : context(new_context())
{
    asset = read_glb(context.get(), convert::convert_file(path, as_it_is(), {}).glb);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const aiScene *scene = importer.ReadFile(path, convert::import_steps());
    if (!scene) throw scenes::Failure(path + ": " + importer.GetErrorString());
    reference = std::make_unique<Reference>(*scene);
}

clq_asset_info Both::info() const
{
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset.get(), &info));
    return info;
}

size_t expect_same_poses(Both &both, const std::string &name)
{
    const clq_asset_info info = both.info();
    const std::vector<Point> rest = both.reference->pose(-1, 0);
    const double size = rest.empty() ? 1 : size_of(rest);
    EXPECT_EQ(rest.size(), info.vertex_count) << name;
    EXPECT_EQ(both.reference->animations().size(), info.clip_count) << name;
    if (testing::Test::HasFailure()) return 0;
    std::vector<float> found(3 * size_t(info.vertex_count) + 1);
    size_t poses = 0;
    const auto compare = [&](uint32_t clip, float time_s, int animation, double ticks) {
        scenes::check(clq_asset_get_positions(both.asset.get(), clip, time_s, found.data(), found.size()));
        EXPECT_LE(worst_difference(both.reference->pose(animation, ticks), found), 1e-4 * size)
            << name << ", clip " << int(clip) << " at " << time_s << " s";
        ++poses;
    };
    compare(CLQ_NONE, 0, -1, 0);
    for (uint32_t c = 0; c < info.clip_count; ++c) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_asset_get_clip(both.asset.get(), c, &clip));
        const int animation = both.reference->animations()[c];
        const double rate = both.reference->rate_of(animation), first = both.reference->first_of(animation);
        for (const float share : {0.0f, 0.21f, 0.5f, 0.837f, 1.0f}) {
            const float time_s = clip.start_s + share * clip.duration_s;
            compare(c, time_s, animation, first + double(time_s) * rate);
        }
    }
    return poses;
}

}  // namespace convert_test
