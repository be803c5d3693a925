// What a host can see of a world.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "tests/api/saved_bytes.h"
#include "tests/faults/watched_gl.h"
#include "tests/faults/world.h"

namespace faults
{
namespace
{

class Lines
{
public:
    void add(const std::string &what, uint64_t value) { text_ << what << ' ' << std::hex << value << '\n'; }
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

void see_counts(Lines &all, const std::string &name, const clq_asset_info &info)
{
    all.add(name + "'s parts", info.part_count), all.add(name + "'s clips", info.clip_count);
    all.add(name + "'s zones", info.zone_count), all.add(name + "'s images", info.image_count);
    all.add(name + "'s warnings", info.warning_count), all.add(name + "'s vertices", info.vertex_count);
    all.add(name + "'s triangles", info.triangle_count);
}

void see_asset(Lines &all, clq_context *context, const std::string &name, const clq_asset *asset, bool builds)
{
    if (!asset) return;
    clq_asset_info info = clq_asset_info_init();
    EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK);
    see_counts(all, name, info);
    for (uint32_t i = 0; i < info.warning_count; ++i)
        all.add(name + "'s warning", hash_of(std::string(clq_asset_get_warning(asset, i))));
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        EXPECT_EQ(clq_asset_get_clip(asset, i, &clip), CLQ_OK);
        all.add(name + "'s clip", hash_of(std::string(clip.name)) ^ clip.channel_count);
    }
    for (uint32_t i = 0; i < info.image_count; ++i) {
        clq_asset_image image = clq_asset_image_init();
        EXPECT_EQ(clq_asset_get_image(asset, i, &image), CLQ_OK);
        all.add(name + "'s image", hash_of(image.rgba, 4 * size_t(image.width_px) * image.height_px) ^ image.alpha);
    }
    clq_level_report level = clq_level_report_init();
    const bool has_levels = clq_asset_get_level_report(asset, 0, &level) == CLQ_OK;
    all.add(name + "'s levels", has_levels ? 1 + level.triangle_count : 0);
    if (!builds) return;
    clq_template *tmpl = nullptr;  // which has all of an asset that can be seen
    EXPECT_EQ(clq_asset_build(context, asset, 0, &tmpl), CLQ_OK) << name << ": " << clq_last_error();
    all.add(name + "'s template", bytes_of(tmpl));
    clq_template_destroy(tmpl);
}

void see_crowd(Lines &all, const std::string &name, const clq_crowd *crowd, const clq_view *view)
{
    all.add(name + "'s hash", clq_crowd_get_hash(crowd));
    all.add(name + "'s actors", clq_crowd_get_actor_count(crowd));
    const saved::Bytes bytes = saved::save(crowd);
    all.add(name + "'s saved bytes", hash_of(bytes.data(), bytes.size()));
    all.add(name + "'s list", clq_view_get_hash(view));
    clq_crowd_stats stats = clq_crowd_stats_init();
    EXPECT_EQ(clq_crowd_get_stats(crowd, &stats), CLQ_OK);
    all.add(name + "'s visible actors", stats.visible);
}

void see_scene(Lines &all, const clq_scene *scene)
{
    const double origin[3] = {0, 0, 0};
    clq_scene_hit hits[200];
    clq_actor found[200];
    uint32_t count = 0;
    EXPECT_EQ(clq_scene_find_within(scene, 1, origin, 1e9, nullptr, hits, 200, &count), CLQ_OK) << clq_last_error();
    all.add("individuals by place", hash_of(hits, std::min(count, 200u) * sizeof *hits) + count);
    EXPECT_EQ(clq_scene_find_keys(scene, -1e9, 1e9, nullptr, found, 200, &count), CLQ_OK) << clq_last_error();
    all.add("individuals in order", hash_of(found, std::min(count, 200u) * sizeof *found) + count);
    for (uint32_t level = 0; level < 2; ++level)
        for (uint32_t category = 0; category < 3; ++category) {
            clq_scene_filter filter = clq_scene_filter_init();
            filter.level = level, filter.any_of = uint64_t(1) << category;
            EXPECT_EQ(clq_scene_find(scene, &filter, found, 200, &count), CLQ_OK) << clq_last_error();
            all.add("individuals of a category", hash_of(found, std::min(count, 200u) * sizeof *found) + count);
        }
}

void see_files(Lines &all, const std::string &folder)
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    for (const std::string &name : names) all.add(name, hash_of(name));
}

}  // namespace

std::string World::see()
{
    Lines all;
    all.add("GL state", watched_gl::state());
    all.add("GL textures", watched_gl::textures());
    see_crowd(all, "crowd", objects.crowd, objects.view);
    see_crowd(all, "bare crowd", bare, bare_view);
    see_crowd(all, "crowd with key-poses", key_posed, key_view);
    see_crowd(all, "young crowd", young, young_view);
    see_scene(all, objects.scene);
    for (const clq_template *tmpl : test.templates) all.add("template", bytes_of(tmpl));
    for (clq_renderer *renderer : {objects.renderer, fresh})
        for (const clq_template *tmpl : {test.templates[0], test.templates[1], person_template}) {
            clq_prepared_info info = clq_prepared_info_init();
            all.add("prepared", uint64_t(clq_renderer_get_prepared(renderer, tmpl, &info)));
        }
    if (sees_assets) {
        see_asset(all, test.context, "person", person, builds_assets);
        see_asset(all, test.context, "painted", painted, builds_assets);
        see_asset(all, test.context, "shapes", shapes, false);
        see_asset(all, test.context, "walk", walk, false);
    }
    see_files(all, folder);
    watched_gl::picture();
    EXPECT_EQ(clq_renderer_draw(objects.renderer, objects.view, nullptr), CLQ_OK) << clq_last_error();
    all.add("picture", watched_gl::picture());
    all.add("GL state after drawing", watched_gl::state());
    return all.text();
}

uint32_t World::left_out() const
{
    uint32_t sum = 0;
    for (const clq_crowd *crowd : {objects.crowd, bare, key_posed, young}) {
        clq_crowd_stats stats = clq_crowd_stats_init();
        EXPECT_EQ(clq_crowd_get_stats(crowd, &stats), CLQ_OK) << clq_last_error();
        sum += stats.left_out;
    }
    return sum;
}

std::string World::see_future()
{
    Lines all;
    clq_crowd *crowds[4] = {objects.crowd, bare, key_posed, young};
    clq_view *views[4] = {objects.view, bare_view, key_view, young_view};
    const clq_shadow_def shadows = clq_shadow_def_init();
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(clq_crowd_update(crowds[k], 12.5, &views[k], 1), CLQ_OK) << clq_last_error();
        all.add("next list", clq_view_get_hash(views[k]));
        EXPECT_EQ(clq_renderer_draw(objects.renderer, views[k], nullptr), CLQ_OK) << clq_last_error();
        all.add("next picture", watched_gl::picture());
        EXPECT_EQ(clq_renderer_draw_shadows(without_shadows, views[k], &shadows, nullptr), CLQ_OK) << clq_last_error();
        all.add("next shadows", watched_gl::picture());
    }
    see_scene(all, objects.scene);
    EXPECT_EQ(clq_renderer_prepare(fresh, person_template), CLQ_OK) << clq_last_error();
    all.add("textures of another renderer", watched_gl::textures());
    return all.text();
}

}  // namespace faults
