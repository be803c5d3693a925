// Calls of libclaque-assets.
#include <filesystem>

#include "tests/api/failing_memory.h"
#include "tests/faults/calls.h"
#include "tests/support/written_characters.h"

namespace faults
{
namespace
{

using W = World &;

void note_asset(W w)
{
    auto *asset = static_cast<clq_asset *>(w.made);
    clq_asset_info info = clq_asset_info_init();
    EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK);
    w.found = info.vertex_count + 1000 * info.clip_count + 1000000 * info.warning_count;
    std::vector<float> positions(3 * size_t(info.vertex_count));
    if (info.vertex_count) {
        EXPECT_EQ(clq_asset_get_positions(asset, CLQ_NONE, 0, positions.data(), positions.size()), CLQ_OK);
        w.found ^= hash_of(positions.data(), positions.size() * sizeof(float));
    }
    clq_asset_destroy(asset);
}

void note_map(W w)
{
    auto *map = static_cast<clq_colour_map *>(w.made);
    clq_colour_map_def def = clq_colour_map_def_init();
    EXPECT_EQ(clq_colour_map_get_def(map, &def), CLQ_OK);
    w.found = hash_of(std::string(def.classes[0].name) + def.classes[0].zones[0].zone);
    clq_colour_map_destroy(map);
}

std::string path_of(const char *name)
{
    const failing_memory::Unarmed unarmed;
    return written::path_of(name, "");
}

clq_status load_named(W w, const char *name)
{
    return clq_asset_load_file(w.test.context, path_of(name).c_str(), nullptr, w.out<clq_asset>());
}

std::string in_folder(W w, const char *name)
{
    const failing_memory::Unarmed unarmed;
    return w.folder + name;
}

void add_asset_makers(std::vector<Call> &all)
{
    all.push_back(
        {"clq_asset_load",
         [](W w) { return clq_asset_load(w.test.context, w.file.data(), w.file.size(), nullptr, w.out<clq_asset>()); },
         0, note_asset});
    all.push_back({"clq_asset_load_file", [](W w) { return load_named(w, "WrittenMorph.gltf"); }, 0, note_asset});
    for (const char *name : {"WrittenPerson.glb", "WrittenSparse.gltf", "WrittenQuantised.glb", "WrittenSkins.glb",
                             "WrittenOdd.gltf", "WrittenWalk.bvh"})
        all.push_back({"clq_asset_load_file", [name](W w) { return load_named(w, name); }, 0, note_asset, name});
    all.push_back({"clq_asset_builtin",
                   [](W w) { return clq_asset_builtin(w.test.context, "citizen", w.out<clq_asset>()); }, 0,
                   note_asset});
    all.push_back({"clq_asset_builtin_varied",
                   [](W w) { return clq_asset_builtin_varied(w.test.context, "citizen", 24, w.out<clq_asset>()); }, 0,
                   note_asset});
    all.push_back({"clq_asset_build",
                   [](W w) { return clq_asset_build(w.test.context, w.shapes, 0, w.out<clq_template>()); }, inside,
                   note_template});
    all.push_back({"clq_asset_build",
                   [](W w) { return clq_asset_build(w.test.context, w.person, 8, w.out<clq_template>()); }, inside,
                   note_template, "person"});
    // From disk: what they do otherwise is in the calls above, in clq_asset_make_levels and in clq_template_prepare.
    const auto load_gltf = [](W w) {
        return clq_template_load_gltf(w.test.context, w.file.data(), w.file.size(), nullptr, w.out<clq_template>());
    };
    const auto builtin = [](W w) { return clq_template_builtin(w.test.context, "citizen", w.out<clq_template>()); };
    const auto prime_load = [load_gltf](W w) {
        if (load_gltf(w) == CLQ_OK) clq_template_destroy(static_cast<clq_template *>(w.made));
    };
    const auto prime_builtin = [builtin](W w) {
        if (builtin(w) == CLQ_OK) clq_template_destroy(static_cast<clq_template *>(w.made));
    };
    all.push_back({"clq_template_load_gltf", load_gltf, inside, note_template, "", prime_load});
    all.push_back({"clq_template_builtin", builtin, inside, note_template, "", prime_builtin});
    const auto prepare = [](W w, const char *name) {
        const std::string path = path_of("WrittenMorph.gltf"), folder = *name ? in_folder(w, name) : "";
        clq_prepare_def def = clq_prepare_def_init();
        def.path = path.c_str(), def.folder = folder.c_str();
        return clq_template_prepare(w.test.context, &def, w.out<clq_template>(), nullptr);
    };
    all.push_back({"clq_template_prepare", [prepare](W w) { return prepare(w, ""); }, inside, note_template});
    const auto prime = [prepare](W w) {
        if (prepare(w, "kept") == CLQ_OK) clq_template_destroy(static_cast<clq_template *>(w.made));
    };
    all.push_back({"clq_template_prepare", [prepare](W w) { return prepare(w, "kept"); }, inside, note_template,
                   "from disk", prime});
    const auto forget = [](W w) {
        std::filesystem::remove_all(in_folder(w, "new"));
        std::filesystem::create_directories(in_folder(w, "new"));
    };
    all.push_back({"clq_template_prepare", [prepare](W w) { return prepare(w, "new"); }, inside,
                   [forget](W w) {
                       note_template(w);
                       forget(w);
                   },
                   "to disk", forget});
}

void add_asset_changes(std::vector<Call> &all)
{
    all.push_back({"clq_asset_add_texture_set", [](W w) {
                       static uint8_t pixels[4 * 8 * 8];
                       clq_image_def images[8] = {};
                       images[0] = {"other", 8, 8, pixels, CLQ_ALPHA_OPACITY};
                       return clq_asset_add_texture_set(w.test.context, w.person, "other", images, w.materials);
                   }});
    all.push_back({"clq_asset_add_dofs", [](W w) {
                       clq_asset_dof dofs[2] = {clq_asset_dof_init(), clq_asset_dof_init()};
                       for (clq_asset_dof &dof : dofs) dof.node_name = "hips", dof.dof.axis[1] = 1;
                       dofs[0].dof.name = "a degree of freedom with a long name", dofs[1].dof.name = "another one";
                       return clq_asset_add_dofs(w.test.context, w.person, dofs, 2);
                   }});
    all.push_back({"clq_asset_add_clips",
                   [](W w) { return clq_asset_add_clips(w.test.context, w.person, w.walk, nullptr, nullptr); }});
    all.push_back({"clq_asset_add_clips",
                   [](W w) {
                       clq_clips_def def = clq_clips_def_init();
                       def.mode = CLQ_RETARGET_MOTION, def.prefix = "moved ";
                       return clq_asset_add_clips(w.test.context, w.person, w.walk, &def, nullptr);
                   },
                   0, nullptr, "by motion"});
    all.push_back({"clq_asset_add_clips",
                   [](W w) { return clq_asset_add_clips(w.test.context, w.person, w.twin, nullptr, nullptr); }, 0,
                   nullptr, "with warnings"});
    const auto make_levels = [](W w, clq_asset *asset) {
        const uint32_t targets[2] = {60, 20};
        clq_levels_def def = clq_levels_def_init();
        def.targets = targets, def.target_count = 2, def.proxy_max_triangles = 0;
        return clq_asset_make_levels(w.test.context, asset, &def, nullptr);
    };
    // OpenMesh makes its streams at their first use, and loses a block of its own where memory for them fails.
    const auto prime_levels = [make_levels](W w) {
        clq_asset *other = nullptr;
        EXPECT_EQ(clq_asset_load_file(w.test.context, path_of("WrittenPerson.glb").c_str(), nullptr, &other), CLQ_OK)
            << clq_last_error();
        EXPECT_EQ(make_levels(w, other), CLQ_OK) << clq_last_error();
        clq_asset_destroy(other);
    };
    all.push_back({"clq_asset_make_levels", [make_levels](W w) { return make_levels(w, w.person); }, 0, nullptr, "",
                   prime_levels});
    all.push_back({"clq_asset_set_zone_map", [](W w) { return w.paint(w.painted, w.zone_image); }});
}

void add_asset_questions(std::vector<Call> &all)
{
    all.push_back({"clq_asset_propose_zones", [](W w) {
                       static uint16_t texels[64 * 64];
                       uint8_t rgb[12];
                       clq_zone_proposal def = clq_zone_proposal_init();
                       def.max_zones = 4, def.texels = texels, def.capacity_texels = 64 * 64;
                       def.rgb = rgb;
                       const clq_status status = clq_asset_propose_zones(w.person, 0, &def);
                       w.found = status == CLQ_OK ? hash_of(texels, sizeof texels) : 0;
                       return status;
                   }});
    all.push_back({"clq_asset_get_positions", [](W w) {
                       static float positions[3 * 4096];
                       return clq_asset_get_positions(w.person, 0, 0.3f, positions, 3 * 4096);
                   }});
    all.push_back({"clq_asset_get_zone_areas", [](W w) {
                       float shares[64];
                       return clq_asset_get_zone_areas(w.person, 0, shares, 64, nullptr);
                   }});
    all.push_back({"clq_asset_get_info", [](W w) {
                       clq_asset_info info = clq_asset_info_init();
                       return clq_asset_get_info(w.person, &info);
                   }});
    all.push_back({"clq_asset_get_part", [](W w) {
                       clq_asset_part part = clq_asset_part_init();
                       return clq_asset_get_part(w.person, 0, &part);
                   }});
    all.push_back({"clq_asset_get_node",
                   [](W w) {
                       clq_asset_node node = clq_asset_node_init();
                       return clq_asset_get_node(w.person, 0, &node);
                   },
                   quiet});
    all.push_back({"clq_asset_get_clip",
                   [](W w) {
                       clq_clip_info clip = clq_clip_info_init();
                       return clq_asset_get_clip(w.person, 0, &clip);
                   },
                   quiet});
    all.push_back({"clq_asset_get_image",
                   [](W w) {
                       clq_asset_image image = clq_asset_image_init();
                       return clq_asset_get_image(w.person, 0, &image);
                   },
                   quiet});
    all.push_back({"clq_asset_get_level_report",
                   [](W w) {
                       clq_level_report report = clq_level_report_init();
                       clq_asset_get_level_report(w.person, 0, &report);
                       return CLQ_OK;  // no levels were made
                   },
                   inside});
    all.push_back({"clq_asset_get_warning",
                   [](W w) { return *clq_asset_get_warning(w.person, 99) ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_asset_get_morph_name",
                   [](W w) { return *clq_asset_get_morph_name(w.person, 0, 99) ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_asset_get_zone_name",
                   [](W w) { return *clq_asset_get_zone_name(w.person, 99) ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_asset_destroy",
                   [](W w) {
                       clq_asset_destroy(w.shapes);
                       w.shapes = nullptr;
                       return CLQ_OK;
                   },
                   quiet | ends});
}

void add_asset_files(std::vector<Call> &all)
{
    all.push_back({"clq_colour_map_load",
                   [](W w) {
                       return clq_colour_map_load(w.test.context, w.toml.data(), w.toml.size(), "colours",
                                                  w.out<clq_colour_map>());
                   },
                   0, note_map});
    all.push_back({"clq_colour_map_load_file",
                   [](W w) {
                       return clq_colour_map_load_file(w.test.context, in_folder(w, "colours.toml").c_str(),
                                                       w.out<clq_colour_map>());
                   },
                   0, note_map});
    all.push_back({"clq_colour_map_save", [](W w) {
                       w.found = 0;
                       const auto take = [](void *user, const void *bytes, size_t count) {
                           *static_cast<uint64_t *>(user) += hash_of(bytes, count);
                           return 0;
                       };
                       return clq_colour_map_save(w.objects.map, take, &w.found);
                   }});
    all.push_back({"clq_image_read", [](W w) {
                       clq_picture picture = clq_picture_init();
                       const std::string path = in_folder(w, "picture.png");
                       return clq_image_read(w.test.context, path.c_str(), &picture);
                   }});
}

}  // namespace

void add_asset_calls(std::vector<Call> &all)
{
    add_asset_makers(all), add_asset_changes(all), add_asset_questions(all), add_asset_files(all);
}

}  // namespace faults
