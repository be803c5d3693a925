// A scene: everything that a renderer with a matrix palette and shaders needs.
#include <algorithm>

#include "samples/parity/write/describe.h"
#include "samples/parity/write/gl_query.h"
#include "samples/parity/write/scene_glb.h"
#include "samples/scenes/check.h"

namespace parity
{

using scenes::check;

namespace
{

struct Poses {
    explicit Poses(const DrawnActors &drawn_actors)
        : palettes(12 * drawn_actors.palette_rows()), weights(drawn_actors.morph_weights())
    {
        std::vector<float> columns;
        for (const Individual &person : drawn_actors.individuals()) {
            columns.resize(12 * static_cast<size_t>(person.drawn_actors.joint_count));
            check(clq_view_get_palette(drawn_actors.view(), person.place, columns.data(),
                                       person.drawn_actors.joint_count));
            check(clq_view_get_morph_weights(drawn_actors.view(), person.place, weights.data() + person.first_weight,
                                             person.drawn_actors.morph_weight_count));
            float *rows = palettes.data() + 12 * static_cast<size_t>(person.first_palette);
            for (size_t joint = 0; joint < person.drawn_actors.joint_count; ++joint)
                for (size_t row = 0; row < 3; ++row)
                    for (size_t column = 0; column < 4; ++column)
                        rows[12 * joint + 4 * row + column] = columns[12 * joint + 3 * column + row];
        }
    }
    std::vector<float> palettes, weights;
};

// S2 2.2: a row for each individual, a column for each key.
void write_atlas(Folder &folder, const DrawnActors &drawn_actors)
{
    const size_t count = drawn_actors.individuals().size(), plates = (count + atlas_rows - 1) / atlas_rows;
    std::vector<uint8_t> atlas(plates * atlas_rows * atlas_columns * 3), rgb;
    for (size_t i = 0; i < count; ++i) {
        const Individual &person = drawn_actors.individuals()[i];
        rgb.resize(3 * static_cast<size_t>(person.drawn_actors.zone_count));
        check(clq_view_get_colours(drawn_actors.view(), person.place, rgb.data(), person.drawn_actors.zone_count));
        const size_t most = 3 * (atlas_columns - 1);  // textures cannot name zones beyond that
        std::copy_n(rgb.begin(), std::min(rgb.size(), most),
                    atlas.begin() + static_cast<std::ptrdiff_t>(3 * (i * atlas_columns + 1)));
    }
    folder.array("atlas.npy", atlas, {plates, atlas_rows, atlas_columns, 3});
}

}  // namespace

size_t write_scene(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time,
                   const std::string &folder_path)
{
    Folder folder(folder_path);
    scene_renderer.update(capture_time.time_s);
    scene_renderer.begin_picture();
    const DrawnActors drawn_actors(scene_renderer.view());
    const Skinned skinned(drawn_actors);
    const Poses poses(drawn_actors);
    write_individuals(folder, drawn_actors, skinned);
    write_atlas(folder, drawn_actors);
    folder.array("palettes.npy", poses.palettes, {drawn_actors.palette_rows(), 3, 4});
    folder.array("morph_weights.npy", poses.weights, {poses.weights.size()});
    const std::string glb = scene_glb(drawn_actors, poses.palettes, scene_renderer.eye().projection);
    folder.write("scene.glb", glb.data(), glb.size());

    Json json = described("scene", scene_renderer, capture_time, drawn_actors);
    json["palette_rows"] = drawn_actors.palette_rows();
    json["morph_weights"] = poses.weights.size();
    for (size_t i = 0; i < drawn_actors.meshes().size(); ++i) json["meshes"][i]["mesh"] = i;
    json["lighting"] = lighting_of(scene_renderer.offscreen());
    json["fog"] = fog_of(scene_renderer.offscreen());
    write_json(folder, json);
    folder.complete();
    return drawn_actors.individuals().size();
}

}  // namespace parity
