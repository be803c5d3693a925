#include "tests/faults/world.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

#include "tests/api/calls.h"
#include "tests/api/failing_memory.h"
#include "tests/api/saved_bytes.h"
#include "tests/faults/watched_gl.h"
#include "tests/support/written_characters.h"

namespace faults
{
namespace
{

const clq_context_def *failing()
{
    static const clq_context_def def = [] {
        clq_context_def made = clq_context_def_init();
        made.allocator = failing_memory::allocator;
        return made;
    }();
    return &def;
}

int append(void *user, const void *bytes, size_t count)
{
    auto *all = static_cast<std::vector<unsigned char> *>(user);
    const auto *first = static_cast<const unsigned char *>(bytes);
    all->insert(all->end(), first, first + count);
    return 0;
}

clq_asset *load(clq_context *context, const std::string &name)
{
    clq_asset *asset = nullptr;
    EXPECT_EQ(clq_asset_load_file(context, written::path_of(name, "").c_str(), nullptr, &asset), CLQ_OK)
        << clq_last_error();
    return asset;
}

const char *const colours = R"([[classes]]
name = "one"
template = "figure"
[classes.zones]
cloth = { palette = [ { colour = "#6a5acd" }, { hue = [340, 20], saturation = [0, 1], brightness = [0.2, 1] } ] }
skin = { linked_to = "cloth", variation = 0.125 }
)";

}  // namespace

void *const World::untouched = reinterpret_cast<void *>(uintptr_t(0xbad));

uint64_t hash_of(const void *bytes, size_t count)
{
    uint64_t hash = 0xcbf29ce484222325u;
    const auto *at = static_cast<const unsigned char *>(bytes);
    for (size_t i = 0; i < count; ++i) hash = (hash ^ at[i]) * 0x100000001b3u;
    return hash;
}

uint64_t hash_of(const std::string &text) { return hash_of(text.data(), text.size()); }

uint64_t bytes_of(const clq_template *tmpl)
{
    std::vector<unsigned char> all;
    EXPECT_EQ(clq_template_save(tmpl, append, &all), CLQ_OK) << clq_last_error();
    return hash_of(all.data(), all.size());
}

std::vector<unsigned char> read_bytes(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return std::vector<unsigned char>(std::istreambuf_iterator<char>(file), {});
}

std::string difference(const std::string &a, const std::string &b)
{
    if (a == b) return "";
    std::istringstream first(a), second(b);
    std::string x, y;
    while (std::getline(first, x) && std::getline(second, y))
        if (x != y) return "'" + x + "' and then '" + y + "'";
    return "another number of things";
}

World::World() : test(failing()), maker_(getpid())
{
    watched_gl::new_context();
    folder = testing::TempDir() + "claque-faults-" + std::to_string(getpid()) + "/";
    std::filesystem::create_directories(folder);
    make_crowds();
    record = recorded_run(test);
    make_assets();
    make_renderers();
}

World::~World()
{
    for (clq_renderer *renderer : {objects.renderer, fresh, without_shadows, close}) clq_renderer_destroy(renderer);
    clq_colour_map_destroy(objects.map);
    clq_template_destroy(person_template);
    for (clq_asset *asset : {person, twin, shapes, walk, painted}) clq_asset_destroy(asset);
    if (getpid() == maker_) std::filesystem::remove_all(folder);
}

clq_crowd *World::crowd_of(clq_cache_mode cache, uint32_t key_pose_bands, clq_view **out_view, bool updated)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = cache;
    def.key_poses.band_count = key_pose_bands;
    def.key_poses.bands[0] = {0, CLQ_KEY_POSE_INTERPOLATED};
    clq_crowd *crowd = test.new_crowd(&def);
    test.set_up(crowd);
    test.fill(crowd, 12, 9);
    *out_view = test.new_view(crowd, 0);
    if (updated) {
        EXPECT_EQ(clq_crowd_update(crowd, 1, out_view, 1), CLQ_OK) << clq_last_error();
    }
    return crowd;
}

// With the mechanisms that the calls name.
clq_actor World::add_actor()
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = test.templates[0];
    def.transform.position[2] = -2;
    def.play.clip = 0;
    clq_actor actor = {0, 0};
    EXPECT_EQ(clq_actor_create(objects.crowd, &def, &actor), CLQ_OK) << clq_last_error();
    for (uint32_t kind = 1; kind <= 4; ++kind) {
        const clq_mechanism_attachment attachment = {{kind}, 0, 0, 0};
        EXPECT_EQ(clq_actor_attach_mechanism(objects.crowd, actor, &attachment), CLQ_OK);
    }
    return actor;
}

// So that it has a layer and a gait.
void World::play_on(clq_actor actor)
{
    clq_layer_def def = clq_layer_def_init();
    def.play.clip = 0, def.loops = 99;
    EXPECT_EQ(clq_actor_add_layer(objects.crowd, actor, &def, &layer), CLQ_OK) << clq_last_error();
    clq_fade_def fade = clq_fade_def_init();
    fade.gait = {1}, fade.share = 0.3f;
    EXPECT_EQ(api_test::fade_to(objects.crowd, actor, fade, 0, 0.1f, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
}

void World::grow() { objects.actor = add_actor(); }

void World::make_crowds()
{
    objects.world = &test;
    objects.crowd = test.new_crowd();
    test.set_up(objects.crowd);
    saved_crowd = saved::save(objects.crowd);
    actors = test.fill(objects.crowd, 24, 5);
    objects.actor = add_actor();
    play_on(objects.actor);
    EXPECT_EQ(clq_group_create(objects.crowd, nullptr, &objects.group), CLQ_OK);
    const float centre[3] = {0, 0, 0};
    EXPECT_EQ(api_test::attach(objects.crowd, objects.actor, 0, centre, 1, &objects.attachment), CLQ_OK);
    objects.view = test.new_view(objects.crowd, 0);
    objects.scene = busy::new_scene(objects.crowd, objects.actor);
    EXPECT_EQ(clq_scene_set_categories(objects.scene, actors.data(), 9, 5), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_update(objects.crowd, 1, &objects.view, 1), CLQ_OK) << clq_last_error();
    bare = crowd_of(CLQ_CACHE_NONE, 0, &bare_view, true);
    key_posed = crowd_of(CLQ_CACHE_FULL, 1, &key_view, true);
    young = crowd_of(CLQ_CACHE_FULL, 1, &young_view, false);
}

void World::make_renderers()
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = watched_gl::find;
    for (clq_renderer **renderer : {&objects.renderer, &fresh, &without_shadows})
        EXPECT_EQ(clq_renderer_create(test.context, &def, renderer), CLQ_OK) << clq_last_error();
    def.close_texture_bytes = 1 << 20, def.close_distance_m = 1000;
    EXPECT_EQ(clq_renderer_create(test.context, &def, &close), CLQ_OK) << clq_last_error();
    for (clq_renderer *renderer : {objects.renderer, without_shadows, close})
        for (clq_template *tmpl : test.templates)
            EXPECT_EQ(clq_renderer_prepare(renderer, tmpl), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_asset_build(test.context, person, 0, &person_template), CLQ_OK) << clq_last_error();
}

void World::make_assets()
{
    person = load(test.context, "WrittenPerson.glb");
    shapes = load(test.context, "WrittenMorph.gltf");
    twin = load(test.context, "WrittenPerson.glb");
    walk = load(test.context, "WrittenClips.glb");
    painted = load(test.context, "WrittenRigid.glb");
    file = read_bytes(written::path_of("WrittenMorph.gltf", ""));
    std::ofstream(folder + "colours.toml") << colours;
    std::filesystem::copy_file(written::folder() + "Written Sparse.png", folder + "picture.png");
    toml.assign(colours, colours + std::char_traits<char>::length(colours));
    EXPECT_EQ(clq_colour_map_load(test.context, toml.data(), toml.size(), "colours", &objects.map), CLQ_OK)
        << clq_last_error();
    EXPECT_EQ(clq_template_save(test.templates[0], append, &saved_template), CLQ_OK) << clq_last_error();
    clq_asset_info info = clq_asset_info_init();
    EXPECT_EQ(clq_asset_get_info(person, &info), CLQ_OK);
    materials = info.material_count;
    clq_asset *other = load(test.context, "WrittenRigid.glb");
    while (zone_image < 8 && paint(other, zone_image) != CLQ_OK) ++zone_image;
    clq_asset_destroy(other);
}

clq_status World::paint(clq_asset *asset, uint32_t image) const
{
    const uint16_t texels[4] = {0, 0, 1, 1};
    const clq_zone_map_zone zones[2] = {{"upper", true, nullptr}, {"lower", false, nullptr}};
    clq_zone_map_def def = clq_zone_map_def_init();
    def.image = image, def.width_px = 2, def.height_px = 2;
    def.texels = texels, def.zone_count = 2, def.zones = zones;
    return clq_asset_set_zone_map(test.context, asset, &def);
}

}  // namespace faults
